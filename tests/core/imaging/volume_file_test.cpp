#include "imaging/volume_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <functional>
#include <sstream>

#include "imaging/ct_import.h"
#include "support/expect_error.h"
#include "written_series.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

const Eigen::Vector3i dims(14, 11, 9);

/// A turned, anisotropic grid in LPS mm; columns are no axis of the patient.
Eigen::Matrix4d turned_grid() {
  Eigen::Affine3d place = Eigen::Translation3d(-11, 7, -9) *
                          Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()) *
                          Eigen::Scaling(3.0, 2.5, 4.0);
  return place.matrix();
}

template <typename Stored>
std::string voxels(const std::function<double(const Eigen::Vector3d&)>& value,
                   bool big_endian = false) {
  std::string bytes;
  const Eigen::Affine3d place(turned_grid());
  for (int k = 0; k < dims.z(); ++k) {
    for (int j = 0; j < dims.y(); ++j) {
      for (int i = 0; i < dims.x(); ++i) {
        const double v = value(place * Eigen::Vector3d(i, j, k));
        auto raw = std::bit_cast<std::array<char, sizeof(Stored)>>(
            std::is_integral_v<Stored> ? static_cast<Stored>(std::lround(v))
                                       : static_cast<Stored>(v));
        if (big_endian) std::reverse(raw.begin(), raw.end());
        bytes.append(raw.data(), raw.size());
      }
    }
  }
  return bytes;
}

std::string short_voxels() {
  return voxels<std::int16_t>(hu_at);
}

std::string packed(const std::string& bytes, bool gzip) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, gzip ? 31 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string out(bytes.size() + 200, '\0'), in = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

fs::path write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

std::string column(const Eigen::Matrix4d& m, int c, const char* separator) {
  std::ostringstream out;
  out.precision(17);
  out << m(0, c) << separator << m(1, c) << separator << m(2, c);
  return out.str();
}

std::string meta_header(const std::string& more, const std::string& data) {
  const Eigen::Matrix4d grid = turned_grid();
  Eigen::Matrix4d directions = grid;
  for (int c = 0; c < 3; ++c) directions.col(c).normalize();
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "TransformMatrix = " +
         column(directions, 0, " ") + " " + column(directions, 1, " ") + " " +
         column(directions, 2, " ") + "\nOffset = " + column(grid, 3, " ") +
         "\nElementSpacing = 3 2.5 4\nDimSize = 14 11 9\nElementType = MET_SHORT\n" + more +
         "ElementDataFile = " + data + "\n";
}

std::string nrrd_header(const std::string& space, const Eigen::Vector3d& signs,
                        const std::string& encoding) {
  const Eigen::Matrix4d grid =
      Eigen::Vector4d(signs.x(), signs.y(), signs.z(), 1).asDiagonal() * turned_grid();
  return "NRRD0005\n# by hand\ntype: short\ndimension: 3\nspace: " + space +
         "\nsizes: 14 11 9\nspace directions: (" + column(grid, 0, ",") + ") (" +
         column(grid, 1, ",") + ") (" + column(grid, 2, ",") +
         ")\nkinds: domain domain domain\nendian: little\nencoding: " + encoding +
         "\nspace origin: (" + column(grid, 3, ",") + ")\n";
}

/// The 352 bytes of a NIfTI-1 header, by hand.
class NiftiHeader {
 public:
  explicit NiftiHeader(bool big_endian = false) : big_endian_(big_endian) {
    put<std::int32_t>(0, 348);
    put<std::int16_t>(40, 3);
    for (int axis = 0; axis < 3; ++axis) {
      put(42 + 2 * static_cast<std::size_t>(axis), static_cast<std::int16_t>(dims[axis]));
    }
    put<std::int16_t>(70, 4);  // 16-bit signed
    put<std::int16_t>(72, 16);
    put<float>(76, 1);
    put<float>(108, 352);
    put<char>(123, 2);  // mm
    bytes_.replace(344, 3, "n+1");
  }
  template <typename T>
  void put(std::size_t at, T value) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (big_endian_) std::reverse(raw.begin(), raw.end());
    bytes_.replace(at, raw.size(), raw.data(), raw.size());
  }
  void put_sform(const Eigen::Matrix4d& ras) {
    put<std::int16_t>(254, 1);
    for (int row = 0; row < 3; ++row) {
      for (int c = 0; c < 4; ++c) {
        put(static_cast<std::size_t>(280 + 16 * row + 4 * c), static_cast<float>(ras(row, c)));
      }
    }
  }
  void put_qform(const Eigen::Matrix4d& ras) {
    Eigen::Matrix3d rotation = ras.topLeftCorner<3, 3>();
    const Eigen::Vector3d steps = rotation.colwise().norm();
    for (int c = 0; c < 3; ++c) rotation.col(c) /= steps[c];
    const bool flipped = rotation.determinant() < 0;
    if (flipped) rotation.col(2) *= -1;
    Eigen::Quaterniond q(rotation);
    if (q.w() < 0) q.coeffs() *= -1;
    put<std::int16_t>(252, 1);
    put<float>(76, flipped ? -1.0F : 1.0F);
    const std::array<double, 6> values = {q.x(), q.y(), q.z(), ras(0, 3), ras(1, 3), ras(2, 3)};
    for (std::size_t i = 0; i < 6; ++i) put(256 + 4 * i, static_cast<float>(values[i]));
    for (std::size_t i = 0; i < 3; ++i) {
      put(80 + 4 * i, static_cast<float>(steps[static_cast<Eigen::Index>(i)]));
    }
  }
  const std::string& bytes() const { return bytes_; }

 private:
  bool big_endian_;
  std::string bytes_ = std::string(352, '\0');
};

Eigen::Matrix4d ras_grid() {
  return Eigen::Vector4d(-1, -1, 1, 1).asDiagonal() * turned_grid();
}

CtVolume read(const fs::path& file) {
  Progress progress;
  return read_ct(file, std::nullopt, progress);
}

void expect_the_grid(const fs::path& file, double tolerance = 0.51) {
  const CtVolume volume = read(file);
  EXPECT_EQ(volume.dims(), dims);
  EXPECT_LT((volume.lps_from_ijk() - turned_grid()).cwiseAbs().maxCoeff(), 1e-5);
  for (int k = 0; k < dims.z(); ++k) {
    for (int j = 0; j < dims.y(); ++j) {
      for (int i = 0; i < dims.x(); ++i) {
        ASSERT_NEAR(volume.at(i, j, k), hu_at(volume.lps(Eigen::Vector3d(i, j, k))), tolerance);
      }
    }
  }
}

void expect_refusal(const fs::path& file, const std::vector<std::string>& parts) {
  expect_error(ErrorKind::input, parts, [&] { read(file); });
}

TEST(MetaImage, KeepsPlaceAndDirection) {
  const TemporaryFolder folder;
  expect_the_grid(write(folder.path() / "a.mha", meta_header("", "LOCAL") + short_voxels()));
  expect_the_grid(
      write(folder.path() / "packed.mha",
            meta_header("CompressedData = True\n", "LOCAL") + packed(short_voxels(), false)));
  write(folder.path() / "voxels.raw", short_voxels());
  expect_the_grid(write(folder.path() / "b.mhd", meta_header("", "voxels.raw")));
  write(folder.path() / "behind.raw", "header" + short_voxels());
  expect_the_grid(write(folder.path() / "c.mhd", meta_header("HeaderSize = -1\n", "behind.raw")));
}

TEST(MetaImage, ReadsOtherElementTypes) {
  const TemporaryFolder folder;
  const auto with_type = [](const std::string& type, bool big_endian) {
    return meta_header(std::string("BinaryDataByteOrderMSB = ") + (big_endian ? "True" : "False") +
                           "\nElementType = " + type + "\n",
                       "LOCAL");
  };
  expect_the_grid(
      write(folder.path() / "a.mha", with_type("MET_FLOAT", false) + voxels<float>(hu_at)));
  expect_the_grid(
      write(folder.path() / "b.mha", with_type("MET_DOUBLE", true) + voxels<double>(hu_at, true)));
  expect_the_grid(write(folder.path() / "c.mha",
                        with_type("MET_INT", true) + voxels<std::int32_t>(hu_at, true)));
}

TEST(Nrrd, KeepsPlaceAndDirectionInEverySpace) {
  const TemporaryFolder folder;
  expect_the_grid(
      write(folder.path() / "lps.nrrd",
            nrrd_header("left-posterior-superior", {1, 1, 1}, "raw") + "\n" + short_voxels()));
  expect_the_grid(write(folder.path() / "ras.nrrd",
                        nrrd_header("right-anterior-superior", {-1, -1, 1}, "gzip") + "\n" +
                            packed(short_voxels(), true)));
  expect_the_grid(write(folder.path() / "las.nrrd",
                        nrrd_header("LAS", {1, -1, 1}, "raw") + "\n" + short_voxels()));
  write(folder.path() / "voxels.raw", short_voxels());
  expect_the_grid(write(folder.path() / "detached.nhdr",
                        nrrd_header("LPS", {1, 1, 1}, "raw") + "data file: voxels.raw\n"));
}

TEST(Nifti, KeepsPlaceAndDirection) {
  const TemporaryFolder folder;
  NiftiHeader sform;
  sform.put_sform(ras_grid());
  expect_the_grid(write(folder.path() / "s.nii", sform.bytes() + short_voxels()));
  expect_the_grid(write(folder.path() / "s.nii.gz", packed(sform.bytes() + short_voxels(), true)));
  NiftiHeader qform;
  qform.put_qform(ras_grid());
  expect_the_grid(write(folder.path() / "q.nii", qform.bytes() + short_voxels()));
  NiftiHeader big(true);
  big.put_sform(ras_grid());
  expect_the_grid(
      write(folder.path() / "big.nii", big.bytes() + voxels<std::int16_t>(hu_at, true)));
}

TEST(Nifti, ReadsAFlippedQform) {
  const TemporaryFolder folder;
  Eigen::Matrix4d mirrored = ras_grid();
  mirrored.col(2) *= -1;
  NiftiHeader header;
  header.put_qform(mirrored);
  const CtVolume volume = read(write(folder.path() / "q.nii", header.bytes() + short_voxels()));
  const Eigen::Matrix4d expected = Eigen::Vector4d(-1, -1, 1, 1).asDiagonal() * mirrored;
  EXPECT_LT((volume.lps_from_ijk() - expected).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Nifti, AppliesItsSlope) {
  const TemporaryFolder folder;
  NiftiHeader header;
  header.put_sform(ras_grid());
  header.put<float>(112, 0.5F);
  header.put<float>(116, -1000.0F);
  expect_the_grid(write(folder.path() / "s.nii",
                        header.bytes() + voxels<std::int16_t>([](const Eigen::Vector3d& p) {
                          return 2 * (hu_at(p) + 1000);
                        })),
                  0.76);
}

TEST(Nifti, ConvertsDeclaredUnitsAndSaysWhenThereAreNone) {
  const TemporaryFolder folder;
  NiftiHeader metres;
  Eigen::Matrix4d grid = ras_grid();
  grid.topRows<3>() /= 1000;
  metres.put_sform(grid);
  metres.put<char>(123, 1);
  expect_the_grid(write(folder.path() / "m.nii", metres.bytes() + short_voxels()));
  NiftiHeader none;
  none.put_sform(ras_grid());
  none.put<char>(123, 0);
  Progress progress;
  read_volume_file(write(folder.path() / "n.nii", none.bytes() + short_voxels()), progress);
  ASSERT_EQ(progress.notices().size(), 1u);
  EXPECT_NE(progress.notices()[0].find("mm are assumed"), std::string::npos);
}

TEST(VolumeFile, RefusesWrongUnits) {
  const TemporaryFolder folder;
  NiftiHeader header;
  Eigen::Matrix4d grid = ras_grid();
  grid.topRows<3>() /= 1000;
  header.put_sform(grid);  // metres that claim to be mm
  expect_refusal(write(folder.path() / "m.nii", header.bytes() + short_voxels()),
                 {"m.nii", "not in mm"});
  expect_refusal(write(folder.path() / "u.mha",
                       meta_header("DistanceUnits = parsec\n", "LOCAL") + short_voxels()),
                 {"u.mha", "parsec"});
}

TEST(VolumeFile, RefusesValuesThatAreNoHounsfieldUnits) {
  const TemporaryFolder folder;
  const auto shifted = [](const Eigen::Vector3d& p) { return hu_at(p) + 1700; };
  expect_refusal(
      write(folder.path() / "a.mha", meta_header("", "LOCAL") + voxels<std::int16_t>(shifted)),
      {"a.mha", "no air"});
}

TEST(VolumeFile, CountsNotANumberAsAirAndSaysSo) {
  const TemporaryFolder folder;
  std::string bytes = voxels<float>(hu_at);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(bytes.data() + 40, &nan, 4);
  Progress progress;
  const CtVolume volume = read_volume_file(
      write(folder.path() / "a.mha", meta_header("ElementType = MET_FLOAT\n", "LOCAL") + bytes),
      progress);
  EXPECT_EQ(volume.at(10, 0, 0), -1024);
  ASSERT_EQ(progress.notices().size(), 1u);
  EXPECT_NE(progress.notices()[0].find("1 voxels are not a number"), std::string::npos);
}

TEST(VolumeFile, NamesWhatIsCutShort) {
  const TemporaryFolder folder;
  const std::string raw = short_voxels();
  const std::string less = raw.substr(0, raw.size() - 100);
  const std::string numbers = std::to_string(less.size()) + " of " + std::to_string(raw.size());
  NiftiHeader nifti;
  nifti.put_sform(ras_grid());
  expect_refusal(write(folder.path() / "a.mha", meta_header("", "LOCAL") + less),
                 {"a.mha", "cut short", numbers});
  write(folder.path() / "b.raw", less);
  expect_refusal(write(folder.path() / "b.mhd", meta_header("", "b.raw")), {"b.raw", numbers});
  expect_refusal(
      write(folder.path() / "c.nrrd", nrrd_header("LPS", {1, 1, 1}, "raw") + "\n" + less),
      {"c.nrrd", numbers});
  expect_refusal(write(folder.path() / "d.nii", nifti.bytes() + less), {"d.nii", numbers});
  expect_refusal(write(folder.path() / "e.nii", nifti.bytes().substr(0, 300)),
                 {"e.nii", "inside its header"});
  const std::string gz = packed(nifti.bytes() + raw, true);
  expect_refusal(write(folder.path() / "f.nii.gz", gz.substr(0, gz.size() / 2)),
                 {"f.nii.gz", "cut short"});
  std::string damaged = gz;
  for (std::size_t i = 600; i < 700; ++i) damaged[i] = static_cast<char>(~damaged[i]);
  expect_refusal(write(folder.path() / "g.nii.gz", damaged), {"g.nii.gz"});
  expect_refusal(write(folder.path() / "h.nii.gz", "no gzip at all"), {"h.nii.gz", "damaged"});
}

TEST(VolumeFile, ASmallFileCannotAskForAllMemory) {
  const TemporaryFolder folder;
  expect_refusal(
      write(folder.path() / "a.mha", meta_header("CompressedData = True\nDimSize = 65000 65000 "
                                                 "65000\n",
                                                 "LOCAL") +
                                         packed(short_voxels(), false)),
      {"a.mha", "cut short"});
}

TEST(VolumeFile, RefusesWhatIsNoVolumeOfThePatient) {
  const TemporaryFolder folder;
  const std::string raw = short_voxels();
  const auto nrrd = [&](const std::string& from, const std::string& to) {
    std::string header = nrrd_header("LPS", {1, 1, 1}, "raw") + "\n";
    header.replace(header.find(from), from.size(), to);
    return write(folder.path() / "a.nrrd", header + raw);
  };
  expect_refusal(nrrd("space: LPS", "space: scanner-xyz"), {"a.nrrd", "scanner-xyz", "left"});
  expect_refusal(nrrd("space: LPS\n", ""), {"a.nrrd", "space (none)"});
  expect_refusal(nrrd("dimension: 3", "dimension: 4"), {"dimension 4"});
  expect_refusal(nrrd("type: short", "type: block"), {"type block"});
  expect_refusal(nrrd("encoding: raw", "encoding: bzip2"), {"encoding bzip2"});
  expect_refusal(nrrd("sizes: 14 11 9", "sizes: 14 eleven 9"), {"\"sizes\"", "3 numbers"});
  expect_refusal(nrrd("sizes: 14 11 9", "sizes: 14 11 -9"), {"size along axis 2"});
  expect_refusal(write(folder.path() / "b.nii", NiftiHeader().bytes() + raw),
                 {"b.nii", "neither sform nor qform"});
  NiftiHeader four;
  four.put_sform(ras_grid());
  four.put<std::int16_t>(40, 4);
  four.put<std::int16_t>(48, 2);
  expect_refusal(write(folder.path() / "c.nii", four.bytes() + raw), {"not three-dimensional"});
  NiftiHeader rgb;
  rgb.put_sform(ras_grid());
  rgb.put<std::int16_t>(70, 128);
  expect_refusal(write(folder.path() / "d.nii", rgb.bytes() + raw), {"datatype 128"});
  expect_refusal(write(folder.path() / "e.mha", "this is text"), {"e.mha", "no MetaImage"});
  expect_refusal(write(folder.path() / "f.mha", meta_header("NDims = 2\n", "LOCAL") + raw),
                 {"three-dimensional"});
  expect_refusal(
      write(folder.path() / "g.mha", meta_header("ElementType = MET_ASCII_CHAR\n", "LOCAL") + raw),
      {"MET_ASCII_CHAR"});
  expect_refusal(write(folder.path() / "h.mhd", meta_header("", "gone.raw")), {"gone.raw"});
  expect_refusal(write(folder.path() / "i.nii", std::string(400, 'x')), {"no single-file NIfTI"});
}

TEST(VolumeFile, RefusesUnknownFilesAndAUidForAFile) {
  const TemporaryFolder folder;
  expect_refusal(write(folder.path() / "a.jpg", "x"), {"a.jpg", "no known volume format"});
  expect_refusal(folder.path() / "nowhere.nrrd", {"nowhere.nrrd", "does not exist"});
  Progress progress;
  const fs::path file = write(folder.path() / "a.mha", meta_header("", "LOCAL") + short_voxels());
  expect_error(ErrorKind::input, {"series UID"}, [&] { read_ct(file, "1.2.3", progress); });
}

}  // namespace
}  // namespace gnathion::test
