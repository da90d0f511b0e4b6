#include "geometry/tet_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gnathion {
namespace {

using Corners = std::array<Eigen::Vector3d, 4>;

Corners corners_of(const TetMesh& mesh, Eigen::Index t) {
  return {mesh.vertices.row(mesh.tets(t, 0)), mesh.vertices.row(mesh.tets(t, 1)),
          mesh.vertices.row(mesh.tets(t, 2)), mesh.vertices.row(mesh.tets(t, 3))};
}

double volume(const Corners& x) {
  return (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6;
}

/// The faces opposite to each corner, normals outward for a positive tet, length twice the area.
std::array<Eigen::Vector3d, 4> face_normals(const Corners& x) {
  return {(x[2] - x[1]).cross(x[3] - x[1]), (x[3] - x[0]).cross(x[2] - x[0]),
          (x[1] - x[0]).cross(x[3] - x[0]), (x[2] - x[0]).cross(x[1] - x[0])};
}

}  // namespace

Eigen::VectorXd tet_volumes(const TetMesh& mesh) {
  Eigen::VectorXd volumes(mesh.tets.rows());
  for (Eigen::Index t = 0; t < volumes.size(); ++t) volumes[t] = volume(corners_of(mesh, t));
  return volumes;
}

TetQuality tet_quality(const TetMesh& mesh) {
  TetQuality q;
  q.count = mesh.tets.rows();
  if (q.count == 0) return q;
  q.smallest_volume = std::numeric_limits<double>::infinity();
  double largest_cosine = -1, smallest_cosine = 1;
  std::vector<double> aspects;
  aspects.reserve(static_cast<std::size_t>(q.count));
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const Corners x = corners_of(mesh, t);
    const double v = volume(x);
    q.inverted += v <= 0;
    q.total_volume += v;
    q.smallest_volume = std::min(q.smallest_volume, v);
    const auto n = face_normals(x);
    double longest = 0, largest_face = 0;
    for (int i = 0; i < 4; ++i) {
      largest_face = std::max(largest_face, n[i].norm() / 2);
      for (int j = i + 1; j < 4; ++j) {
        longest = std::max(longest, (x[i] - x[j]).norm());
        const double cosine = -n[i].stableNormalized().dot(n[j].stableNormalized());
        largest_cosine = std::max(largest_cosine, cosine);
        smallest_cosine = std::min(smallest_cosine, cosine);
      }
    }
    const double shortest_height = 3 * std::abs(v) / largest_face;
    aspects.push_back(std::sqrt(2.0 / 3.0) * longest / shortest_height);
  }
  const double degrees = 180 / std::numbers::pi;
  q.smallest_dihedral = std::acos(std::clamp(largest_cosine, -1.0, 1.0)) * degrees;
  q.largest_dihedral = std::acos(std::clamp(smallest_cosine, -1.0, 1.0)) * degrees;
  q.largest_aspect = *std::max_element(aspects.begin(), aspects.end());
  std::nth_element(aspects.begin(), aspects.begin() + q.count / 2, aspects.end());
  q.median_aspect = aspects[static_cast<std::size_t>(q.count / 2)];
  return q;
}

}  // namespace gnathion
