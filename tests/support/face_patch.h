#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>

#include "geometry/triangle_mesh.h"
#include "tissue/intermediate_mesh.h"

namespace gnathion::testing {

/// A flat disk of exactly `vertex_count` vertices with `rim_count` of them on the rim (so that
/// F = 2V − B − 2), edges about `edge` mm, in the plane z = 0, normals +z: a grid of columns × rows
/// in which some edges are split.
inline TriangleMesh flat_disk(int vertex_count, int rim_count, double edge) {
  // Columns and rows with the right rim and the most vertices that do not exceed the count.
  const int half = (rim_count + 4) / 2;
  int columns = half / 2;
  while (columns * (half - columns) > vertex_count) --columns;
  const int rows = half - columns;
  std::vector<Eigen::RowVector3d> x;
  std::vector<std::array<int, 3>> triangles;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) x.emplace_back(edge * c, edge * r, 0);
  }
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < columns; ++c) {
      const int v = r * columns + c;
      if ((r + c) % 2 == 0) {
        triangles.push_back({v, v + 1, v + columns + 1});
        triangles.push_back({v, v + columns + 1, v + columns});
      } else {
        triangles.push_back({v, v + 1, v + columns});
        triangles.push_back({v + 1, v + columns + 1, v + columns});
      }
    }
  }
  if (rim_count % 2 == 1) {  // split the rim edge 0–1
    const int m = static_cast<int>(x.size());
    x.push_back((x[0] + x[1]) / 2);
    for (auto& t : triangles) {
      if (t[0] == 0 && t[1] == 1) {
        const int apex = t[2];
        t = {0, m, apex};
        triangles.push_back({m, 1, apex});
        break;
      }
    }
  }
  // Split triangles, evenly spread, at their centres until the count is right.
  const int missing = vertex_count - static_cast<int>(x.size());
  const std::size_t stride = triangles.size() / static_cast<std::size_t>(missing + 1);
  for (int k = 1; k <= missing; ++k) {
    const auto [a, b, c] = triangles[static_cast<std::size_t>(k) * stride];
    const int m = static_cast<int>(x.size());
    x.push_back((x[a] + x[b] + x[c]) / 3);
    triangles[static_cast<std::size_t>(k) * stride] = {a, b, m};
    triangles.push_back({b, c, m});
    triangles.push_back({c, a, m});
  }
  TriangleMesh mesh{Points(x.size(), 3), Triangles(triangles.size(), 3)};
  for (std::size_t i = 0; i < x.size(); ++i) mesh.vertices.row(i) = x[i];
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    mesh.triangles.row(i) << triangles[i][0], triangles[i][1], triangles[i][2];
  }
  return mesh;
}

/// Sets z = height(x, y), x and y measured from the middle of the patch.
inline void raise(TriangleMesh& mesh, const std::function<double(double, double)>& height) {
  const Eigen::RowVector3d middle =
      (mesh.vertices.colwise().minCoeff() + mesh.vertices.colwise().maxCoeff()) / 2;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    mesh.vertices(i, 2) = height(mesh.vertices(i, 0) - middle[0], mesh.vertices(i, 1) - middle[1]);
  }
}

inline double bump(double x, double y, double at_x, double at_y, double width, double length) {
  const double a = (x - at_x) / width, b = (y - at_y) / length;
  return std::exp(-a * a - b * b);
}

/// A lower face: round, with a chin, two lips, the fold between and below them. mm.
inline double lower_face(double x, double y) {
  const double round = -(x * x) / 140 - (y * y) / 400;
  const double chin = 9 * bump(x, y, 0, -22, 16, 13);
  const double lips = 5 * bump(x, y, 0, 9, 20, 5) + 6 * bump(x, y, 0, -1, 19, 5);
  const double fold = -3 * bump(x, y, 0, -9, 22, 4);
  return round + chin + lips + fold;
}

/// Patches of the sizes in the paper's Table 1, shaped as a lower face.
inline TriangleMesh patch_p1() {  // 2192 vertices, 4202 triangles
  TriangleMesh mesh = flat_disk(2192, 180, 2.2);
  raise(mesh, lower_face);
  return mesh;
}
inline TriangleMesh patch_p2() {  // 4817 vertices, 9337 triangles
  TriangleMesh mesh = flat_disk(4817, 295, 1.5);
  raise(mesh, lower_face);
  return mesh;
}

/// The hard patches: kind 0 nose, 1 lips, 2 groove, 3 random waves; edge 2.2 mm.
inline TriangleMesh hard_patch(int kind, unsigned seed) {
  TriangleMesh mesh = flat_disk(676, 100, 2.2);
  std::mt19937 random(seed * 4 + static_cast<unsigned>(kind));
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967295.0);
  };
  const double h = uniform(0.8, 1.2), w = uniform(0.85, 1.15);
  std::array<std::array<double, 4>, 10> waves;
  for (auto& wave : waves) {
    wave = {uniform(-20, 20), uniform(-20, 20), uniform(4, 9), uniform(-5, 5)};
  }
  raise(mesh, [&](double x, double y) {
    const double round = -(x * x + y * y) / 150;
    switch (kind) {
      case 0:
        return round + h * (14 * bump(x, y, 0, 0, 7 * w, 9 * w) + 5 * bump(x, y, -9, -4, 4, 5) +
                            5 * bump(x, y, 9, -4, 4, 5) - 2 * bump(x, y, 0, -11, 9, 3));
      case 1:
        return round + h * (6 * bump(x, y, 0, 5, 16, 4 * w) + 6.5 * bump(x, y, 0, -5, 15, 4 * w) -
                            4 * bump(x, y, 0, 0, 14, 1.8 * w));
      case 2:
        return round - h * 7 * std::exp(-std::pow((y + 0.2 * x) / (3.2 * w), 2));
      default: {
        double z = round;
        for (const auto& wave : waves)
          z += wave[3] * bump(x, y, wave[0], wave[1], wave[2], wave[2]);
        return z;
      }
    }
  });
  // Jitter in the plane, so that no triangle is special.
  const auto edges = edges_of(mesh);
  const auto rim = rim_vertices(mesh, edges);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    if (rim[i]) continue;
    mesh.vertices(i, 0) += uniform(-0.3, 0.3);
    mesh.vertices(i, 1) += uniform(-0.3, 0.3);
  }
  return mesh;
}

/// A whole mesh as a region.
inline IntermediateMesh whole_region(const TriangleMesh& mesh) {
  IntermediateMesh region{mesh, {}, edges_of(mesh), {}, {}, {}};
  region.rim = region.held = rim_vertices(mesh, region.edges);
  for (int i = 0; i < mesh.vertices.rows(); ++i) region.face_vertex.push_back(i);
  return region;
}

}  // namespace gnathion::testing
