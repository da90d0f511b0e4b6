#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "registration/surface_sample.h"

namespace gnathion {

/// Answers "which sample lies nearest to here" from a table, for many thousand rough questions a
/// millisecond: right to the cells' size, 4 mm.
class NearestSample {
 public:
  /// sample: mm, kept by reference. reach: mm.
  NearestSample(const SurfaceSample& sample, double reach);

  /// A row of the sample within about the reach, or −1.
  int at(const Eigen::Vector3d& p) const {
    const Eigen::Array3d place = (p - origin_).array() / kCell;
    if (!(place >= 0).all() || !(place < size_.cast<double>()).all()) return -1;
    return row_[index(place.cast<int>())];
  }
  const SurfaceSample& sample() const { return sample_; }

 private:
  static constexpr double kCell = 4;
  std::size_t index(const Eigen::Array3i& cell) const {
    return (static_cast<std::size_t>(cell.z()) * static_cast<std::size_t>(size_.y()) +
            static_cast<std::size_t>(cell.y())) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(cell.x());
  }
  void spread(int row, double reach, std::vector<float>& distance);

  const SurfaceSample& sample_;
  Eigen::Vector3d origin_;
  Eigen::Array3i size_;
  std::vector<int> row_;
};

}  // namespace gnathion
