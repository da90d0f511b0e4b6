#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include "fem/elements.h"
#include "geometry/mesh_types.h"

namespace gnathion::testing {

/// A place in a solid: of the unit cube's points.
using Placement = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// A block of tets: the unit cube cut into n[0]×n[1]×n[2] cells, each into the six tets around its
/// diagonal from corner 000 to 111 (Kuhn 1960; neighbours fit together), then placed.
inline TetMesh tet_block(const std::array<int, 3>& n, const Placement& place) {
  const auto vertex = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  TetMesh mesh{Points((n[0] + 1) * (n[1] + 1) * (n[2] + 1), 3), Tets(6 * n[0] * n[1] * n[2], 4)};
  Eigen::Index tet = 0;
  for (int k = 0; k <= n[2]; ++k) {
    for (int j = 0; j <= n[1]; ++j) {
      for (int i = 0; i <= n[0]; ++i) {
        mesh.vertices.row(vertex(i, j, k)) =
            place({double(i) / n[0], double(j) / n[1], double(k) / n[2]});
        if (i == n[0] || j == n[1] || k == n[2]) continue;
        std::array<int, 3> axes{0, 1, 2};
        do {
          std::array<int, 3> at{i, j, k};
          Eigen::RowVector4i corners;
          corners[0] = vertex(at[0], at[1], at[2]);
          for (int step = 0; step < 3; ++step) {
            ++at[axes[step]];
            corners[step + 1] = vertex(at[0], at[1], at[2]);
          }
          mesh.tets.row(tet++) = corners;
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
    }
  }
  for (auto t : mesh.tets.rowwise()) {
    const Eigen::Vector3d a = mesh.vertices.row(t[0]), b = mesh.vertices.row(t[1]),
                          c = mesh.vertices.row(t[2]), d = mesh.vertices.row(t[3]);
    if (linear_tet(a, b, c, d).volume < 0) std::swap(t[2], t[3]);
  }
  return mesh;
}

/// A box from the origin to `size`.
inline TetMesh tet_box(const Eigen::Vector3d& size, const std::array<int, 3>& n) {
  return tet_block(n, [&](const Eigen::Vector3d& at) { return at.cwiseProduct(size).eval(); });
}

/// Moves every vertex that is not on the hull of a block by up to `part` of the spacing 1/n of its
/// unit cube times `size`: no two tets are alike then.
inline void distort_box(TetMesh& mesh, const Eigen::Vector3d& size, const std::array<int, 3>& n,
                        double part, unsigned seed) {
  std::mt19937 random(seed);
  for (auto x : mesh.vertices.rowwise()) {
    for (int axis = 0; axis < 3; ++axis) {
      const double shift = part * (static_cast<double>(random()) / 2147483648.0 - 1) * size[axis] /
                           n[static_cast<std::size_t>(axis)];
      const double limit = 1e-9 * size[axis];
      if (x[axis] > limit && x[axis] < size[axis] - limit) x[axis] += shift;
    }
  }
}

/// Meshes as one, vertices within 1e-9 of the largest coordinate welded.
inline TetMesh welded(const std::vector<TetMesh>& parts) {
  double largest = 0;
  for (const TetMesh& part : parts) {
    largest = std::max(largest, part.vertices.cwiseAbs().maxCoeff());
  }
  std::map<std::array<long, 3>, int> known;
  std::vector<Eigen::RowVector3d> points;
  std::vector<Eigen::RowVector4i> tets;
  for (const TetMesh& part : parts) {
    std::vector<int> index;
    for (const Eigen::RowVector3d x : part.vertices.rowwise()) {
      const Eigen::RowVector3d scaled = x / largest * 1e8;
      const auto [place, is_new] = known.try_emplace(
          {std::lround(scaled[0]), std::lround(scaled[1]), std::lround(scaled[2])},
          static_cast<int>(points.size()));
      if (is_new) points.push_back(x);
      index.push_back(place->second);
    }
    for (const auto t : part.tets.rowwise()) {
      tets.emplace_back(index[t[0]], index[t[1]], index[t[2]], index[t[3]]);
    }
  }
  TetMesh mesh{Points(points.size(), 3), Tets(tets.size(), 4)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    mesh.vertices.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  for (std::size_t i = 0; i < tets.size(); ++i) {
    mesh.tets.row(static_cast<Eigen::Index>(i)) = tets[i];
  }
  return mesh;
}

/// An eighth (all coordinates ≥ 0) of the shell between two radii: three blocks, each n×n cells
/// along the sphere and `through` cells between the radii.
inline TetMesh tet_shell_eighth(double inner, double outer, int n, int through) {
  std::vector<TetMesh> parts;
  for (int face = 0; face < 3; ++face) {
    parts.push_back(tet_block({n, n, through}, [&](const Eigen::Vector3d& at) {
      // Tangents of equal angles, so that cells are alike.
      Eigen::Vector3d direction;
      direction[face] = 1;
      direction[(face + 1) % 3] = std::tan(at[face == 1 ? 1 : 0] * M_PI / 4);
      direction[(face + 2) % 3] = std::tan(at[face == 1 ? 0 : 1] * M_PI / 4);
      return Eigen::Vector3d(direction.normalized() * (inner + at[2] * (outer - inner)));
    }));
  }
  return welded(parts);
}

/// Cook's membrane (Cook 1974): corners (0,0), (48,44), (48,60), (0,44), this thick along z.
inline TetMesh tet_cook(double thickness, const std::array<int, 3>& n) {
  return tet_block(n, [&](const Eigen::Vector3d& at) {
    const double low = 44 * at[0], high = 44 + 16 * at[0];
    return Eigen::Vector3d(48 * at[0], low + at[1] * (high - low), thickness * at[2]);
  });
}

/// Every tet cut into eight at the middles of its edges; the vertices come first and keep their
/// places, then the middles as ElementMesh orders them.
inline TetMesh refined(const TetMesh& mesh) {
  const ElementMesh quadratic(mesh, ElementOrder::quadratic);
  // Corners 0–3, middles 4: 01, 5: 12, 6: 20, 7: 03, 8: 13, 9: 23; the inner octahedron is cut
  // around the diagonal from the middle of 02 to that of 13.
  constexpr std::array<std::array<int, 4>, 8> kChildren{{{0, 4, 6, 7},
                                                         {4, 1, 5, 8},
                                                         {6, 5, 2, 9},
                                                         {7, 8, 9, 3},
                                                         {6, 8, 4, 5},
                                                         {6, 8, 5, 9},
                                                         {6, 8, 9, 7},
                                                         {6, 8, 7, 4}}};
  TetMesh fine{quadratic.nodes, Tets(8 * mesh.tets.rows(), 4)};
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    for (Eigen::Index c = 0; c < 8; ++c) {
      for (Eigen::Index k = 0; k < 4; ++k) {
        fine.tets(8 * t + c, k) = quadratic.elements(
            t, kChildren[static_cast<std::size_t>(c)][static_cast<std::size_t>(k)]);
      }
    }
  }
  return fine;
}

/// The hull of a mesh: nodes of each outer face, corners counter-clockwise seen from outside, then
/// on quadratic elements the middles of 01, 12 and 20.
inline std::vector<std::vector<int>> hull_faces(const ElementMesh& mesh) {
  constexpr std::array<std::array<int, 3>, 4> kFaces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  constexpr std::array<std::array<int, 3>, 4> kMiddles{
      {{6, 5, 4}, {4, 8, 7}, {5, 9, 8}, {7, 9, 6}}};
  std::map<std::array<int, 3>, std::vector<int>> once;
  for (const auto nodes : mesh.elements.rowwise()) {
    for (std::size_t f = 0; f < 4; ++f) {
      std::vector<int> face;
      for (const int k : kFaces[f]) face.push_back(nodes[k]);
      std::array<int, 3> key{face[0], face[1], face[2]};
      std::sort(key.begin(), key.end());
      if (mesh.order() == ElementOrder::quadratic) {
        for (const int k : kMiddles[f]) face.push_back(nodes[k]);
      }
      if (const auto seen = once.find(key); seen != once.end()) {
        once.erase(seen);
      } else {
        once.emplace(key, face);
      }
    }
  }
  std::vector<std::vector<int>> faces;
  for (auto& [key, face] : once) faces.push_back(std::move(face));
  return faces;
}

/// The nodal forces of a traction on those outer faces whose corners all satisfy `where`: exact for
/// a traction that is constant over each face. `traction`: N/mm², of the face's centre and its unit
/// normal. n×3, N.
inline Points traction_forces(
    const ElementMesh& mesh, const std::function<bool(const Eigen::Vector3d&)>& where,
    const std::function<Eigen::Vector3d(const Eigen::Vector3d&, const Eigen::Vector3d&)>&
        traction) {
  Points forces = Points::Zero(mesh.nodes.rows(), 3);
  for (const std::vector<int>& face : hull_faces(mesh)) {
    const Eigen::Vector3d a = mesh.nodes.row(face[0]), b = mesh.nodes.row(face[1]),
                          c = mesh.nodes.row(face[2]);
    if (!where(a) || !where(b) || !where(c)) continue;
    const Eigen::Vector3d twice = (b - a).cross(c - a);
    const Eigen::Vector3d third = twice.norm() / 6 * traction((a + b + c) / 3, twice.normalized());
    // ∫N is a third of the area at corners of linear faces; 0 at corners and a third at middles of
    // quadratic ones.
    for (std::size_t k = face.size() == 3 ? 0 : 3; k < face.size(); ++k) {
      forces.row(face[k]) += third.transpose();
    }
  }
  return forces;
}

}  // namespace gnathion::testing
