#include "tissue/st_generator.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/bsp_tree.h"
#include "tissue/inner_surface.h"
#include "tissue/untangle.h"

namespace gnathion {
namespace {

/// A mesh of one layer whose inner and centre points are still to be placed.
SoftTissueMesh empty_mesh(const IntermediateMesh& region) {
  SoftTissueMesh tissue;
  tissue.surface_count = static_cast<int>(region.mesh.vertices.rows());
  tissue.triangle_count = static_cast<int>(region.mesh.triangles.rows());
  tissue.mesh.vertices.resize(2 * tissue.surface_count + tissue.triangle_count, 3);
  tissue.mesh.vertices.topRows(tissue.surface_count) = region.mesh.vertices;
  tissue.mesh.vertices.bottomRows(tissue.surface_count + tissue.triangle_count).setZero();
  set_layers(region, std::vector<int>(static_cast<std::size_t>(tissue.surface_count), 1), 1,
             tissue);
  return tissue;
}

/// N×3 weights of the centre points: those of the triangle's incentre, the lengths of the edges
/// opposite to its corners. The line between two neighbours' incentres crosses their common edge
/// between its ends whatever the triangles' shape (both touch it there); that of the centroids may
/// pass it by, and then the elements at the edge's ends are inverted at any depth.
Points centre_weights(const TriangleMesh& mesh) {
  Points weights(mesh.triangles.rows(), 3);
  for (Eigen::Index f = 0; f < weights.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      weights(f, corner) = (mesh.vertices.row(mesh.triangles(f, (corner + 1) % 3)) -
                            mesh.vertices.row(mesh.triangles(f, (corner + 2) % 3)))
                               .norm();
    }
  }
  return weights.array().colwise() / weights.rowwise().sum().array();
}

/// Centre points between the inner vertices.
void place_centre_points(const IntermediateMesh& region, const Points& weights,
                         SoftTissueMesh& tissue) {
  Points& P = tissue.mesh.vertices;
  for (int i = 0; i < tissue.triangle_count; ++i) {
    const auto f = region.mesh.triangles.row(i);
    P.row(tissue.centre(i)) = weights(i, 0) * P.row(tissue.inner(f[0])) +
                              weights(i, 1) * P.row(tissue.inner(f[1])) +
                              weights(i, 2) * P.row(tissue.inner(f[2]));
  }
}

}  // namespace

SoftTissueMesh st_generator_paper(const IntermediateMesh& region, double depth,
                                  double centre_fraction) {
  SoftTissueMesh tissue = empty_mesh(region);
  const int M = tissue.surface_count;
  tissue.depth = Eigen::VectorXd::Constant(M, depth);
  Points& P = tissue.mesh.vertices;
  P.middleRows(M, M) = region.mesh.vertices - depth * vertex_normals(region.mesh);
  const Points normals = triangle_normals(region.mesh);
  for (int i = 0; i < tissue.triangle_count; ++i) {
    const auto f = region.mesh.triangles.row(i);
    P.row(tissue.centre(i)) =
        (P.row(f[0]) + P.row(f[1]) + P.row(f[2])) / 3 - centre_fraction * depth * normals.row(i);
  }
  return tissue;
}

Points offset_directions(const IntermediateMesh& region, double length) {
  // k means over the neighbours spread over about √k edges; the factor is by trial on faces.
  const double edges = length / mean_edge_length(region.mesh);
  const int smoothing_rounds = std::clamp(static_cast<int>(3 * edges * edges), 5, 400);
  const Points inward = -vertex_normals(region.mesh);
  const Points behind = -triangle_normals(region.mesh);
  const auto neighbours = vertex_neighbours(region.mesh);
  Points directions = inward;
  for (int round = 0; round < smoothing_rounds; ++round) {
    Points mean = directions;
    for (Eigen::Index v = 0; v < mean.rows(); ++v) {
      for (const int w : neighbours[v]) mean.row(v) += directions.row(w);
    }
    directions = mean.rowwise().normalized();
  }
  // Least cosine between a vertex's direction and the triangles it must stay behind.
  const auto least_cosine = [&](const Points& d) {
    Eigen::VectorXd least = Eigen::VectorXd::Ones(d.rows());
    for (Eigen::Index f = 0; f < behind.rows(); ++f) {
      for (const int v : region.mesh.triangles.row(f)) {
        least[v] = std::min(least[v], d.row(v).dot(behind.row(f)));
      }
    }
    return least;
  };
  const Eigen::VectorXd before = least_cosine(inward);
  constexpr double kEnough = 0.3;
  for (int round = 0; round < 8; ++round) {
    const Eigen::VectorXd now = least_cosine(directions);
    for (Eigen::Index v = 0; v < directions.rows(); ++v) {
      if (now[v] >= std::min(kEnough, before[v])) continue;
      directions.row(v) = (directions.row(v) + inward.row(v)).normalized().eval();
    }
  }
  return directions;
}

namespace {

/// Depth at which the offset lines at the ends of an edge come closest to meeting, mm; infinite
/// when they do not converge.
double focal_depth(const Eigen::RowVector3d& edge, const Eigen::RowVector3d& turn) {
  const double closing = -edge.dot(turn);
  return closing > 0 ? edge.squaredNorm() / closing : std::numeric_limits<double>::infinity();
}

/// Cuts depths down to a part of the focal depth, beyond which inner vertices would pass each
/// other, and to what the slope allows from any other vertex (Dijkstra from the shallow ones).
Eigen::VectorXd limited_depths(const IntermediateMesh& region, const Points& directions,
                               const std::vector<std::vector<int>>& neighbours,
                               const Eigen::VectorXd& wanted,
                               const RobustGeneratorOptions& options) {
  const Points& x = region.mesh.vertices;
  Eigen::VectorXd depth = wanted;
  for (const Edge& edge : region.edges) {
    const double focal =
        focal_depth(x.row(edge.b) - x.row(edge.a), directions.row(edge.b) - directions.row(edge.a));
    for (const int v : {edge.a, edge.b}) {
      depth[v] = std::min(depth[v], options.focal_part * focal);
    }
  }
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int v = 0; v < depth.size(); ++v) queue.emplace(depth[v], v);
  while (!queue.empty()) {
    const auto [shallow, v] = queue.top();
    queue.pop();
    if (shallow > depth[v]) continue;
    for (const int w : neighbours[v]) {
      const double allowed = shallow + options.steepest * (x.row(v) - x.row(w)).norm();
      if (allowed >= depth[w]) continue;
      depth[w] = allowed;
      queue.emplace(allowed, w);
    }
  }
  return depth;
}

/// Marks the surface vertices whose depths shape some nodes: of a column, or of the triangle of a
/// centre point.
template <typename Nodes>
void mark(const IntermediateMesh& region, const SoftTissueMesh& tissue, const Nodes& nodes,
          std::vector<bool>& marked) {
  for (const int node : nodes) {
    if (node < 2 * tissue.surface_count) {
      marked[node % tissue.surface_count] = true;
      continue;
    }
    for (const int v : region.mesh.triangles.row(node - 2 * tissue.surface_count)) marked[v] = true;
  }
}

/// The vertices where the inner surface crosses itself or the skin.
std::vector<bool> crossing_vertices(const IntermediateMesh& region, const SoftTissueMesh& tissue) {
  std::vector<bool> marked(static_cast<std::size_t>(tissue.surface_count), false);
  const Triangles inner = inner_surface(region, tissue);
  const InnerSurfaceCrossings crossings = inner_surface_crossings(region, inner, tissue);
  for (const auto& [i, j] : crossings.with_itself) {
    mark(region, tissue, inner.row(i), marked);
    mark(region, tissue, inner.row(j), marked);
  }
  for (const auto& [i, skin] : crossings.with_skin) mark(region, tissue, inner.row(i), marked);
  return marked;
}

/// Makes the tissue at each vertex thinner by a factor. Centre points keep their places among the
/// inner vertices, but come as much nearer to the middle of them.
void thin(const IntermediateMesh& region, const Points& weights, const Eigen::VectorXd& factor,
          SoftTissueMesh& tissue) {
  Points& x = tissue.mesh.vertices;
  const Points centres = x.bottomRows(tissue.triangle_count);
  place_centre_points(region, weights, tissue);
  Points offsets = centres - x.bottomRows(tissue.triangle_count);
  for (int v = 0; v < tissue.surface_count; ++v) {
    x.row(tissue.inner(v)) = x.row(v) + factor[v] * (x.row(tissue.inner(v)) - x.row(v));
  }
  tissue.depth.array() *= factor.array();
  for (int f = 0; f < tissue.triangle_count; ++f) {
    offsets.row(f) *= factor(region.mesh.triangles.row(f)).minCoeff();
  }
  place_centre_points(region, weights, tissue);
  x.bottomRows(tissue.triangle_count) += offsets;
}

/// The factors that bring the inner vertices of some columns before the middle between their own
/// skin and the skin on the other side of a thin part of the face; 1 where there is none so near.
Eigen::VectorXd before_the_middle(const IntermediateMesh& region, const std::vector<bool>& where,
                                  const SoftTissueMesh& tissue) {
  constexpr double kPart = 0.45;   // of the way across
  constexpr double kStart = 0.02;  // of the depth: off the triangles of the vertex itself
  const BspTree skin(region.mesh);
  const Points normals = triangle_normals(region.mesh);
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(tissue.surface_count);
  for (int v = 0; v < tissue.surface_count; ++v) {
    if (!where[v]) continue;
    const Eigen::Vector3d x = tissue.mesh.vertices.row(v);
    const Eigen::Vector3d down = tissue.mesh.vertices.row(tissue.inner(v)).transpose() - x;
    const double depth = down.norm();
    const auto hit = skin.first_hit(x + kStart * down, down / depth, depth / kPart);
    if (!hit || normals.row(hit->triangle).dot(down) <= 0) continue;
    factor[v] = std::min(1.0, kPart * (hit->distance / depth + kStart));
  }
  return factor;
}

[[noreturn]] void refuse(const std::string& what, const Eigen::RowVector3d& at) {
  throw Error(ErrorKind::anatomy, "region",
              "the face is folded at LPS (" + std::to_string(at[0]) + ", " + std::to_string(at[1]) +
                  ", " + std::to_string(at[2]) + ") mm, so that " + what,
              "leave this place out of the region, or smooth the face there");
}

/// Moves and thins until the elements of the one layer are sound and lie nowhere twice.
void mend(const IntermediateMesh& region, const Points& weights,
          const std::vector<std::vector<int>>& neighbours, const RobustGeneratorOptions& options,
          SoftTissueMesh& tissue) {
  constexpr int kSweeps = 40;
  constexpr int kWidenAfter = 12;  // rounds: a fault that lasts takes in its neighbourhood
  bool came_before_the_middle = false;
  for (int round = 0;; ++round) {
    const std::vector<int> flat_tets =
        untangle(options.smallest_volume_ratio * flat_volumes(region, tissue), kSweeps, tissue);
    std::vector<bool> faulty(static_cast<std::size_t>(tissue.surface_count), false);
    for (const int t : flat_tets) mark(region, tissue, tissue.mesh.tets.row(t), faulty);
    if (flat_tets.empty()) faulty = crossing_vertices(region, tissue);
    const auto place = std::find(faulty.begin(), faulty.end(), true);
    if (place == faulty.end()) return;
    if (round == options.mending_rounds) {
      refuse(flat_tets.empty() ? "tissue below it would cross itself however thin"
                               : "no tetrahedra fit below it",
             region.mesh.vertices.row(place - faulty.begin()));
    }
    for (int ring = 0; ring < round / kWidenAfter; ++ring) faulty = widened(faulty, neighbours);
    Eigen::VectorXd factor = Eigen::VectorXd::Ones(tissue.surface_count);
    for (int v = 0; v < tissue.surface_count; ++v) {
      if (faulty[v]) factor[v] = options.shrink;
    }
    // Tissue of a thin part need not be found by small steps from either side. Only once: a mesh
    // that still crosses itself then does so for another reason.
    if (flat_tets.empty() && !std::exchange(came_before_the_middle, true)) {
      factor = factor.cwiseMin(before_the_middle(region, faulty, tissue));
    }
    thin(region, weights, factor, tissue);
  }
}

}  // namespace

SoftTissueMesh st_generator(const IntermediateMesh& region, const Points& directions,
                            const Eigen::VectorXd& depth, const RobustGeneratorOptions& options) {
  SoftTissueMesh tissue = empty_mesh(region);
  const auto neighbours = vertex_neighbours(region.mesh);
  tissue.depth = limited_depths(region, directions, neighbours, depth, options);
  tissue.mesh.vertices.middleRows(tissue.surface_count, tissue.surface_count) =
      region.mesh.vertices + tissue.depth.asDiagonal() * directions;
  const Points weights = centre_weights(region.mesh);
  place_centre_points(region, weights, tissue);
  mend(region, weights, neighbours, options, tissue);
  add_layers(region, options.layers, options.smallest_volume_ratio, tissue);
  return tissue;
}

}  // namespace gnathion
