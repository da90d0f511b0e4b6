#include "registration/nearest_sample.h"

#include <limits>

namespace gnathion {

NearestSample::NearestSample(const SurfaceSample& sample, double reach) : sample_(sample) {
  const Eigen::Vector3d low = sample.points.colwise().minCoeff().transpose().array() - reach;
  const Eigen::Vector3d high = sample.points.colwise().maxCoeff().transpose().array() + reach;
  origin_ = low;
  size_ = ((high - low) / kCell).array().ceil().cast<int>() + 1;
  row_.assign(static_cast<std::size_t>(size_.x()) * static_cast<std::size_t>(size_.y()) *
                  static_cast<std::size_t>(size_.z()),
              -1);
  std::vector<float> distance(row_.size(), std::numeric_limits<float>::max());
  for (Eigen::Index i = 0; i < sample.size(); ++i) spread(static_cast<int>(i), reach, distance);
}

void NearestSample::spread(int row, double reach, std::vector<float>& distance) {
  const Eigen::Vector3d p = sample_.points.row(row);
  const Eigen::Array3i low = ((p - origin_).array() - reach)
                                 .max(0)
                                 .cwiseQuotient(Eigen::Array3d::Constant(kCell))
                                 .cast<int>();
  const Eigen::Array3i high = (((p - origin_).array() + reach) / kCell).cast<int>().min(size_ - 1);
  Eigen::Array3i cell;
  for (cell.z() = low.z(); cell.z() <= high.z(); ++cell.z()) {
    for (cell.y() = low.y(); cell.y() <= high.y(); ++cell.y()) {
      for (cell.x() = low.x(); cell.x() <= high.x(); ++cell.x()) {
        const Eigen::Vector3d middle = origin_ + kCell * (cell.cast<double>() + 0.5).matrix();
        const auto squared = static_cast<float>((middle - p).squaredNorm());
        const std::size_t i = index(cell);
        if (squared >= distance[i] || squared > static_cast<float>(reach * reach)) continue;
        distance[i] = squared;
        row_[i] = row;
      }
    }
  }
}

}  // namespace gnathion
