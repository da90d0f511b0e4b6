#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Points sorted into cubic cells, for "all points within a cell's size of here".
class PointGrid {
 public:
  /// points: n×3, kept by reference while this lives; cell: the largest radius that is asked for,
  /// above 0, in the points' unit.
  PointGrid(const Points& points, double cell) : points_(points), cell_(cell) {
    cells_.reserve(static_cast<std::size_t>(points.rows()) / 4 + 1);
    next_.resize(static_cast<std::size_t>(points.rows()));
    for (Eigen::Index i = points.rows() - 1; i >= 0; --i) {
      const auto [place, is_new] = cells_.try_emplace(key(points.row(i)), static_cast<int>(i));
      next_[static_cast<std::size_t>(i)] = is_new ? -1 : place->second;
      place->second = static_cast<int>(i);
    }
  }

  /// Calls use(index) for every point within `radius` (at most the cell) of `centre`.
  template <typename Use>
  void for_each_within(const Eigen::Vector3d& centre, double radius, Use use) const {
    const Eigen::Vector3i middle = cell_of(centre);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto found = cells_.find(packed(middle + Eigen::Vector3i(dx, dy, dz)));
          if (found == cells_.end()) continue;
          for (int i = found->second; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
            if ((points_.row(i).transpose() - centre).squaredNorm() <= radius * radius) use(i);
          }
        }
      }
    }
  }

 private:
  Eigen::Vector3i cell_of(const Eigen::Vector3d& p) const {
    return (p / cell_).array().floor().cast<int>();
  }
  std::uint64_t key(const Eigen::Vector3d& p) const { return packed(cell_of(p)); }
  static std::uint64_t packed(const Eigen::Vector3i& c) {
    constexpr std::uint64_t kMask = (1U << 21) - 1;
    return ((static_cast<std::uint64_t>(c.x()) & kMask) << 42) |
           ((static_cast<std::uint64_t>(c.y()) & kMask) << 21) |
           (static_cast<std::uint64_t>(c.z()) & kMask);
  }

  const Points& points_;
  double cell_;
  std::unordered_map<std::uint64_t, int> cells_;  ///< the first point of each cell
  std::vector<int> next_;                         ///< the next point of the same cell, or −1
};

}  // namespace gnathion
