#include "tissue/surface_map.h"

namespace gnathion {

SurfaceMap index_map(const IntermediateMesh& region, Eigen::Index face_vertex_count) {
  std::vector<Eigen::Triplet<double>> ones;
  ones.reserve(region.face_vertex.size());
  for (int i = 0; i < static_cast<int>(region.face_vertex.size()); ++i) {
    ones.emplace_back(region.face_vertex[i], i, 1.0);
  }
  SurfaceMap W(face_vertex_count, static_cast<Eigen::Index>(region.face_vertex.size()));
  W.setFromTriplets(ones.begin(), ones.end());
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
