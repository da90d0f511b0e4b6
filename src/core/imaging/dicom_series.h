#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "imaging/ct_volume.h"

namespace gnathion {

/// What a user needs to choose a series by. Carries no patient identity.
struct SeriesSummary {
  std::string uid;                                          ///< SeriesInstanceUID
  std::string modality;                                     ///< "CT", "MR", …
  std::string description;                                  ///< SeriesDescription, may be empty
  int slices = 0;                                           ///< files of the series
  Eigen::Vector2i size = Eigen::Vector2i::Zero();           ///< columns, rows
  Eigen::Vector2d pixel_spacing = Eigen::Vector2d::Zero();  ///< mm, along a row, down the rows
};

/// The series of all DICOM files in the folder and its subfolders, sorted by UID. Other files are
/// passed over; a DICOM file that cannot be read is reported as a notice.
/// Throws Error(input) when the folder is missing, is no folder, or holds no DICOM file.
std::vector<SeriesSummary> list_series(const std::filesystem::path& folder, Progress& progress);

/// Reads one CT series. uid: which; needed only when the folder holds several CT series.
///
/// Geometry comes from ImagePositionPatient, ImageOrientationPatient and PixelSpacing alone; the
/// slices are sorted along their common normal, so k increases with it. HU = slope · stored +
/// intercept, slice by slice, rounded. A tilted gantry is kept as the affine's shear: nothing is
/// resampled, and a notice says the angle. Identical copies of a slice are dropped with a notice.
///
/// Throws Error(input): missing or empty folder; no CT; several CT series and no uid (the message
/// lists them); unknown uid; a file that is unreadable or cut short; a missing slice or uneven
/// steps (the message names the position and the files beside it); different slices at the same
/// place; slices of different size, spacing or orientation; multi-frame and colour files.
CtVolume read_series(const std::filesystem::path& folder, const std::optional<std::string>& uid,
                     Progress& progress);

}  // namespace gnathion
