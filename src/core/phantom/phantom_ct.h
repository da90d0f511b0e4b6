#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/progress.h"
#include "phantom/head_model.h"
#include "phantom/head_phantom.h"

namespace gnathion {

/// A CT volume with axes along LPS; x fastest, then y, then z.
struct PhantomVolume {
  Eigen::Vector3i size;     ///< voxels along x, y, z
  Eigen::Vector3d origin;   ///< LPS mm, centre of the first voxel
  Eigen::Vector3d spacing;  ///< mm
  std::vector<std::int16_t> hounsfield;
};

/// The head in Hounsfield units, partial volume and noise included. Deterministic.
PhantomVolume make_phantom_volume(const HeadModel& head, const PhantomOptions& options,
                                  Progress& progress);

/// Writes one DICOM file a slice into `folder` (which exists). Errors: output.
void write_phantom_dicom(const PhantomVolume& volume, const std::filesystem::path& folder,
                         unsigned seed, Progress& progress);

}  // namespace gnathion
