#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"

namespace gnathion {

/// The header of one DICOM file, as far as a CT needs it. No patient identity is kept.
struct DicomHeader {
  std::filesystem::path path;
  std::string series_uid;
  std::string modality;
  std::string description;
  int columns = 0;
  int rows = 0;
  int frames = 1;
  int samples_per_pixel = 0;  ///< 0: the object is no image
  int bits_allocated = 0;
  bool is_signed = false;
  bool has_position = false;  ///< ImagePositionPatient and ImageOrientationPatient are there
  bool has_spacing = false;
  bool has_rescale = false;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();      ///< centre of the first pixel, LPS mm
  Eigen::Vector3d along_row = Eigen::Vector3d::Zero();     ///< unit, the way columns count
  Eigen::Vector3d along_column = Eigen::Vector3d::Zero();  ///< unit, the way rows count
  Eigen::Vector2d spacing = Eigen::Vector2d::Zero();       ///< mm, between columns, between rows
  double slope = 1;
  double intercept = 0;
};

struct UnreadableFile {
  std::filesystem::path path;
  std::string problem;
};

struct DicomScan {
  std::vector<DicomHeader> headers;        ///< sorted by path
  std::vector<UnreadableFile> unreadable;  ///< look like DICOM, but are broken or cut short
};

/// Reads the headers of all DICOM files in the folder and its subfolders.
/// Throws Error(input) when the folder is missing, is no folder or cannot be entered.
DicomScan scan_folder(const std::filesystem::path& folder, Progress& progress);

}  // namespace gnathion
