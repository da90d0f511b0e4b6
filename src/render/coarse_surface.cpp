#include "render/coarse_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace gnathion {
namespace {

double area_of(const TriangleMesh& surface) {
  double sum = 0;
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    const auto corner = surface.triangles.row(t);
    const Eigen::Vector3d a = surface.vertices.row(corner[0]);
    const Eigen::Vector3d b = surface.vertices.row(corner[1]);
    const Eigen::Vector3d c = surface.vertices.row(corner[2]);
    sum += (b - a).cross(c - a).norm() / 2;
  }
  return sum;
}

/// For each vertex the one that stands for its cell: the first vertex in it. What is kept stands
/// for itself.
std::vector<int> cell_vertices(const Points& vertices, double cell, const std::vector<bool>& kept) {
  const Eigen::RowVector3d low = vertices.colwise().minCoeff();
  const Eigen::RowVector3d size = vertices.colwise().maxCoeff() - low;
  const auto across = static_cast<std::int64_t>(size.maxCoeff() / cell) + 1;
  std::unordered_map<std::int64_t, int> first;
  first.reserve(static_cast<std::size_t>(vertices.rows()) / 4);
  std::vector<int> stands_for(static_cast<std::size_t>(vertices.rows()));
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    if (!kept.empty() && kept[static_cast<std::size_t>(v)]) {
      stands_for[static_cast<std::size_t>(v)] = static_cast<int>(v);
      continue;
    }
    std::int64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      key = key * across + static_cast<std::int64_t>((vertices(v, k) - low(k)) / cell);
    }
    stands_for[static_cast<std::size_t>(v)] = first.emplace(key, static_cast<int>(v)).first->second;
  }
  return stands_for;
}

/// Triangles between three different cells, each once.
Triangles between_cells(const Triangles& triangles, const std::vector<int>& stands_for) {
  std::vector<std::array<int, 3>> kept;
  const auto hash = [](const std::array<int, 3>& t) {
    std::size_t h = 0;
    for (const int v : t) h = h * 1000003u + static_cast<std::size_t>(v);
    return h;
  };
  std::unordered_set<std::array<int, 3>, decltype(hash)> seen(
      static_cast<std::size_t>(triangles.rows()) / 4, hash);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    std::array<int, 3> corner{};
    for (int k = 0; k < 3; ++k) corner[k] = stands_for[static_cast<std::size_t>(triangles(t, k))];
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) continue;
    // Turned, not sorted: the two sides of a thin part stay two.
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    if (seen.insert(corner).second) kept.push_back(corner);
  }
  Triangles result(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t t = 0; t < kept.size(); ++t) {
    result.row(static_cast<Eigen::Index>(t)) << kept[t][0], kept[t][1], kept[t][2];
  }
  return result;
}

}  // namespace

Triangles coarse_triangles(const TriangleMesh& surface, int wanted, const std::vector<bool>& kept) {
  if (surface.triangles.rows() <= wanted) return surface.triangles;
  // A flat square grid of this width would give `wanted` triangles. Where cells are cut askew there
  // are more of them, so it is widened until they are few enough; what is kept adds its own.
  const auto most = wanted + 2 * std::count(kept.begin(), kept.end(), true);
  double cell = std::sqrt(2 * area_of(surface) / wanted);
  for (;; cell *= 1.15) {
    Triangles coarse =
        between_cells(surface.triangles, cell_vertices(surface.vertices, cell, kept));
    if (coarse.rows() <= most) return coarse;
  }
}

}  // namespace gnathion
