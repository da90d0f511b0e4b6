#include "tissue/surface_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/bsp_tree.h"

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

/// Weights of a point in a triangle of the mesh that it lies in, those that rounding left below 0
/// being 0; the sum is 1.
Eigen::Vector3d weights_in(const TriangleMesh& mesh, int triangle, const Eigen::Vector3d& point) {
  const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(triangle, 0));
  const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(triangle, 1));
  const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(triangle, 2));
  const Eigen::Vector3d n = (b - a).cross(c - a);
  Eigen::Vector3d weights((c - b).cross(point - b).dot(n), (a - c).cross(point - c).dot(n),
                          (b - a).cross(point - a).dot(n));
  weights = weights.cwiseMax(0);
  if (!(weights.sum() > 0)) return {1, 0, 0};  // a triangle without area
  return weights / weights.sum();
}

/// The edges of the mesh's rim whose ends are both held.
std::vector<Edge> held_rim(const IntermediateMesh& region) {
  std::vector<Edge> held;
  for (const Edge& edge : region.edges) {
    if (edge.right == -1 && region.held[edge.a] && region.held[edge.b]) held.push_back(edge);
  }
  return held;
}

/// Weights of the nearest point on some edges.
void add_nearest_on(const std::vector<Edge>& edges, const Points& x,
                    const Eigen::RowVector3d& point, int row,
                    std::vector<Eigen::Triplet<double>>& entries) {
  double least = std::numeric_limits<double>::infinity(), part = 0;
  const Edge* nearest = nullptr;
  for (const Edge& edge : edges) {
    const Eigen::RowVector3d along = x.row(edge.b) - x.row(edge.a);
    const double squared = along.squaredNorm();
    const double t =
        squared > 0 ? std::clamp((point - x.row(edge.a)).dot(along) / squared, 0.0, 1.0) : 0;
    const double distance = (x.row(edge.a) + t * along - point).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    part = t;
    nearest = &edge;
  }
  if (part < 1) entries.emplace_back(row, nearest->a, 1 - part);
  if (part > 0) entries.emplace_back(row, nearest->b, part);
}

}  // namespace

SurfaceMap barycentric_map(const IntermediateMesh& dense, const IntermediateMesh& coarse,
                           const Points& face) {
  const Points& x = coarse.mesh.vertices;
  const BspTree tree(coarse.mesh);
  const std::vector<Edge> held = held_rim(coarse);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(3 * dense.face_vertex.size() + 6 * dense.enclosed.size());
  for (int i = 0; i < static_cast<int>(dense.face_vertex.size()); ++i) {
    const Eigen::RowVector3d point = dense.mesh.vertices.row(i);
    if (dense.held[i] && !held.empty()) {
      add_nearest_on(held, x, point, dense.face_vertex[i], entries);
      continue;
    }
    const auto nearest = tree.nearest(point.transpose(), std::numeric_limits<double>::infinity());
    const Eigen::Vector3d weights = weights_in(coarse.mesh, nearest->triangle, nearest->point);
    for (int corner = 0; corner < 3; ++corner) {
      if (weights[corner] == 0) continue;
      entries.emplace_back(dense.face_vertex[i], coarse.mesh.triangles(nearest->triangle, corner),
                           weights[corner]);
    }
  }
  for (const int v : dense.enclosed) add_nearest(coarse, face.row(v), v, entries);
  SurfaceMap W(face.rows(), x.rows());
  W.setFromTriplets(entries.begin(), entries.end());
  return W;
}

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
