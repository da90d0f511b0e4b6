#include "tissue/untangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace gnathion {
namespace {

/// The tets at each node.
class Stars {
 public:
  Stars(const Tets& tets, Eigen::Index node_count) {
    start_.assign(static_cast<std::size_t>(node_count) + 1, 0);
    for (const int node : tets.reshaped()) ++start_[node + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    tets_.resize(static_cast<std::size_t>(tets.size()));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (int t = 0; t < tets.rows(); ++t) {
      for (const int node : tets.row(t)) tets_[next[node]++] = t;
    }
  }
  std::span<const int> operator[](int node) const {
    return {tets_.begin() + start_[node], tets_.begin() + start_[node + 1]};
  }

 private:
  std::vector<int> start_;
  std::vector<int> tets_;
};

double volume_of(const TetMesh& mesh, int t) {
  const Eigen::Vector3d a = mesh.vertices.row(mesh.tets(t, 0));
  const Eigen::Vector3d b = mesh.vertices.row(mesh.tets(t, 1)).transpose() - a;
  const Eigen::Vector3d c = mesh.vertices.row(mesh.tets(t, 2)).transpose() - a;
  const Eigen::Vector3d d = mesh.vertices.row(mesh.tets(t, 3)).transpose() - a;
  return b.cross(c).dot(d) / 6;
}

/// The shape of a tet, 6√2 V / s³ with s the root mean square of its edges (Parthasarathy 1994): 1
/// when regular, below 0 when inverted; and where one of its corners should go to make it better.
struct Shape {
  double quality = std::numeric_limits<double>::infinity();
  double size = 0;                                   ///< s, mm
  Eigen::Vector3d uphill = Eigen::Vector3d::Zero();  ///< unit
};

Shape shape_of(const TetMesh& mesh, int t, int node) {
  // The corners with the asked one first, turned so that the orientation stays.
  constexpr int kFirst[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  int corner = 0;
  while (mesh.tets(t, corner) != node) ++corner;
  std::array<Eigen::Vector3d, 4> x;
  for (int k = 0; k < 4; ++k) x[k] = mesh.vertices.row(mesh.tets(t, kFirst[corner][k]));
  const Eigen::Vector3d b = x[1] - x[0], c = x[2] - x[0], d = x[3] - x[0];
  const double six_volumes = b.cross(c).dot(d);
  const double mean_square =
      (b.squaredNorm() + c.squaredNorm() + d.squaredNorm() + (c - b).squaredNorm() +
       (d - c).squaredNorm() + (d - b).squaredNorm()) /
      6;
  const Eigen::Vector3d volume_uphill = -(b.cross(c) + c.cross(d) + d.cross(b));
  const Eigen::Vector3d mean_square_uphill = -(b + c + d) / 3;
  Shape shape;
  shape.size = std::sqrt(mean_square);
  shape.quality = std::sqrt(2.0) * six_volumes / (mean_square * shape.size);
  shape.uphill =
      (volume_uphill - 1.5 * six_volumes / mean_square * mean_square_uphill).stableNormalized();
  return shape;
}

Shape worst_of(const TetMesh& mesh, std::span<const int> tets, int node) {
  Shape worst;
  for (const int t : tets) {
    const Shape shape = shape_of(mesh, t, node);
    if (shape.quality < worst.quality) worst = shape;
  }
  return worst;
}

/// Moves one node so that the worst of its tets gets better.
void improve(std::span<const int> tets, int node, TetMesh& mesh) {
  constexpr int kSteps = 20;
  Shape worst = worst_of(mesh, tets, node);
  double step = worst.size / 2;
  for (int k = 0; k < kSteps; ++k) {
    const Eigen::RowVector3d before = mesh.vertices.row(node);
    mesh.vertices.row(node) += step * worst.uphill.transpose();
    const Shape now = worst_of(mesh, tets, node);
    if (now.quality > worst.quality) {
      worst = now;
    } else {
      mesh.vertices.row(node) = before;
      step /= 2;
    }
  }
}

void measure_depth(SoftTissueMesh& tissue) {
  const Points& x = tissue.mesh.vertices;
  tissue.depth =
      (x.middleRows(tissue.surface_count, tissue.surface_count) - x.topRows(tissue.surface_count))
          .rowwise()
          .norm();
}

}  // namespace

std::vector<int> untangle(const Eigen::VectorXd& least, int sweeps, SoftTissueMesh& tissue) {
  // Once a tet is mended it should not be the worst that is allowed.
  constexpr double kMended = 3;
  std::vector<bool> touched(static_cast<std::size_t>(tissue.mesh.vertices.rows()), false);
  std::vector<int> small;
  const auto find_nodes = [&] {
    std::vector<int> nodes;
    small.clear();
    for (int t = 0; t < tissue.mesh.tets.rows(); ++t) {
      const auto corners = tissue.mesh.tets.row(t);
      const bool near =
          std::any_of(corners.begin(), corners.end(), [&](int n) { return touched[n]; });
      const double volume = volume_of(tissue.mesh, t);
      if (volume <= least[t]) small.push_back(t);
      if (volume > (near ? kMended : 1) * least[t]) continue;
      for (const int node : corners) {
        if (node >= tissue.surface_count) nodes.push_back(node);
      }
    }
    // Centre points first: they are on no bone.
    std::sort(nodes.begin(), nodes.end(), std::greater<>());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  };
  std::vector<int> nodes = find_nodes();
  if (nodes.empty()) return small;
  const Stars stars(tissue.mesh.tets, tissue.mesh.vertices.rows());
  constexpr int kPolish = 8;  // sweeps for tets that are only not yet good
  for (int sweep = 0; !nodes.empty() && sweep < (small.empty() ? kPolish : sweeps); ++sweep) {
    for (const int node : nodes) {
      improve(stars[node], node, tissue.mesh);
      touched[node] = true;
    }
    nodes = find_nodes();
  }
  measure_depth(tissue);
  return small;
}

}  // namespace gnathion
