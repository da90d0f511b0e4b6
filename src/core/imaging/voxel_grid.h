#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "imaging/ct_volume.h"

namespace gnathion {

/// A cubic grid parallel to the LPS axes, on which masks are worked out.
struct VoxelGrid {
  Eigen::Vector3i dims = Eigen::Vector3i::Zero();
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< LPS mm, centre of the first voxel
  double step = 1;                                   ///< mm

  std::size_t size() const { return static_cast<std::size_t>(dims.x()) * dims.y() * dims.z(); }
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * dims.y() + y) * dims.x() + x;
  }
  Eigen::Vector3i at(std::size_t index) const;
  Eigen::Vector3d lps(const Eigen::Vector3d& xyz) const { return origin + step * xyz; }
};

/// One flag or label a voxel.
using Mask = std::vector<std::uint8_t>;

/// The grid that covers the box (LPS mm) with `margin` voxels to spare on each side.
VoxelGrid grid_over(const LpsBox& box, double step, int margin);

/// The LPS box around all voxel centres of the volume.
LpsBox bounds_of(const CtVolume& volume);

/// HU at the grid's points, trilinear; `outside` beyond the volume.
std::vector<float> resampled(const CtVolume& volume, const VoxelGrid& grid, float outside);

/// For each voxel the squared distance (in voxels) to the nearest set voxel of `mask`, at most
/// (radius + 1)²; radius up to 14 voxels.
Mask squared_distances(const Mask& mask, const VoxelGrid& grid, int radius);

/// The voxels with mask == from that are joined to a seed through faces become `to`; returns them.
/// Seeds that are not `from` are passed over.
std::vector<std::size_t> flood(Mask& mask, const VoxelGrid& grid, std::uint8_t from,
                               std::uint8_t to, const std::vector<std::size_t>& seeds);

}  // namespace gnathion
