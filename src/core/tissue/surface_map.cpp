#include "tissue/surface_map.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace gnathion {

namespace {

/// Weights of the region's vertices nearest to a point, by inverse squared distance.
void add_nearest(const IntermediateMesh& region, const Eigen::RowVector3d& point, int row,
                 std::vector<Eigen::Triplet<double>>& entries) {
  constexpr std::size_t kNearest = 6;
  std::vector<std::pair<double, int>> nearest;
  for (int i = 0; i < region.mesh.vertices.rows(); ++i) {
    nearest.emplace_back((region.mesh.vertices.row(i) - point).squaredNorm(), i);
  }
  const std::size_t count = std::min(kNearest, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count),
                    nearest.end());
  nearest.resize(count);
  constexpr double kLeast = 1e-6;  // mm²: a vertex at the same place takes all the weight
  double sum = 0;
  for (const auto& [squared, i] : nearest) sum += 1 / (squared + kLeast);
  for (const auto& [squared, i] : nearest)
    entries.emplace_back(row, i, 1 / (squared + kLeast) / sum);
}

}  // namespace

SurfaceMap index_map(const IntermediateMesh& region, const Points& face) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(region.face_vertex.size() + 6 * region.enclosed.size());
  for (int i = 0; i < static_cast<int>(region.face_vertex.size()); ++i) {
    entries.emplace_back(region.face_vertex[i], i, 1.0);
  }
  for (const int v : region.enclosed) add_nearest(region, face.row(v), v, entries);
  SurfaceMap W(face.rows(), static_cast<Eigen::Index>(region.face_vertex.size()));
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

Eigen::MatrixXd compose(const SurfaceMap& W, const Eigen::MatrixXd& basis, std::vector<int>& rows) {
  rows.clear();
  for (int row = 0; row < W.rows(); ++row) {
    if (SurfaceMap::InnerIterator(W, row)) rows.push_back(row);
  }
  Eigen::MatrixXd composed =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(rows.size()), basis.cols());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (SurfaceMap::InnerIterator weight(W, rows[k]); weight; ++weight) {
      composed.middleRows<3>(3 * static_cast<Eigen::Index>(k)) +=
          weight.value() * basis.middleRows<3>(3 * weight.col());
    }
  }
  return composed;
}

}  // namespace gnathion
