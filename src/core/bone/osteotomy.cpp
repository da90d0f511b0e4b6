#include "bone/osteotomy.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "bone/cut_box.h"
#include "geometry/triangle_mesh.h"

// All of CGAL's polygon mesh processing stays in this file: it takes minutes and gigabytes to
// compile.
namespace gnathion {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw Error(ErrorKind::anatomy, "segment", problem, remedy);
}

// --- the cut as a surface ------------------------------------------------------------------------

Mesh box_mesh(const BoxCut& box) {
  Mesh mesh;
  std::array<Mesh::Vertex_index, 8> v;
  for (std::size_t c = 0; c < 8; ++c) {
    const Eigen::Vector3d side((c & 1) ? 1 : -1, (c & 2) ? 1 : -1, (c & 4) ? 1 : -1);
    const Eigen::Vector3d p = box.centre + box.axes * side.cwiseProduct(box.half_extents);
    v[c] = mesh.add_vertex(Point(p.x(), p.y(), p.z()));
  }
  constexpr std::array<std::array<std::size_t, 4>, 6> sides = {
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  const bool mirrored = box.axes.determinant() < 0;
  for (auto side : sides) {
    if (mirrored) std::swap(side[1], side[3]);
    mesh.add_face(v[side[0]], v[side[1]], v[side[2]]);
    mesh.add_face(v[side[0]], v[side[2]], v[side[3]]);
  }
  return mesh;
}

// --- between our mesh and CGAL's ----------------------------------------------------------------

/// For each corner (3·triangle + k) the vertex, with vertices doubled where two sheets only touch
/// in one: CGAL's mesh cannot hold those. Returns for each of these vertices the original one.
std::vector<int> split_pinched(const TriangleMesh& mesh, const std::vector<Edge>& edges,
                               std::vector<int>& corner_vertex) {
  const auto count = static_cast<std::size_t>(3 * mesh.triangles.rows());
  std::vector<int> parent(count);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int c) {
    while (parent[static_cast<std::size_t>(c)] != c) {
      int& p = parent[static_cast<std::size_t>(c)];
      p = parent[static_cast<std::size_t>(p)];
      c = p;
    }
    return c;
  };
  const auto corner = [&](int triangle, int vertex) {
    int k = 0;
    while (mesh.triangles(triangle, k) != vertex) ++k;
    return 3 * triangle + k;
  };
  for (const Edge& edge : edges) {
    for (const int v : {edge.a, edge.b}) {
      const int a = root(corner(edge.left, v)), b = root(corner(edge.right, v));
      parent[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  }
  std::vector<int> original;
  corner_vertex.assign(count, -1);
  for (std::size_t c = 0; c < count; ++c) {
    const auto r = static_cast<std::size_t>(root(static_cast<int>(c)));
    if (corner_vertex[r] < 0) {
      corner_vertex[r] = static_cast<int>(original.size());
      original.push_back(mesh.triangles(static_cast<Eigen::Index>(c / 3), static_cast<int>(c % 3)));
    }
    corner_vertex[c] = corner_vertex[r];
  }
  return original;
}

/// edges: of the mesh, which must be closed.
Mesh to_cgal(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
  std::vector<int> corner_vertex;
  const std::vector<int> original = split_pinched(mesh, edges, corner_vertex);
  Mesh out;
  const auto faces = static_cast<Mesh::size_type>(mesh.triangles.rows());
  out.reserve(static_cast<Mesh::size_type>(original.size()), 3 * faces / 2, faces);
  for (const int v : original) {
    out.add_vertex(Point(mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)));
  }
  for (std::size_t c = 0; c < corner_vertex.size(); c += 3) {
    const auto vertex = [&](std::size_t k) {
      return Mesh::Vertex_index(static_cast<Mesh::size_type>(corner_vertex[c + k]));
    };
    if (out.add_face(vertex(0), vertex(1), vertex(2)) == Mesh::null_face()) {
      refuse("the bone surface is not a two-manifold", "make the bone surface again from the CT");
    }
  }
  return out;
}

TriangleMesh from_cgal(Mesh& mesh) {
  mesh.collect_garbage();
  TriangleMesh out;
  out.vertices.resize(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
  out.triangles.resize(static_cast<Eigen::Index>(mesh.number_of_faces()), 3);
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    out.vertices.row(static_cast<Eigen::Index>(v.idx())) << p.x(), p.y(), p.z();
  }
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      out.triangles(static_cast<Eigen::Index>(f.idx()), k++) = static_cast<int>(v.idx());
    }
  }
  return out;
}

TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
  Eigen::Index vertices = 0, triangles = 0;
  for (const TriangleMesh& part : parts) {
    vertices += part.vertices.rows();
    triangles += part.triangles.rows();
  }
  TriangleMesh all;
  all.vertices.resize(vertices, 3);
  all.triangles.resize(triangles, 3);
  Eigen::Index v = 0, t = 0;
  for (const TriangleMesh& part : parts) {
    all.vertices.middleRows(v, part.vertices.rows()) = part.vertices;
    all.triangles.middleRows(t, part.triangles.rows()) =
        part.triangles.array() + static_cast<int>(v);
    v += part.vertices.rows();
    t += part.triangles.rows();
  }
  return all;
}

// --- pieces -------------------------------------------------------------------------------------

struct Piece {
  TriangleMesh mesh;
  double volume = 0;
};

/// The connected components. One pass over the triangles: a cut through spongy bone leaves
/// hundreds.
std::vector<Piece> pieces_of(const TriangleMesh& mesh) {
  const std::vector<int> component = triangle_components(mesh);
  std::vector<std::vector<int>> triangles;
  for (std::size_t t = 0; t < component.size(); ++t) {
    const auto c = static_cast<std::size_t>(component[t]);
    if (c >= triangles.size()) triangles.resize(c + 1);
    triangles[c].push_back(static_cast<int>(t));
  }
  std::vector<Piece> pieces(triangles.size());
  std::vector<int> vertex_in_piece(static_cast<std::size_t>(mesh.vertices.rows()), -1);
  for (std::size_t c = 0; c < pieces.size(); ++c) {
    TriangleMesh& piece = pieces[c].mesh;
    piece.triangles = mesh.triangles(triangles[c], Eigen::all);
    std::vector<int> vertices;
    for (int& v : piece.triangles.reshaped()) {
      int& index = vertex_in_piece[static_cast<std::size_t>(v)];
      if (index < 0) {
        index = static_cast<int>(vertices.size());
        vertices.push_back(v);
      }
      v = index;
    }
    piece.vertices = mesh.vertices(vertices, Eigen::all);
    pieces[c].volume = signed_volume(piece);
  }
  return pieces;
}

double volume_of(const std::vector<Piece>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), 0.0,
                         [](double sum, const Piece& piece) { return sum + piece.volume; });
}

/// Distance from p to the nearest vertex.
double distance_to(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  return std::sqrt((mesh.vertices.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff());
}

bool contains(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  const Mesh solid = to_cgal(mesh, edges_of(mesh, "bone surface"));
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(solid);
  return side(Point(p.x(), p.y(), p.z())) != CGAL::ON_UNBOUNDED_SIDE;
}

// --- the cut ------------------------------------------------------------------------------------

/// Axis-parallel bounds of the cut, a little enlarged.
Eigen::AlignedBox3d bounds_of(const BoxCut& box) {
  const Eigen::Vector3d half = box.axes.cwiseAbs() * box.half_extents;
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1e-3);
  return {box.centre - half - margin, box.centre + half + margin};
}

/// Whole components that reach into the cut's bounds, and all others.
struct Divided {
  TriangleMesh near;
  TriangleMesh far;
};

Divided divide(const TriangleMesh& bone, const BoxCut& box) {
  const Eigen::AlignedBox3d bounds = bounds_of(box);
  const std::vector<int> component = triangle_components(bone);
  const int count = *std::max_element(component.begin(), component.end()) + 1;
  std::vector<Eigen::AlignedBox3d> extent(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < component.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = bone.triangles(static_cast<Eigen::Index>(t), k);
      extent[static_cast<std::size_t>(component[t])].extend(bone.vertices.row(v).transpose());
    }
  }
  std::vector<bool> near(component.size());
  for (std::size_t t = 0; t < near.size(); ++t) {
    near[t] = extent[static_cast<std::size_t>(component[t])].intersects(bounds);
  }
  Divided parts;
  parts.near = sub_mesh(bone, near).mesh;
  near.flip();
  parts.far = sub_mesh(bone, near).mesh;
  return parts;
}

std::vector<Edge> closed_edges(const TriangleMesh& bone) {
  if (bone.triangles.rows() == 0) refuse("there is no bone surface", "choose another HU level");
  std::vector<Edge> edges = edges_of(bone, "bone surface");
  const auto open =
      std::count_if(edges.begin(), edges.end(), [](const Edge& e) { return e.right < 0; });
  if (open > 0) {
    refuse("the bone surface is open: " + std::to_string(open) + " edges have one triangle only",
           "make the bone surface again from the CT, or close its holes");
  }
  if (!(signed_volume(bone) > 0)) {
    refuse("the bone surface is inside out", "make the bone surface again from the CT");
  }
  return edges;
}

/// Corefinement needs a surface that does not cut itself where the blade goes.
void check_self_intersections(const Mesh& mesh, const BoxCut& box) {
  const Eigen::AlignedBox3d bounds = bounds_of(box);
  std::vector<Mesh::Face_index> faces;
  for (const auto f : mesh.faces()) {
    Eigen::AlignedBox3d extent;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      const Point& p = mesh.point(v);
      extent.extend(Eigen::Vector3d(p.x(), p.y(), p.z()));
    }
    if (extent.intersects(bounds)) faces.push_back(f);
  }
  if (PMP::does_self_intersect(faces, mesh)) {
    refuse("the bone surface cuts itself where the osteotomy goes",
           "make the bone surface again from the CT, at another HU level");
  }
}

struct CutMeshes {
  TriangleMesh inside;
  TriangleMesh outside;
};

CutMeshes corefined(const TriangleMesh& bone, const BoxCut& box) {
  Mesh solid = to_cgal(bone, closed_edges(bone));
  check_self_intersections(solid, box);
  Mesh cutter = box_mesh(box);
  Mesh inside, outside;
  std::array<boost::optional<Mesh*>, 4> results;
  results[PMP::Corefinement::INTERSECTION] = &inside;
  results[PMP::Corefinement::TM1_MINUS_TM2] = &outside;
  std::array<bool, 4> done{};
  try {
    done = PMP::corefine_and_compute_boolean_operations(
        solid, cutter, results, PMP::parameters::throw_on_self_intersection(true));
  } catch (const PMP::Corefinement::Self_intersection_exception&) {
    refuse("the bone surface cuts itself where the osteotomy goes",
           "make the bone surface again from the CT, at another HU level");
  } catch (const std::exception& failure) {
    refuse(std::string("the geometry kernel gave up: ") + failure.what(),
           "move or turn the cut a little");
  }
  if (!done[PMP::Corefinement::INTERSECTION] || !done[PMP::Corefinement::TM1_MINUS_TM2]) {
    refuse("the cut would leave a surface that is no two-manifold",
           "move or turn the cut a little");
  }
  return {from_cgal(inside), from_cgal(outside)};
}

void check_sum(double bone, double parts) {
  if (std::abs(bone - parts) <= 1e-4 * bone) return;
  refuse("the pieces' volumes do not add up: " + std::to_string(parts) + " mm3 of " +
             std::to_string(bone) + " mm3",
         "make the bone surface again from the CT, or move the cut a little");
}

SegmentResult take(std::vector<Piece> pieces, std::size_t chosen, TriangleMesh far) {
  SegmentResult result;
  std::vector<TriangleMesh> others;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (p != chosen) others.push_back(std::move(pieces[p].mesh));
  }
  others.push_back(std::move(far));
  result.segment = std::move(pieces[chosen].mesh);
  result.volume_mm3 = pieces[chosen].volume;
  result.remainder = joined(others);
  result.remainder_mm3 = signed_volume(result.remainder);
  return result;
}

SegmentResult cut_out(const TriangleMesh& bone, const BoxCut& box, const CutOptions& options) {
  Divided parts = divide(bone, box);
  std::vector<Piece> pieces;
  std::vector<Piece> outside;
  if (parts.near.triangles.rows() > 0) {
    const CutMeshes cut = corefined(parts.near, box);
    pieces = pieces_of(cut.inside);
    outside = pieces_of(cut.outside);
  }
  const auto largest =
      std::max_element(pieces.begin(), pieces.end(),
                       [](const auto& a, const auto& b) { return a.volume < b.volume; });
  const double volume = pieces.empty() ? 0 : largest->volume;
  if (!(volume >= options.minimum_volume)) {
    refuse("segment empty after the cut: the largest piece of bone in the box has " +
               std::to_string(std::lround(std::max(0.0, volume))) + " mm3",
           "move or enlarge the box so that the jaw lies in it (LPS mm)");
  }
  const auto chosen = static_cast<std::size_t>(largest - pieces.begin());
  std::move(outside.begin(), outside.end(), std::back_inserter(pieces));
  return take(std::move(pieces), chosen, std::move(parts.far));
}

using Place = std::array<double, 3>;

/// The component that each piece was cut from: cutting keeps the places of old vertices. −1 for a
/// chip that has none.
std::vector<int> origins(const std::vector<Piece>& pieces, const TriangleMesh& bone) {
  const std::vector<int> component = triangle_components(bone);
  std::map<Place, int> component_at;
  for (std::size_t t = 0; t < component.size(); ++t) {
    const auto p = bone.vertices.row(bone.triangles(static_cast<Eigen::Index>(t), 0));
    component_at[{p.x(), p.y(), p.z()}] = component[t];
  }
  std::vector<int> result;
  for (const Piece& piece : pieces) {
    int origin = -1;
    for (Eigen::Index v = 0; origin < 0 && v < piece.mesh.vertices.rows(); ++v) {
      const auto p = piece.mesh.vertices.row(v);
      const auto found = component_at.find({p.x(), p.y(), p.z()});
      if (found != component_at.end()) origin = found->second;
    }
    result.push_back(origin);
  }
  return result;
}

std::size_t piece_at(const std::vector<Piece>& pieces, const Eigen::Vector3d& seed) {
  std::size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const double distance = contains(pieces[p].mesh, seed) ? 0 : distance_to(pieces[p].mesh, seed);
    if (distance >= best) continue;
    best = distance;
    nearest = p;
  }
  return nearest;
}

SegmentResult saw_off(const TriangleMesh& bone, const PlateCut& plate, const CutOptions& options) {
  const std::string remedy = "enlarge the plate or move it so that it passes right through the jaw";
  const BoxCut box = box_of(plate);
  Divided parts = divide(bone, box);
  if (parts.near.triangles.rows() == 0) refuse("the plate does not touch the bone", remedy);
  const CutMeshes cut = corefined(parts.near, box);
  std::vector<Piece> pieces = pieces_of(cut.outside);
  if (cut.inside.triangles.rows() == 0) refuse("the plate does not touch the bone", remedy);
  if (pieces.empty()) refuse("the kerf swallows all of the bone", "make the kerf narrower");
  const std::size_t chosen = piece_at(pieces, plate.seed);
  const std::vector<int> origin = origins(pieces, parts.near);
  bool separated = false;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    separated = separated || (p != chosen && origin[p] >= 0 && origin[p] == origin[chosen] &&
                              pieces[p].volume >= options.minimum_volume);
  }
  if (pieces[chosen].volume < options.minimum_volume) {
    refuse("segment empty after the cut: the piece at the seed has " +
               std::to_string(std::lround(pieces[chosen].volume)) + " mm3",
           "move the seed into the piece to take, or move the plate");
  }
  if (!separated) {
    refuse("the plate is too small to separate anything: the bone at the seed stays in one piece",
           remedy);
  }
  SegmentResult result = take(std::move(pieces), chosen, std::move(parts.far));
  result.kerf_mm3 = volume_of(pieces_of(cut.inside));
  return result;
}

}  // namespace

BoxCut box_between(const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  BoxCut box;
  box.centre = 0.5 * (min + max);
  box.half_extents = 0.5 * (max - min);
  return box;
}

SegmentResult cut_segment(const TriangleMesh& bone, const BoundedCut& cut,
                          const CutOptions& options, Progress& progress) {
  const auto stage = progress.stage("osteotomy");
  box_of(cut);  // refuses what is no box
  closed_edges(bone);
  const double volume = signed_volume(bone);
  SegmentResult result = std::holds_alternative<BoxCut>(cut)
                             ? cut_out(bone, std::get<BoxCut>(cut), options)
                             : saw_off(bone, std::get<PlateCut>(cut), options);
  progress.check();
  check_sum(volume, result.volume_mm3 + result.remainder_mm3 + result.kerf_mm3);
  return result;
}

}  // namespace gnathion
