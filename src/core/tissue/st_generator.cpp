#include "tissue/st_generator.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/tet_quality.h"

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

/// Whether a tet is one across an edge, (c_f, c_g, c, b): two centre points, no inner vertex.
bool is_across_edge(const SoftTissueMesh& tissue, Eigen::Index t) {
  return tissue.mesh.tets(t, 1) >= 2 * tissue.surface_count &&
         tissue.mesh.tets.row(t).tail<2>().maxCoeff() < tissue.surface_count;
}

/// For each tet, the surface vertices whose depths shape it: those it has, on either side, and the
/// triangle of a centre point.
std::vector<int> shaping_vertices(const IntermediateMesh& region, const SoftTissueMesh& tissue,
                                  Eigen::Index t) {
  std::vector<int> vertices;
  for (const int node : tissue.mesh.tets.row(t)) {
    if (node < 2 * tissue.surface_count) {
      vertices.push_back(node % tissue.surface_count);
    } else {
      const auto f = region.mesh.triangles.row(node - 2 * tissue.surface_count);
      vertices.insert(vertices.end(), f.begin(), f.end());
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
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

/// What is wrong with the tissue at a vertex.
enum class Fault : unsigned char { none, tangled, too_thin };

/// The faults at the vertices of inverted or too flat elements.
std::vector<Fault> find_faults(const IntermediateMesh& region, const Eigen::VectorXd& area,
                               const SoftTissueMesh& tissue, double smallest_volume_ratio) {
  std::vector<Fault> faults(static_cast<std::size_t>(tissue.surface_count), Fault::none);
  const Eigen::VectorXd volumes = tet_volumes(tissue.mesh);
  for (Eigen::Index t = 0; t < volumes.size(); ++t) {
    const std::vector<int> vertices = shaping_vertices(region, tissue, t);
    double flat = std::numeric_limits<double>::infinity();
    for (const int v : vertices) flat = std::min(flat, area[v] * tissue.depth[v] / 3);
    if (volumes[t] > smallest_volume_ratio * flat) continue;
    // Across a concave edge the centre points must lie below it: there the tissue is too thin.
    // Elsewhere inner points have passed each other.
    const Fault fault = is_across_edge(tissue, t) ? Fault::too_thin : Fault::tangled;
    for (const int v : vertices) faults[v] = std::max(faults[v], fault);
  }
  return faults;
}

/// The same faults, tangles also at the neighbours.
std::vector<Fault> widened(const std::vector<Fault>& faults,
                           const std::vector<std::vector<int>>& neighbours) {
  std::vector<Fault> wide = faults;
  for (std::size_t v = 0; v < faults.size(); ++v) {
    if (faults[v] != Fault::tangled) continue;
    for (const int w : neighbours[v]) wide[w] = std::max(wide[w], Fault::tangled);
  }
  return wide;
}

/// One round of repair: too thin tissue gets thicker, and where inner vertices have passed each
/// other each goes half way to the middle of its neighbours and a little towards the surface.
/// `most`: depth that no vertex exceeds, mm.
void repair(const IntermediateMesh& region, const std::vector<std::vector<int>>& neighbours,
            const std::vector<Fault>& faults, const Eigen::VectorXd& most, double shrink,
            SoftTissueMesh& tissue) {
  const auto inner = tissue.mesh.vertices.middleRows(tissue.surface_count, tissue.surface_count);
  const Points before = inner;
  for (int v = 0; v < tissue.surface_count; ++v) {
    if (faults[v] == Fault::none) continue;
    const Eigen::RowVector3d surface = region.mesh.vertices.row(v);
    Eigen::RowVector3d goal = before.row(v);
    if (faults[v] == Fault::too_thin) {
      // Only so far: tissue that a little more depth does not mend is tangled.
      goal = surface + (goal - surface) * std::min(1 / shrink, most[v] / (goal - surface).norm());
    } else {
      Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
      for (const int w : neighbours[v]) middle += before.row(w);
      middle /= static_cast<double>(neighbours[v].size());
      goal = surface + (1 + shrink) / 2 * ((goal + middle) / 2 - surface);
    }
    tissue.mesh.vertices.row(tissue.inner(v)) = goal;
    tissue.depth[v] = (goal - surface).norm();
  }
}

[[noreturn]] void refuse_fold(const Eigen::RowVector3d& at) {
  throw Error(ErrorKind::anatomy, "region",
              "the face is folded at LPS (" + std::to_string(at[0]) + ", " + std::to_string(at[1]) +
                  ", " + std::to_string(at[2]) + ") mm, so that no tetrahedra fit below it",
              "leave this place out of the region, or smooth the face there");
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
  const Eigen::VectorXd area = triangle_area_at_vertices(region.mesh);
  const Eigen::VectorXd most = (1.5 * tissue.depth).cwiseMax(2 * mean_edge_length(region.mesh));
  constexpr int kWidenAfter = 8;  // rounds: a tangle that lasts takes in its neighbourhood
  for (int round = 0;; ++round) {
    place_centre_points(region, weights, tissue);
    std::vector<Fault> faults = find_faults(region, area, tissue, options.smallest_volume_ratio);
    const auto worst = std::max_element(faults.begin(), faults.end());
    if (*worst == Fault::none) break;
    if (round == options.repair_rounds) {
      refuse_fold(region.mesh.vertices.row(worst - faults.begin()));
    }
    for (int ring = 0; ring < round / kWidenAfter; ++ring) faults = widened(faults, neighbours);
    repair(region, neighbours, faults, most, options.shrink, tissue);
  }
  add_layers(region, options.layers, options.smallest_volume_ratio, tissue);
  return tissue;
}

}  // namespace gnathion
