#include "imaging/dicom_series.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "imaging/ct_import.h"
#include "support/expect_error.h"
#include "written_series.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

/// Every voxel's value must be the one that belongs to its place.
void expect_true_places(const CtVolume& volume, double tolerance = 0.51) {
  for (int k = 0; k < volume.dims().z(); ++k) {
    for (int j = 0; j < volume.dims().y(); ++j) {
      for (int i = 0; i < volume.dims().x(); ++i) {
        ASSERT_NEAR(volume.at(i, j, k), hu_at(volume.lps(Eigen::Vector3d(i, j, k))), tolerance)
            << i << ' ' << j << ' ' << k;
      }
    }
  }
}

CtVolume read(const fs::path& folder, Progress& progress) {
  return read_series(folder, std::nullopt, progress);
}

void expect_refusal(const fs::path& folder, const std::vector<std::string>& parts) {
  expect_error(ErrorKind::input, parts, [&] {
    Progress progress;
    read(folder, progress);
  });
}

struct Placement {
  const char* name;
  Eigen::Matrix3d rotation;
  Eigen::Vector3d step;  // in the slice's frame: row, column, normal
};

class DicomPlacement : public testing::TestWithParam<Placement> {};

TEST_P(DicomPlacement, EveryVoxelIsWhereItWasScanned) {
  const TemporaryFolder folder;
  WrittenSlice first;
  first.along_row = GetParam().rotation.col(0);
  first.along_column = GetParam().rotation.col(1);
  first.position = {-7, 3, 5};
  write_stack(folder.path(), stack(first, GetParam().rotation * GetParam().step, 6));
  Progress progress;
  const CtVolume volume = read(folder.path(), progress);
  EXPECT_EQ(volume.dims(), Eigen::Vector3i(12, 9, 6));
  EXPECT_NEAR(volume.steps().x(), 1.5, 1e-6);
  EXPECT_NEAR(volume.steps().y(), 2.5, 1e-6);
  EXPECT_NEAR(volume.steps().z(), GetParam().step.norm(), 1e-6);
  EXPECT_GT((volume.lps_from_ijk().topLeftCorner<3, 3>().determinant()), 0);
  expect_true_places(volume);
  EXPECT_TRUE(progress.notices().empty());
}

Eigen::Matrix3d turned(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix();
}

INSTANTIATE_TEST_SUITE_P(
    Orientations, DicomPlacement,
    testing::Values(Placement{"axial", Eigen::Matrix3d::Identity(), {0, 0, 2}},
                    Placement{"negative_step", Eigen::Matrix3d::Identity(), {0, 0, -2}},
                    Placement{"feet_first", turned(180, {0, 1, 0}), {0, 0, 2}},
                    Placement{"prone", turned(180, {0, 0, 1}), {0, 0, 2}},
                    Placement{"coronal", turned(90, {1, 0, 0}), {0, 0, 2}},
                    Placement{"oblique", turned(33, {1, 2, 3}), {0, 0, 1.25}}),
    [](const auto& placement) { return std::string(placement.param.name); });

TEST(DicomSeries, LeftOfThePatientStaysLeft) {
  const TemporaryFolder folder;
  WrittenSlice first;
  first.position = {-8, -10, 0};
  write_stack(folder.path(), stack(first, {0, 0, 2}, 4));
  Progress progress;
  const CtVolume volume = read(folder.path(), progress);
  EXPECT_LT(volume.sample({-6, 0, 3}), volume.sample({6, 0, 3}));  // +x is left, and brighter here
  EXPECT_NEAR(volume.sample({6, 1, 3}), hu_at({6, 1, 3}), 1);
}

TEST(DicomSeries, KeepsATiltedGantryAsShearAndSaysSo) {
  const TemporaryFolder folder;
  WrittenSlice first;
  first.along_column = Eigen::Vector3d(0, std::cos(0.2), std::sin(0.2));
  write_stack(folder.path(), stack(first, {0, 0, 2}, 5));
  Progress progress;
  const CtVolume volume = read(folder.path(), progress);
  expect_true_places(volume);
  ASSERT_EQ(progress.notices().size(), 1u);
  EXPECT_NE(progress.notices()[0].find("11.46 degrees"), std::string::npos)
      << progress.notices()[0];
}

TEST(DicomSeries, AppliesSlopeAndInterceptSliceBySlice) {
  const TemporaryFolder folder;
  auto slices = stack({}, {0, 0, 2}, 4);
  slices[1].slope = 0.5;
  slices[2].intercept = -2000;
  write_stack(folder.path(), slices);
  Progress progress;
  expect_true_places(read(folder.path(), progress), 0.76);
}

TEST(DicomSeries, ReadsCompressedSlices) {
  for (const auto syntax :
       {gdcm::TransferSyntax::JPEG2000Lossless, gdcm::TransferSyntax::RLELossless,
        gdcm::TransferSyntax::JPEGLSLossless, gdcm::TransferSyntax::JPEGLosslessProcess14_1}) {
    const TemporaryFolder folder;
    const auto slices = stack({}, {0, 0, 2}, 3);
    write_stack(folder.path(), slices);
    for (std::size_t k = 0; k < slices.size(); ++k) {
      const std::string file = file_of(folder.path(), k).string();
      gdcm::ImageReader reader;
      reader.SetFileName(file.c_str());
      ASSERT_TRUE(reader.Read());
      gdcm::ImageChangeTransferSyntax change;
      change.SetTransferSyntax(syntax);
      change.SetInput(reader.GetImage());
      ASSERT_TRUE(change.Change());
      gdcm::ImageWriter writer;
      writer.SetFile(reader.GetFile());
      writer.SetImage(change.GetOutput());
      writer.SetFileName(file.c_str());
      ASSERT_TRUE(writer.Write());
    }
    Progress progress;
    expect_true_places(read(folder.path(), progress));
  }
}

TEST(DicomSeries, NamesTheGapOfAMissingSlice) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, 2}, 6));
  fs::remove(file_of(folder.path(), 3));
  expect_refusal(folder.path(),
                 {"lacks 1 slice", "slice02.dcm", "slice04.dcm", "gap is 4 mm", "(0, 0, 6) mm"});
}

TEST(DicomSeries, NamesTheGapOfTwoMissingSlices) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, -1.5}, 7));
  fs::remove(file_of(folder.path(), 3));
  fs::remove(file_of(folder.path(), 4));
  expect_refusal(folder.path(), {"lacks 2 slice", "slice05.dcm and slice02.dcm"});
}

TEST(DicomSeries, RefusesUnevenSteps) {
  const TemporaryFolder folder;
  auto slices = stack({}, {0, 0, 2}, 6);
  for (std::size_t k = 4; k < 6; ++k) slices[k].position.z() += 1;
  write_stack(folder.path(), slices);
  expect_refusal(folder.path(), {"uneven steps", "3 mm", "slice03.dcm", "slice04.dcm"});
}

TEST(DicomSeries, RefusesASliceBesideTheLine) {
  const TemporaryFolder folder;
  auto slices = stack({}, {0, 0, 2}, 6);
  slices[2].position.x() += 3;
  write_stack(folder.path(), slices);
  expect_refusal(folder.path(), {"slice02.dcm", "beside the line"});
}

TEST(DicomSeries, AcceptsRoundedPositionsAndSaysSo) {
  const TemporaryFolder folder;
  auto slices = stack({}, {0, 0, 0.625}, 6);
  for (auto& slice : slices) slice.position.z() = std::round(slice.position.z() * 10) / 10;
  write_stack(folder.path(), slices);
  Progress progress;
  const CtVolume volume = read(folder.path(), progress);
  EXPECT_NEAR(volume.steps().z(), 0.62, 1e-3);
  ASSERT_EQ(progress.notices().size(), 1u);
  EXPECT_NE(progress.notices()[0].find("scatter"), std::string::npos);
}

TEST(DicomSeries, LeavesOutIdenticalCopies) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, 2}, 4));
  fs::copy_file(file_of(folder.path(), 1), folder.path() / "copy.dcm");
  Progress progress;
  const CtVolume volume = read(folder.path(), progress);
  EXPECT_EQ(volume.dims().z(), 4);
  expect_true_places(volume);
  ASSERT_EQ(progress.notices().size(), 1u);
  EXPECT_NE(progress.notices()[0].find("repeat"), std::string::npos);
}

TEST(DicomSeries, RefusesDifferentSlicesAtOnePlace) {
  const TemporaryFolder folder;
  auto slices = stack({}, {0, 0, 2}, 4);
  write_stack(folder.path(), slices);
  slices[1].slope = 2;  // other pixels…
  slices[1].intercept = -1500;
  write_slice(folder.path() / "other.dcm", slices[1]);
  Progress progress;
  // …whose HU round differently by up to one.
  expect_refusal(folder.path(), {"same plane", "slice01.dcm", "other.dcm"});
}

TEST(DicomSeries, ListsSeveralSeriesAndReadsTheChosenOne) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "a");
  fs::create_directories(folder.path() / "b");
  WrittenSlice other;
  other.series_uid = "1.2.3.4";
  other.description = "bone kernel";
  other.position = {50, 60, 20};
  write_stack(folder.path() / "a", stack({}, {0, 0, 2}, 4));
  write_stack(folder.path() / "b", stack(other, {0, 0, 3}, 5));
  std::ofstream(folder.path() / "notes.txt") << "no DICOM";
  expect_refusal(folder.path(), {"2 CT series", "1.2.3.4", "bone kernel", "5 files", "synthetic"});

  Progress progress;
  const auto list = list_series(folder.path(), progress);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].uid, "1.2.3.4");
  EXPECT_EQ(list[0].modality, "CT");
  EXPECT_EQ(list[0].description, "bone kernel");
  EXPECT_EQ(list[0].slices, 5);
  EXPECT_EQ(list[0].size, Eigen::Vector2i(12, 9));
  EXPECT_EQ(list[0].pixel_spacing, Eigen::Vector2d(1.5, 2.5));
  const CtVolume volume = read_ct(folder.path(), "1.2.3.4", progress);
  EXPECT_EQ(volume.dims().z(), 5);
  expect_true_places(volume);
  expect_error(ErrorKind::input, {"holds no series 9.9", "1.2.3.4"},
               [&] { read_series(folder.path(), "9.9", progress); });
}

TEST(DicomSeries, TheOnlyCtAmongOtherModalitiesNeedsNoUid) {
  const TemporaryFolder folder;
  WrittenSlice mr;
  mr.series_uid = "1.2.3.5";
  mr.modality = "MR";
  fs::create_directories(folder.path() / "mr");
  write_stack(folder.path() / "mr", stack(mr, {0, 0, 2}, 4));
  expect_refusal(folder.path(), {"holds no CT", "MR"});
  write_stack(folder.path(), stack({}, {0, 0, 2}, 4));
  Progress progress;
  expect_true_places(read(folder.path(), progress));
  expect_error(ErrorKind::input, {"is no CT", "MR"},
               [&] { read_series(folder.path(), "1.2.3.5", progress); });
}

TEST(DicomSeries, MessagesCarryNoPatientName) {
  const TemporaryFolder folder;
  WrittenSlice other;
  other.series_uid = "1.2.3.4";
  fs::create_directories(folder.path() / "b");
  write_stack(folder.path(), stack({}, {0, 0, 2}, 4));
  write_stack(folder.path() / "b", stack(other, {0, 0, 2}, 4));
  Progress progress;
  try {
    read(folder.path(), progress);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()).find("Secret"), std::string::npos) << error.what();
  }
}

TEST(DicomSeries, RefusesMissingAndEmptyFolders) {
  const TemporaryFolder folder;
  expect_refusal(folder.path(), {"holds no CT", "no DICOM file"});
  expect_refusal(folder.path() / "nowhere", {"nowhere", "does not exist"});
  std::ofstream(folder.path() / "notes.txt") << "no DICOM";
  expect_refusal(folder.path(), {"no DICOM file"});
  expect_refusal(folder.path() / "notes.txt", {"is no folder"});
  Progress progress;
  expect_error(ErrorKind::input, {"no readable DICOM"},
               [&] { list_series(folder.path(), progress); });
}

TEST(DicomSeries, NamesATruncatedFile) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, 2}, 4));
  const fs::path file = file_of(folder.path(), 2);
  const auto size = fs::file_size(file);
  fs::resize_file(file, size - 50);
  expect_refusal(folder.path(), {"slice02.dcm", "Premature end of file"});
  for (const std::uintmax_t left : {size - 230, size / 2, std::uintmax_t{200}, std::uintmax_t{0}}) {
    fs::resize_file(file, left);
    expect_refusal(folder.path(), {"slice02.dcm"});
  }
}

TEST(DicomSeries, NamesAFileWithFewerPixelsThanItStates) {
  const TemporaryFolder folder;
  auto slices = stack({}, {0, 0, 2}, 4);
  slices[2].pixels_left_out = 25;
  write_stack(folder.path(), slices);
  expect_refusal(folder.path(), {"slice02.dcm", "cut short", "166 of 216 bytes"});
}

TEST(DicomSeries, NamesATruncatedCompressedFile) {
  const TemporaryFolder folder;
  WrittenSlice first;
  first.columns = 64;
  first.rows = 64;
  first.spacing = {0.5, 0.5};
  write_stack(folder.path(), stack(first, {0, 0, 2}, 3));
  const std::string file = file_of(folder.path(), 1).string();
  {
    gdcm::ImageReader reader;
    reader.SetFileName(file.c_str());
    ASSERT_TRUE(reader.Read());
    gdcm::ImageChangeTransferSyntax change;
    change.SetTransferSyntax(gdcm::TransferSyntax::JPEGLSLossless);
    change.SetInput(reader.GetImage());
    ASSERT_TRUE(change.Change());
    gdcm::ImageWriter writer;
    writer.SetFile(reader.GetFile());
    writer.SetImage(change.GetOutput());
    writer.SetFileName(file.c_str());
    ASSERT_TRUE(writer.Write());
  }
  fs::resize_file(file, fs::file_size(file) - 300);
  expect_refusal(folder.path(), {"slice01.dcm"});
}

TEST(DicomSeries, NamesAFileThatOnlyPretends) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, 2}, 4));
  std::ofstream(folder.path() / "fake.dcm") << "this is text";
  expect_refusal(folder.path(), {"fake.dcm", "no DICOM file inside"});
}

TEST(DicomSeries, RefusesWhatIsNoStackOfSlices) {
  struct Case {
    const char* problem;
    void (*change)(WrittenSlice&);
  };
  const Case cases[] = {
      {"multi-frame", [](WrittenSlice& s) { s.frames = 3; }},
      {"colour", [](WrittenSlice& s) { s.samples = 3; }},
      {"RescaleSlope", [](WrittenSlice& s) { s.rescale = false; }},
      {"ImageOrientationPatient", [](WrittenSlice& s) { s.along_column = s.along_row; }},
      {"is turned",
       [](WrittenSlice& s) {
         s.along_row = {std::cos(0.1), std::sin(0.1), 0},
         s.along_column = {-std::sin(0.1), std::cos(0.1), 0};
       }},
      {"differs in size", [](WrittenSlice& s) { s.rows = 8; }},
      {"differs in size", [](WrittenSlice& s) { s.spacing.x() = 1.6; }},
  };
  for (const Case& c : cases) {
    const TemporaryFolder folder;
    auto slices = stack({}, {0, 0, 2}, 4);
    c.change(slices[2]);
    write_stack(folder.path(), slices);
    expect_refusal(folder.path(), {"slice02.dcm", c.problem});
  }
}

TEST(DicomSeries, RefusesASingleSlice) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, 2}, 1));
  expect_refusal(folder.path(), {"only slice"});
}

TEST(DicomSeries, StopsOnRequest) {
  const TemporaryFolder folder;
  write_stack(folder.path(), stack({}, {0, 0, 2}, 3));
  Progress progress;
  progress.cancel();
  expect_error(ErrorKind::cancelled, {}, [&] { read(folder.path(), progress); });
}

}  // namespace
}  // namespace gnathion::test
