#pragma once

#include "imaging/voxel_grid.h"

namespace gnathion {

/// Where the head is, and what merely holds it.
struct HeadMask {
  enum : std::uint8_t { air = 0, head = 1, support = 2 };
  VoxelGrid grid;
  Mask label;  ///< one of the above for each voxel of the grid

  /// The label of the nearest voxel; air outside the grid.
  std::uint8_t at(const Eigen::Vector3d& lps) const;
};

/// Labels everything of at least `hu`. Three kinds of support are told from the head:
/// - a couch: what runs through nearly all slices along z, is wider than deep and lies behind the
///   skull, and all that is behind its top or less than couch_blur (mm) before it;
/// - shells and straps: parts thinner than twice opening_radius (mm) that stand off by more than
///   28 mm or are wider than 90 mm (ears do neither);
/// - other bodies: of all bodies the one with the most bone is the head.
HeadMask find_head(const CtVolume& volume, double hu, double opening_radius, double couch_blur);

}  // namespace gnathion
