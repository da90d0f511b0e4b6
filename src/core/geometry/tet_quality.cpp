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

constexpr double kDegrees = 180 / std::numbers::pi;

/// The edge between the faces opposite to corners i and j is that of the other two corners.
constexpr std::array<std::array<int, 2>, 6> kFacesOfEdge{
    {{2, 3}, {1, 3}, {1, 2}, {0, 3}, {0, 2}, {0, 1}}};

/// Cosines of the dihedral angles, in the order of dihedral_angles().
std::array<double, 6> dihedral_cosines(const std::array<Eigen::Vector3d, 4>& normals) {
  std::array<Eigen::Vector3d, 4> unit;
  for (std::size_t i = 0; i < 4; ++i) unit[i] = normals[i].stableNormalized();
  std::array<double, 6> cosines{};
  for (std::size_t e = 0; e < 6; ++e) {
    cosines[e] = std::clamp(-unit[kFacesOfEdge[e][0]].dot(unit[kFacesOfEdge[e][1]]), -1.0, 1.0);
  }
  return cosines;
}

double aspect(const Corners& x, const std::array<Eigen::Vector3d, 4>& normals) {
  double longest = 0, largest_face = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    largest_face = std::max(largest_face, normals[i].norm() / 2);
    for (std::size_t j = i + 1; j < 4; ++j) longest = std::max(longest, (x[i] - x[j]).norm());
  }
  const double shortest_height = 3 * std::abs(volume(x)) / largest_face;
  return std::sqrt(2.0 / 3.0) * longest / shortest_height;
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
    const auto normals = face_normals(x);
    const auto cosines = dihedral_cosines(normals);
    const auto [least, most] = std::minmax_element(cosines.begin(), cosines.end());
    smallest_cosine = std::min(smallest_cosine, *least);
    largest_cosine = std::max(largest_cosine, *most);
    aspects.push_back(aspect(x, normals));
  }
  q.smallest_dihedral = std::acos(largest_cosine) * kDegrees;
  q.largest_dihedral = std::acos(smallest_cosine) * kDegrees;
  q.largest_aspect = *std::max_element(aspects.begin(), aspects.end());
  std::nth_element(aspects.begin(), aspects.begin() + q.count / 2, aspects.end());
  q.median_aspect = aspects[static_cast<std::size_t>(q.count / 2)];
  return q;
}

Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> dihedral_angles(const TetMesh& mesh) {
  Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> angles(mesh.tets.rows(), 6);
  for (Eigen::Index t = 0; t < angles.rows(); ++t) {
    const auto cosines = dihedral_cosines(face_normals(corners_of(mesh, t)));
    for (int e = 0; e < 6; ++e) angles(t, e) = std::acos(cosines[e]) * kDegrees;
  }
  return angles;
}

Eigen::Matrix<double, Eigen::Dynamic, 12, Eigen::RowMajor> face_angles(const TetMesh& mesh) {
  Eigen::Matrix<double, Eigen::Dynamic, 12, Eigen::RowMajor> angles(mesh.tets.rows(), 12);
  for (Eigen::Index t = 0; t < angles.rows(); ++t) {
    const Corners x = corners_of(mesh, t);
    int column = 0;
    for (int opposite = 0; opposite < 4; ++opposite) {
      for (int corner = 0; corner < 4; ++corner) {
        if (corner == opposite) continue;
        // The two corners that are neither: the remaining ones of the four.
        int p = 0;
        while (p == opposite || p == corner) ++p;
        const int q = 6 - opposite - corner - p;
        const Eigen::Vector3d to_p = x[p] - x[corner], to_q = x[q] - x[corner];
        angles(t, column++) = std::atan2(to_p.cross(to_q).norm(), to_p.dot(to_q)) * kDegrees;
      }
    }
  }
  return angles;
}

Eigen::VectorXd aspect_ratios(const TetMesh& mesh) {
  Eigen::VectorXd ratios(mesh.tets.rows());
  for (Eigen::Index t = 0; t < ratios.size(); ++t) {
    const Corners x = corners_of(mesh, t);
    ratios[t] = aspect(x, face_normals(x));
  }
  return ratios;
}

}  // namespace gnathion
