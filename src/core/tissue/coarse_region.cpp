#include "tissue/coarse_region.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "geometry/bsp_tree.h"

// All of CGAL's remeshing stays in this file.
namespace gnathion {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMS = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw Error(ErrorKind::anatomy, "region", problem, remedy);
}

Point point(const Points& x, Eigen::Index row) {
  return {x(row, 0), x(row, 1), x(row, 2)};
}

Mesh cgal_mesh(const TriangleMesh& surface) {
  Mesh mesh;
  for (Eigen::Index v = 0; v < surface.vertices.rows(); ++v) {
    mesh.add_vertex(point(surface.vertices, v));
  }
  const auto vertex = [](int v) { return Vertex(static_cast<Mesh::size_type>(v)); };
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    const auto t = surface.triangles.row(f);
    if (mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) != Mesh::null_face()) continue;
    refuse("its surface touches itself at a vertex of triangle " + std::to_string(f),
           "choose a region without pieces that hang together by a corner only");
  }
  return mesh;
}

TriangleMesh plain_mesh(Mesh& mesh) {
  mesh.collect_garbage();
  TriangleMesh surface{Points(mesh.number_of_vertices(), 3), Triangles(mesh.number_of_faces(), 3)};
  for (const Vertex v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    surface.vertices.row(static_cast<Eigen::Index>(v)) << p.x(), p.y(), p.z();
  }
  for (const Mesh::Face_index f : mesh.faces()) {
    int corner = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      surface.triangles(static_cast<Eigen::Index>(f), corner++) = static_cast<int>(v);
    }
  }
  return surface;
}

// --- the rim ------------------------------------------------------------------------------------

/// The loops of the rim, each its vertices in order.
std::vector<std::vector<int>> rim_loops(const IntermediateMesh& region) {
  std::vector<int> next(region.rim.size(), -1);
  for (const Edge& edge : region.edges) {
    if (edge.right == -1) next[edge.a] = edge.b;
  }
  std::vector<std::vector<int>> loops;
  for (std::size_t start = 0; start < next.size(); ++start) {
    if (next[start] == -1) continue;
    std::vector<int> loop;
    for (int v = static_cast<int>(start); next[v] != -1; v = std::exchange(next[v], -1)) {
      loop.push_back(v);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

double distance_to_segment(const Eigen::RowVector3d& p, const Eigen::RowVector3d& a,
                           const Eigen::RowVector3d& b) {
  const double squared = (b - a).squaredNorm();
  const double along = squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0;
  return (a + along * (b - a) - p).norm();
}

/// Positions in a loop of the vertices that stay on the rim: each as far from the one before as one
/// edge length allows without leaving the rim between them by more than `tolerance` mm, but not
/// nearer than half an edge. At least three.
std::vector<std::size_t> kept_of_loop(const Points& x, const std::vector<int>& loop, double edge_mm,
                                      double tolerance) {
  const std::size_t n = loop.size();
  std::vector<double> along{0};  // mm from the start
  for (std::size_t k = 0; k < n; ++k) {
    along.push_back(along.back() + (x.row(loop[(k + 1) % n]) - x.row(loop[k])).norm());
  }
  const double longest = std::min(edge_mm, along.back() / 3);
  std::vector<std::size_t> kept{0};
  for (;;) {
    const std::size_t from = kept.back();
    std::size_t next = from + 1;
    for (std::size_t to = from + 2; to <= n && along[to] - along[from] <= longest; ++to) {
      double leaves = 0;
      for (std::size_t k = from + 1; k < to; ++k) {
        leaves = std::max(
            leaves, distance_to_segment(x.row(loop[k]), x.row(loop[from]), x.row(loop[to % n])));
      }
      if (leaves > tolerance && along[to] - along[from] > longest / 2) break;
      next = to;
    }
    if (next >= n) return kept;
    kept.push_back(next);
  }
}

std::set<Point> kept_rim_points(const IntermediateMesh& dense, double edge_mm) {
  // The steps of the dense triangles are no shape of the rim's, though a coarser one is.
  const double steps = 0.7 * mean_edge_length(dense.mesh);
  const double tolerance = std::max(0.1 * edge_mm, std::min(0.2 * edge_mm, steps));
  std::set<Point> kept;
  for (const std::vector<int>& loop : rim_loops(dense)) {
    for (const std::size_t k : kept_of_loop(dense.mesh.vertices, loop, edge_mm, tolerance)) {
      kept.insert(point(dense.mesh.vertices, loop[k]));
    }
  }
  return kept;
}

/// The rim's vertices are held where the nearest vertex of the dense rim is.
void carry_rim_over(const IntermediateMesh& dense, IntermediateMesh& coarse) {
  coarse.held.assign(coarse.rim.size(), false);
  for (std::size_t v = 0; v < coarse.rim.size(); ++v) {
    if (!coarse.rim[v]) continue;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t w = 0; w < dense.rim.size(); ++w) {
      if (!dense.rim[w]) continue;
      const double squared = (coarse.mesh.vertices.row(static_cast<Eigen::Index>(v)) -
                              dense.mesh.vertices.row(static_cast<Eigen::Index>(w)))
                                 .squaredNorm();
      if (squared >= least) continue;
      least = squared;
      coarse.held[v] = dense.held[w];
    }
  }
}

// --- the surface --------------------------------------------------------------------------------

/// For CGAL: which edges are of the rim.
struct RimEdges {
  using key_type = Mesh::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const Mesh* mesh;
  friend bool get(const RimEdges& rim, Mesh::Edge_index e) { return rim.mesh->is_border(e); }
};

/// For CGAL: where a moved vertex goes back to on the dense surface.
struct ToSurface {
  const BspTree* surface;
  const Mesh* mesh;
  double reach;
  Point operator()(Vertex v) const {
    const Point& p = mesh->point(v);
    const auto nearest = surface->nearest({p.x(), p.y(), p.z()}, reach);
    if (!nearest) return p;
    return {nearest->point[0], nearest->point[1], nearest->point[2]};
  }
};

/// Collapses short edges away: half of the time of isotropic remeshing alone, and as near to the
/// surface.
void collapse_short_edges(double edge_mm, Mesh& mesh) {
  constexpr double kShort = 0.6;  // of an edge: the rest is for isotropic remeshing to even out
  const RimEdges rim{&mesh};
  SMS::edge_collapse(
      mesh, SMS::Edge_length_stop_predicate<double>(kShort * edge_mm),
      CGAL::parameters::edge_is_constrained_map(rim)
          .get_cost(SMS::Edge_length_cost<Mesh>())
          .get_placement(SMS::Constrained_placement<SMS::Midpoint_placement<Mesh>, RimEdges>(rim))
          .filter(SMS::Bounded_normal_change_filter<>()));
  mesh.collect_garbage();
}

TriangleMesh remeshed(const IntermediateMesh& dense, double edge_mm) {
  Mesh mesh = cgal_mesh(dense.mesh);
  collapse_short_edges(edge_mm, mesh);
  const std::set<Point> kept = kept_rim_points(dense, edge_mm);
  auto stays = mesh.add_property_map<Vertex, bool>("v:stays", false).first;
  for (const Vertex v : mesh.vertices()) {
    stays[v] = mesh.is_border(v) && kept.count(mesh.point(v)) > 0;
  }
  constexpr unsigned kRounds = 3;        // more change the shapes by less than a degree
  constexpr double kMeanOfTarget = 0.9;  // what the mean edge comes to
  const BspTree surface(dense.mesh);
  PMP::isotropic_remeshing(mesh.faces(), edge_mm / kMeanOfTarget, mesh,
                           CGAL::parameters::number_of_iterations(kRounds)
                               .vertex_is_constrained_map(stays)
                               .projection_functor(ToSurface{&surface, &mesh, 10 * edge_mm}));
  return plain_mesh(mesh);
}

DistanceStatistics distances(const IntermediateMesh& dense, const TriangleMesh& coarse) {
  const BspTree tree(coarse);
  Eigen::VectorXd mm(dense.mesh.vertices.rows());
  for (Eigen::Index v = 0; v < mm.size(); ++v) {
    mm[v] =
        tree.nearest(dense.mesh.vertices.row(v), std::numeric_limits<double>::infinity())->distance;
  }
  return distance_statistics(mm);
}

}  // namespace

CoarseRegion coarse_region(const IntermediateMesh& dense, const Points& face, double edge_mm) {
  if (!(edge_mm > 0) || !std::isfinite(edge_mm)) {
    refuse("an edge length of " + std::to_string(edge_mm) + " mm was asked for",
           "ask for edges longer than 0, about 2 mm");
  }
  if (mean_edge_length(dense.mesh) >= 0.75 * edge_mm) {
    return {dense, index_map(dense, face), distances(dense, dense.mesh)};
  }
  CoarseRegion coarse;
  coarse.region.mesh = remeshed(dense, edge_mm);
  constexpr Eigen::Index kFewest = 20;
  if (coarse.region.mesh.triangles.rows() < kFewest) {
    refuse("only " + std::to_string(coarse.region.mesh.triangles.rows()) +
               " triangles are left at edges of " + std::to_string(edge_mm) + " mm",
           "ask for shorter edges, or choose a larger region");
  }
  coarse.region.edges = edges_of(coarse.region.mesh, "region");
  coarse.region.rim = rim_vertices(coarse.region.mesh, coarse.region.edges);
  carry_rim_over(dense, coarse.region);
  coarse.region.enclosed = dense.enclosed;
  coarse.surface_map = barycentric_map(dense, coarse.region, face);
  coarse.distance = distances(dense, coarse.region.mesh);
  return coarse;
}

}  // namespace gnathion
