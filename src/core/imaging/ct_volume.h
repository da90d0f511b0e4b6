#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace gnathion {

/// A CT volume: Hounsfield units on a grid, and where the grid lies in the patient.
///
/// Frames: ijk are voxel indices (voxel centres at whole numbers, i along a row, j down the rows,
/// k from slice to slice); LPS is DICOM's patient frame in mm (+x left, +y posterior, +z superior).
/// lps_from_ijk is a general affine: spacing, direction, and the shear of a tilted gantry; its
/// determinant may be negative. Immutable; copies share the voxels.
class CtVolume {
 public:
  /// dims: voxels along i, j, k, each at least 2. hu: i fastest, then j, then k; fractions of a
  /// Hounsfield unit are rounded to the nearest whole one by whoever reads them (CT noise is ten
  /// times larger). source: the file or folder, for messages.
  /// Throws Error(input) when sizes disagree or the affine is not finite and invertible.
  CtVolume(Eigen::Vector3i dims, std::vector<std::int16_t> hu, const Eigen::Matrix4d& lps_from_ijk,
           std::string source);

  const Eigen::Vector3i& dims() const { return dims_; }
  const std::vector<std::int16_t>& hu() const { return *hu_; }
  const Eigen::Matrix4d& lps_from_ijk() const { return lps_from_ijk_; }
  const Eigen::Matrix4d& ijk_from_lps() const { return ijk_from_lps_; }
  const std::string& source() const { return source_; }

  /// The value of one voxel; the indices must be inside.
  std::int16_t at(int i, int j, int k) const { return (*hu_)[index(i, j, k)]; }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * dims_.y() + j) * dims_.x() + i;
  }

  /// Steps between neighbouring voxels along i, j, k, mm.
  Eigen::Vector3d steps() const;

  Eigen::Vector3d lps(const Eigen::Vector3d& ijk) const;
  Eigen::Vector3d ijk(const Eigen::Vector3d& lps) const;

  /// HU at an LPS point (mm), trilinear between voxel centres; `outside` beyond the grid.
  double sample(const Eigen::Vector3d& lps, double outside = -1024) const;

 private:
  Eigen::Vector3i dims_;
  std::shared_ptr<const std::vector<std::int16_t>> hu_;
  Eigen::Matrix4d lps_from_ijk_;
  Eigen::Matrix4d ijk_from_lps_;
  std::string source_;
};

/// An axis-parallel box in LPS, mm.
struct LpsBox {
  Eigen::Vector3d min;
  Eigen::Vector3d max;

  bool operator==(const LpsBox&) const = default;
};

/// The smallest grid of whole voxels that holds the box, with its own lps_from_ijk: no value and
/// no place changes. Throws Error(input) when the box misses the volume.
CtVolume cropped(const CtVolume& volume, const LpsBox& box);

}  // namespace gnathion
