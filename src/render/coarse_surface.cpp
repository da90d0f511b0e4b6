#include "render/coarse_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "geometry/triangle_mesh.h"

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

/// Vertices of a cell that look the same way: of a thin part both sides are kept apart.
struct Cluster {
  Eigen::Vector3d direction;  ///< of its first vertex' normal
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  int nearest = -1;  ///< vertex to the middle
  double distance = std::numeric_limits<double>::max();
};

/// Vertices gathered by the cells of a grid.
class Clusters {
 public:
  Clusters(const Points& vertices, const Points& normals, double cell)
      : vertices_(vertices),
        normals_(normals),
        low_(vertices.colwise().minCoeff()),
        cell_(cell),
        across_(
            static_cast<std::int64_t>((vertices.colwise().maxCoeff() - low_).maxCoeff() / cell) +
            1) {
    in_cell_.reserve(static_cast<std::size_t>(vertices.rows()) / 4);
  }

  /// Adds a vertex; returns its cluster.
  int add(Eigen::Index v) {
    std::int64_t key = 0;
    for (int k = 0; k < 3; ++k) {
      key = key * across_ + static_cast<std::int64_t>((vertices_(v, k) - low_(k)) / cell_);
    }
    const Eigen::Vector3d normal = normals_.row(v);
    std::array<int, 2>& sides = in_cell_.try_emplace(key, std::array<int, 2>{-1, -1}).first->second;
    const bool is_other = sides[0] >= 0 && at(sides[0]).direction.dot(normal) < 0;
    int& found = sides[is_other ? 1 : 0];
    if (found < 0) {
      found = static_cast<int>(all_.size());
      all_.push_back({normal});
    }
    at(found).sum += vertices_.row(v).transpose();
    ++at(found).count;
    return found;
  }

  /// Once all are added, for each of them again.
  void compare(int cluster, Eigen::Index v) {
    Cluster& its = at(cluster);
    const double distance = (vertices_.row(v).transpose() - its.sum / its.count).squaredNorm();
    if (distance < its.distance) {
      its.distance = distance;
      its.nearest = static_cast<int>(v);
    }
  }

  int nearest(int cluster) const { return all_[static_cast<std::size_t>(cluster)].nearest; }

 private:
  Cluster& at(int cluster) { return all_[static_cast<std::size_t>(cluster)]; }

  const Points& vertices_;
  const Points& normals_;
  Eigen::RowVector3d low_;
  double cell_;
  std::int64_t across_;
  std::unordered_map<std::int64_t, std::array<int, 2>> in_cell_;
  std::vector<Cluster> all_;
};

/// For each vertex the one that stands for its cluster: the one nearest to its middle. What is kept
/// stands for itself.
std::vector<int> cluster_vertices(const Points& vertices, const Points& normals, double cell,
                                  const std::vector<bool>& kept) {
  Clusters clusters(vertices, normals, cell);
  std::vector<int> of(static_cast<std::size_t>(vertices.rows()), -1);
  for (std::size_t v = 0; v < of.size(); ++v) {
    if (kept.empty() || !kept[v]) of[v] = clusters.add(static_cast<Eigen::Index>(v));
  }
  for (std::size_t v = 0; v < of.size(); ++v) {
    if (of[v] >= 0) clusters.compare(of[v], static_cast<Eigen::Index>(v));
  }
  for (std::size_t v = 0; v < of.size(); ++v) {
    of[v] = of[v] < 0 ? static_cast<int>(v) : clusters.nearest(of[v]);
  }
  return of;
}

/// Whether a triangle has its back where its vertices' normals point.
bool is_folded(const std::array<int, 3>& corner, const Points& vertices, const Points& normals) {
  const Eigen::Vector3d a = vertices.row(corner[0]), b = vertices.row(corner[1]),
                        c = vertices.row(corner[2]);
  const Eigen::Vector3d outward =
      (normals.row(corner[0]) + normals.row(corner[1]) + normals.row(corner[2])).transpose();
  return (b - a).cross(c - a).dot(outward) < 0;
}

/// Triangles between three different clusters, each once. Those that are folded over lie between
/// two that are not: without them nothing is missing, and no dark spot is seen.
Triangles between_clusters(const TriangleMesh& surface, const Points& normals,
                           const std::vector<int>& stands_for) {
  const Triangles& triangles = surface.triangles;
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
    if (is_folded(corner, surface.vertices, normals)) continue;
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
  const Points normals = vertex_normals(surface);
  double cell = std::sqrt(2 * area_of(surface) / wanted);
  for (;; cell *= 1.15) {
    Triangles coarse =
        between_clusters(surface, normals, cluster_vertices(surface.vertices, normals, cell, kept));
    if (coarse.rows() <= most) return coarse;
  }
}

}  // namespace gnathion
