#pragma once

#include <Eigen/Geometry>
#include <map>
#include <utility>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion::test {

/// Two surfaces as one, the vertices of the first before those of the second.
inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both{Points(a.vertices.rows() + b.vertices.rows(), 3),
                    Triangles(a.triangles.rows() + b.triangles.rows(), 3)};
  both.vertices << a.vertices, b.vertices;
  both.triangles << a.triangles, b.triangles.array() + static_cast<int>(a.vertices.rows());
  return both;
}

/// A closed, outward surface: a cube's faces, each of n×n squares, pushed out to a box of these
/// half extents.
inline TriangleMesh box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half, int n) {
  std::vector<Eigen::RowVector3d> points;
  std::map<std::array<int, 3>, int> known;
  std::vector<Eigen::RowVector3i> triangles;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [place, is_new] = known.try_emplace(at, static_cast<int>(points.size()));
    if (is_new) {
      Eigen::Vector3d unit;
      for (int k = 0; k < 3; ++k) unit[k] = 2.0 * at[static_cast<std::size_t>(k)] / n - 1;
      points.emplace_back((centre + half.cwiseProduct(unit)).transpose());
    }
    return place->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int di, int dj) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            return vertex(at);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side == n) {
            triangles.emplace_back(a, b, c);
            triangles.emplace_back(a, c, d);
          } else {
            triangles.emplace_back(a, c, b);
            triangles.emplace_back(a, d, c);
          }
        }
      }
    }
  }
  TriangleMesh mesh{Points(points.size(), 3), Triangles(triangles.size(), 3)};
  for (std::size_t v = 0; v < points.size(); ++v)
    mesh.vertices.row(static_cast<Eigen::Index>(v)) = points[v];
  for (std::size_t f = 0; f < triangles.size(); ++f)
    mesh.triangles.row(static_cast<Eigen::Index>(f)) = triangles[f];
  return mesh;
}

/// A closed, outward sphere from a cube of 2^fineness squares along each edge.
inline TriangleMesh sphere(const Eigen::Vector3d& centre, double radius, int fineness) {
  TriangleMesh mesh = box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones(), 1 << fineness);
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    mesh.vertices.row(v) = centre.transpose() + radius * mesh.vertices.row(v).normalized();
  }
  return mesh;
}

}  // namespace gnathion::test
