#pragma once

#include <gdcmAttribute.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gnathion::test {

/// A new empty folder, removed at the end of the test. Its name has a space and an accent.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("gnathion é ") + info->test_suite_name() + info->name();
    for (char& c : name) c = c == '/' ? '_' : c;
    path_ = std::filesystem::temp_directory_path() / name;
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// HU that tell the place: linear in LPS, so that any exchange of axes or signs shows.
inline double hu_at(const Eigen::Vector3d& lps) {
  return -600 + 2 * lps.x() + 5 * lps.y() + 11 * lps.z();
}

/// One slice as it is written; the defaults make a valid axial CT slice.
struct WrittenSlice {
  std::string series_uid = "1.2.826.0.1.3680043.10.1.1";
  std::string modality = "CT";
  std::string description = "synthetic";
  int columns = 12;
  int rows = 9;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d along_row = Eigen::Vector3d::UnitX();
  Eigen::Vector3d along_column = Eigen::Vector3d::UnitY();
  Eigen::Vector2d spacing = {1.5, 2.5};  ///< between columns, between rows
  double slope = 1;
  double intercept = -1024;
  bool rescale = true;
  int frames = 1;
  int samples = 1;
  int pixels_left_out = 0;  ///< at the end, though rows and columns promise them

  Eigen::Vector3d lps(int i, int j) const {
    return position + i * spacing.x() * along_row + j * spacing.y() * along_column;
  }
  std::uint16_t stored(int i, int j) const {
    return static_cast<std::uint16_t>(std::lround((hu_at(lps(i, j)) - intercept) / slope));
  }
};

template <std::uint16_t group, std::uint16_t element, typename Value>
void put(gdcm::DataSet& data, const Value& value) {
  gdcm::Attribute<group, element> attribute;
  attribute.SetValue(value);
  data.Replace(attribute.GetAsDataElement());
}

template <std::uint16_t group, std::uint16_t element>
void put_numbers(gdcm::DataSet& data, const std::vector<double>& values) {
  gdcm::Attribute<group, element> attribute;
  for (std::size_t i = 0; i < values.size(); ++i) {
    attribute.SetValue(values[i], static_cast<unsigned int>(i));
  }
  data.Replace(attribute.GetAsDataElement());
}

inline void write_slice(const std::filesystem::path& file, const WrittenSlice& slice) {
  gdcm::Writer writer;
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  gdcm::UIDGenerator uids;
  put<0x0008, 0x0016>(data, gdcm::UIComp("1.2.840.10008.5.1.4.1.1.2"));
  put<0x0008, 0x0018>(data, gdcm::UIComp(uids.Generate()));
  put<0x0008, 0x0060>(data, gdcm::CSComp(slice.modality));
  put<0x0008, 0x103e>(data, gdcm::LOComp(slice.description));
  put<0x0010, 0x0010>(data, gdcm::PNComp("Secret^Name"));
  put<0x0020, 0x000d>(data, gdcm::UIComp("1.2.826.0.1.3680043.10.1"));
  put<0x0020, 0x000e>(data, gdcm::UIComp(slice.series_uid));
  const Eigen::Vector3d &p = slice.position, &r = slice.along_row, &c = slice.along_column;
  put_numbers<0x0020, 0x0032>(data, {p.x(), p.y(), p.z()});
  put_numbers<0x0020, 0x0037>(data, {r.x(), r.y(), r.z(), c.x(), c.y(), c.z()});
  put_numbers<0x0028, 0x0030>(data, {slice.spacing.y(), slice.spacing.x()});
  put<0x0028, 0x0002>(data, static_cast<std::uint16_t>(slice.samples));
  put<0x0028, 0x0004>(data, gdcm::CSComp(slice.samples == 1 ? "MONOCHROME2" : "RGB"));
  if (slice.frames > 1) put<0x0028, 0x0008>(data, slice.frames);
  put<0x0028, 0x0010>(data, static_cast<std::uint16_t>(slice.rows));
  put<0x0028, 0x0011>(data, static_cast<std::uint16_t>(slice.columns));
  put<0x0028, 0x0100>(data, std::uint16_t{16});
  put<0x0028, 0x0101>(data, std::uint16_t{16});
  put<0x0028, 0x0102>(data, std::uint16_t{15});
  put<0x0028, 0x0103>(data, std::uint16_t{0});
  // What geometry must not be taken from: wrong on purpose.
  put<0x0018, 0x0050>(data, 17.0);
  put<0x0018, 0x0088>(data, 19.0);
  if (slice.rescale) {
    put<0x0028, 0x1052>(data, slice.intercept);
    put<0x0028, 0x1053>(data, slice.slope);
  }
  std::vector<std::uint16_t> pixels;
  for (int frame = 0; frame < slice.frames * slice.samples; ++frame) {
    for (int j = 0; j < slice.rows; ++j) {
      for (int i = 0; i < slice.columns; ++i) pixels.push_back(slice.stored(i, j));
    }
  }
  pixels.resize(pixels.size() - static_cast<std::size_t>(slice.pixels_left_out));
  std::string bytes(2 * pixels.size(), '\0');
  std::memcpy(bytes.data(), pixels.data(), bytes.size());
  gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010));
  element.SetVR(gdcm::VR::OW);
  element.SetByteValue(bytes.data(), gdcm::VL(static_cast<std::uint32_t>(bytes.size())));
  data.Replace(element);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(
      gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetFileName(file.string().c_str());
  ASSERT_TRUE(writer.Write()) << file;
}

/// Slices at first.position + k·step, written as slice00.dcm, slice01.dcm, …
inline std::vector<WrittenSlice> stack(const WrittenSlice& first, const Eigen::Vector3d& step,
                                       int count) {
  std::vector<WrittenSlice> slices(static_cast<std::size_t>(count), first);
  for (int k = 0; k < count; ++k) slices[static_cast<std::size_t>(k)].position += k * step;
  return slices;
}

inline std::filesystem::path file_of(const std::filesystem::path& folder, std::size_t k) {
  return folder / ("slice" + std::to_string(k / 10) + std::to_string(k % 10) + ".dcm");
}

inline void write_stack(const std::filesystem::path& folder,
                        const std::vector<WrittenSlice>& slices) {
  for (std::size_t k = 0; k < slices.size(); ++k) write_slice(file_of(folder, k), slices[k]);
}

}  // namespace gnathion::test
