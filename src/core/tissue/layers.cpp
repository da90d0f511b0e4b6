#include "tissue/layers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/tet_quality.h"

namespace gnathion {
namespace {

/// Depths between k equal-or-growing layers, as parts of the whole: k−1 values in (0, 1).
std::vector<double> level_parts(int layers, double growth) {
  std::vector<double> parts;
  double sum = 0, thickness = 1;
  for (int k = 0; k < layers; ++k, thickness *= growth) {
    sum += thickness;
    parts.push_back(sum);
  }
  for (double& part : parts) part /= sum;
  parts.pop_back();
  return parts;
}

/// The elements of Algorithm 1, in its order, below the nodes above_deepest. A tet is (a, b, c, d)
/// with positive volume when the inner points lie behind the surface.
void add_deepest_layer(const IntermediateMesh& region, const SoftTissueMesh& nodes,
                       std::vector<std::array<int, 4>>& tets) {
  const Triangles& F = region.mesh.triangles;
  // The edges that Algorithm 1 treats with triangle i: those to a neighbour of higher index.
  std::vector<std::vector<const Edge*>> edges_of_triangle(static_cast<std::size_t>(F.rows()));
  for (const Edge& edge : region.edges) {
    if (edge.right != -1) edges_of_triangle[std::min(edge.left, edge.right)].push_back(&edge);
  }
  for (int i = 0; i < F.rows(); ++i) {
    tets.push_back({nodes.above_deepest(F(i, 0)), nodes.above_deepest(F(i, 2)),
                    nodes.above_deepest(F(i, 1)), nodes.centre(i)});
    for (const Edge* edge : edges_of_triangle[i]) {
      const int b = nodes.above_deepest(edge->a), c = nodes.above_deepest(edge->b);
      const int cf = nodes.centre(edge->left), cg = nodes.centre(edge->right);
      tets.push_back({cf, cg, c, b});
      tets.push_back({cf, cg, b, nodes.inner(edge->a)});
      tets.push_back({cf, cg, nodes.inner(edge->b), c});
    }
  }
}

/// The elements between a triangle and its deepest layer. depth: of each node below its surface
/// vertex, mm.
void add_upper_layers(const Triangles& F, int f, const SoftTissueMesh& nodes,
                      const Eigen::VectorXd& depth, std::vector<std::array<int, 4>>& tets) {
  std::array<int, 3> level{};
  const auto node = [&](int corner, int at) { return nodes.column_node(F(f, corner), at); };
  for (;;) {
    std::pair<double, int> first{std::numeric_limits<double>::infinity(), 0};
    int stepped = -1;
    for (int corner = 0; corner < 3; ++corner) {
      if (level[corner] == nodes.layers(F(f, corner)) - 1) continue;
      const std::pair<double, int> key{depth[node(corner, level[corner] + 1)], F(f, corner)};
      if (key >= first) continue;
      first = key;
      stepped = corner;
    }
    if (stepped == -1) return;
    const int next = node(stepped, level[stepped] + 1);
    tets.push_back({node(0, level[0]), node(2, level[2]), node(1, level[1]), next});
    ++level[stepped];
  }
}

/// Mean length of the edges at each vertex, mm.
Eigen::VectorXd local_edge_length(const IntermediateMesh& region) {
  const Points& x = region.mesh.vertices;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(x.rows()), count = Eigen::VectorXd::Zero(x.rows());
  for (const Edge& edge : region.edges) {
    const double length = (x.row(edge.a) - x.row(edge.b)).norm();
    for (const int v : {edge.a, edge.b}) {
      sum[v] += length;
      ++count[v];
    }
  }
  return sum.cwiseQuotient(count.cwiseMax(1));
}

/// The number of layers whose thicknesses add up to most nearly `depth`, the first being `first`
/// mm.
int wanted_layers(double depth, double first, const LayerOptions& options) {
  if (!(first > 0)) return 1;
  const double thicknesses = depth / first, g = options.growth;
  const double layers = g > 1 ? std::log1p(thicknesses * (g - 1)) / std::log(g) : thicknesses;
  return static_cast<int>(std::lround(std::clamp(layers, 1.0, double(options.most))));
}

/// Reduces counts until neighbours differ by at most one.
void level_out(const std::vector<Edge>& edges, std::vector<int>& layers) {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Edge& edge : edges) {
      int& a = layers[edge.a];
      int& b = layers[edge.b];
      if (std::abs(a - b) <= 1) continue;
      (a > b ? a : b) = std::min(a, b) + 1;
      changed = true;
    }
  }
}

/// The surface vertex whose column a node is in; −1 for a centre point.
std::vector<int> column_of_nodes(const SoftTissueMesh& tissue) {
  std::vector<int> column(static_cast<std::size_t>(tissue.mesh.vertices.rows()), -1);
  for (int v = 0; v < tissue.surface_count; ++v) {
    for (int level = 0; level <= tissue.layers(v); ++level) {
      column[tissue.column_node(v, level)] = v;
    }
  }
  return column;
}

/// Takes a layer away at the vertices of inverted or too flat elements. Whether there were any.
bool thin_out(const IntermediateMesh& region, const SoftTissueMesh& tissue,
              double smallest_volume_ratio, std::vector<int>& layers) {
  const std::vector<int> column = column_of_nodes(tissue);
  const Eigen::VectorXd volumes = tet_volumes(tissue.mesh);
  const Eigen::VectorXd flat = flat_volumes(region, tissue);
  std::vector<bool> fewer(layers.size(), false);
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    if (volumes[t] > smallest_volume_ratio * flat[t]) continue;
    for (const int node : tissue.mesh.tets.row(t)) {
      if (column[node] != -1) fewer[column[node]] = true;
    }
  }
  bool any = false;
  for (std::size_t v = 0; v < layers.size(); ++v) {
    if (!fewer[v] || layers[v] == 1) continue;
    --layers[v];
    any = true;
  }
  return any;
}

/// Mean area of each vertex's triangles, mm².
Eigen::VectorXd triangle_area_at_vertices(const TriangleMesh& mesh) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(mesh.vertices.rows());
  Eigen::VectorXd count = Eigen::VectorXd::Zero(mesh.vertices.rows());
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(f, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(f, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(f, 2));
    for (int corner = 0; corner < 3; ++corner) {
      sum[mesh.triangles(f, corner)] += (b - a).cross(c - a).norm() / 2;
      ++count[mesh.triangles(f, corner)];
    }
  }
  return sum.cwiseQuotient(count);
}

}  // namespace

Eigen::VectorXd flat_volumes(const IntermediateMesh& region, const SoftTissueMesh& tissue) {
  const Points& x = tissue.mesh.vertices;
  const Eigen::VectorXd area = triangle_area_at_vertices(region.mesh);
  Eigen::VectorXd at_node(x.rows());
  for (int v = 0; v < tissue.surface_count; ++v) {
    const double flat = area[v] * (x.row(tissue.column_node(v, 1)) - x.row(v)).norm() / 3;
    for (int level = 0; level <= tissue.layers(v); ++level) {
      at_node[tissue.column_node(v, level)] = flat;
    }
  }
  for (int f = 0; f < tissue.triangle_count; ++f) {
    const auto t = region.mesh.triangles.row(f);
    at_node[tissue.centre(f)] = std::min({at_node[t[0]], at_node[t[1]], at_node[t[2]]});
  }
  Eigen::VectorXd volumes(tissue.mesh.tets.rows());
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    const auto nodes = tissue.mesh.tets.row(t);
    volumes[t] =
        std::min({at_node[nodes[0]], at_node[nodes[1]], at_node[nodes[2]], at_node[nodes[3]]});
  }
  return volumes;
}

void set_layers(const IntermediateMesh& region, const std::vector<int>& layers, double growth,
                SoftTissueMesh& tissue) {
  const int M = tissue.surface_count, N = tissue.triangle_count;
  tissue.column_start.assign(1, 0);
  for (const int count : layers) {
    tissue.column_start.push_back(tissue.column_start.back() + count - 1);
  }
  tissue.mesh.vertices.conservativeResize(2 * M + N + tissue.column_start.back(), 3);
  Eigen::VectorXd depth = Eigen::VectorXd::Zero(tissue.mesh.vertices.rows());
  for (int v = 0; v < M; ++v) {
    const Eigen::RowVector3d top = tissue.mesh.vertices.row(v);
    const Eigen::RowVector3d down = tissue.mesh.vertices.row(tissue.inner(v)) - top;
    const std::vector<double> parts = level_parts(layers[v], growth);
    for (int level = 1; level < layers[v]; ++level) {
      const int node = tissue.column_node(v, level);
      tissue.mesh.vertices.row(node) = top + parts[level - 1] * down;
      depth[node] = parts[level - 1] * tissue.depth[v];
    }
  }
  std::vector<std::array<int, 4>> tets;
  tets.reserve(
      static_cast<std::size_t>(N + 3 * region.edges.size() + tissue.column_start.back() * 6));
  add_deepest_layer(region, tissue, tets);
  for (int f = 0; f < N; ++f) add_upper_layers(region.mesh.triangles, f, tissue, depth, tets);
  tissue.mesh.tets =
      Eigen::Map<const Tets>(tets.front().data(), static_cast<Eigen::Index>(tets.size()), 4);
}

void add_layers(const IntermediateMesh& region, const LayerOptions& options,
                double smallest_volume_ratio, SoftTissueMesh& tissue) {
  const Eigen::VectorXd edge = local_edge_length(region);
  std::vector<int> layers(static_cast<std::size_t>(tissue.surface_count));
  for (int v = 0; v < tissue.surface_count; ++v) {
    layers[v] = wanted_layers(tissue.depth[v], options.thickness_in_edges * edge[v], options);
  }
  do {
    level_out(region.edges, layers);
    set_layers(region, layers, options.growth, tissue);
  } while (thin_out(region, tissue, smallest_volume_ratio, layers));
}

}  // namespace gnathion
