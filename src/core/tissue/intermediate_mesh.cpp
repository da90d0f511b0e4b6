#include "tissue/intermediate_mesh.h"

#include <algorithm>
#include <map>
#include <string>

#include "base/error.h"
#include "tissue/hidden.h"

namespace gnathion {
namespace {

const std::string kSubject = "region";

std::vector<bool> inside_triangles(const TriangleMesh& face, const std::vector<bool>& chosen) {
  std::vector<bool> keep(static_cast<std::size_t>(face.triangles.rows()));
  for (Eigen::Index f = 0; f < face.triangles.rows(); ++f) {
    keep[f] = chosen[face.triangles(f, 0)] && chosen[face.triangles(f, 1)] &&
              chosen[face.triangles(f, 2)];
  }
  return keep;
}

/// Keeps the piece with the most triangles. Returns how many pieces there were.
int keep_largest_piece(const TriangleMesh& face, std::vector<bool>& keep) {
  const SubMesh part = sub_mesh(face, keep);
  const std::vector<int> component = triangle_components(part.mesh);
  if (component.empty()) return 0;
  std::vector<int> size(
      static_cast<std::size_t>(1 + *std::max_element(component.begin(), component.end())));
  for (const int c : component) ++size[c];
  const auto largest = std::max_element(size.begin(), size.end()) - size.begin();
  for (std::size_t i = 0; i < component.size(); ++i) {
    keep[part.parent_triangle[i]] = component[i] == largest;
  }
  return static_cast<int>(size.size());
}

/// Drops triangles with two rim edges, and all triangles at vertices where the rim touches itself.
/// Returns whether anything was dropped.
bool drop_hanging_triangles(const TriangleMesh& face, std::vector<bool>& keep) {
  const SubMesh part = sub_mesh(face, keep);
  std::vector<int> rim_edges_of_triangle(static_cast<std::size_t>(part.mesh.triangles.rows()), 0);
  std::vector<int> rim_edges_of_vertex(static_cast<std::size_t>(part.mesh.vertices.rows()), 0);
  for (const Edge& edge : edges_of(part.mesh, kSubject)) {
    if (edge.right != -1) continue;
    ++rim_edges_of_triangle[edge.left];
    ++rim_edges_of_vertex[edge.a];
    ++rim_edges_of_vertex[edge.b];
  }
  bool dropped = false;
  for (Eigen::Index f = 0; f < part.mesh.triangles.rows(); ++f) {
    bool hangs = rim_edges_of_triangle[f] >= 2;
    for (int corner = 0; corner < 3; ++corner) {
      hangs = hangs || rim_edges_of_vertex[part.mesh.triangles(f, corner)] > 2;
    }
    if (!hangs) continue;
    keep[part.parent_triangle[f]] = false;
    dropped = true;
  }
  return dropped;
}

IntermediateMesh make_region(const TriangleMesh& face, const std::vector<bool>& keep) {
  SubMesh part = sub_mesh(face, keep);
  IntermediateMesh region{std::move(part.mesh), std::move(part.parent_vertex), {}, {}, {}, {}};
  region.edges = edges_of(region.mesh, kSubject);
  region.rim = rim_vertices(region.mesh, region.edges);
  if (std::find(region.rim.begin(), region.rim.end(), true) == region.rim.end()) {
    throw Error(ErrorKind::anatomy, kSubject,
                "it has no rim: the whole surface was chosen, so nothing would hold the face",
                "choose a smaller region (region.reach_mm, or fewer vertices)");
  }
  region.held = region.rim;
  return region;
}

/// The start of every rim vertex's loop, by following rim edges; −1 for the others.
std::vector<int> rim_loops(const IntermediateMesh& region) {
  std::vector<int> next(region.rim.size(), -1), loop(region.rim.size(), -1);
  for (const Edge& edge : region.edges) {
    if (edge.right == -1) next[edge.a] = edge.b;
  }
  for (int start = 0; start < static_cast<int>(next.size()); ++start) {
    for (int v = start; v != -1 && next[v] != -1 && loop[v] == -1; v = next[v]) loop[v] = start;
  }
  return loop;
}

/// Lets go of loops shorter than half the longest: holes within the region.
void free_holes(IntermediateMesh& region) {
  const std::vector<int> loop = rim_loops(region);
  std::map<int, double> length;
  for (const Edge& edge : region.edges) {
    if (edge.right != -1) continue;
    length[loop[edge.a]] +=
        (region.mesh.vertices.row(edge.a) - region.mesh.vertices.row(edge.b)).norm();
  }
  double longest = 0;
  for (const auto& [start, mm] : length) longest = std::max(longest, mm);
  for (std::size_t v = 0; v < loop.size(); ++v) {
    region.held[v] = loop[v] != -1 && length[loop[v]] >= longest / 2;
  }
}

/// The vertices of the face outside the region that are cut off by it: connected pieces of the rest
/// of the face that lie wholly within reach.
std::vector<int> enclosed_vertices(const TriangleMesh& face, const std::vector<int>& region,
                                   const std::vector<bool>& near) {
  std::vector<bool> done(near.size(), false);
  for (const int v : region) done[v] = true;
  const auto neighbours = vertex_neighbours(face);
  std::vector<int> enclosed;
  for (int start = 0; start < static_cast<int>(near.size()); ++start) {
    if (done[start] || neighbours[start].empty()) continue;
    std::vector<int> piece{start};
    done[start] = true;
    bool within = true;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      within = within && near[piece[k]];
      for (const int w : neighbours[piece[k]]) {
        if (done[w]) continue;
        done[w] = true;
        piece.push_back(w);
      }
    }
    if (within) enclosed.insert(enclosed.end(), piece.begin(), piece.end());
  }
  return enclosed;
}

/// Holds the rim of a hole again where visible skin lies beyond it: only a pocket, or a place where
/// the scan has nothing, goes along. \pre free_holes()
void hold_visible_holes(const TriangleMesh& face, const std::vector<std::vector<int>>& neighbours,
                        IntermediateMesh& region) {
  std::vector<bool> inside(neighbours.size(), false), beyond(neighbours.size(), false);
  for (const int v : region.face_vertex) inside[v] = true;
  for (std::size_t i = 0; i < region.rim.size(); ++i) {
    if (!region.rim[i] || region.held[i]) continue;
    for (const int w : neighbours[region.face_vertex[i]]) beyond[w] = !inside[w];
  }
  if (std::find(beyond.begin(), beyond.end(), true) == beyond.end()) return;
  const std::vector<bool> hidden = hidden_vertices(face, beyond);
  const std::vector<int> loop = rim_loops(region);
  std::map<int, int> more_hidden;  // by loop: neighbours beyond it that are hidden, less the others
  for (std::size_t i = 0; i < loop.size(); ++i) {
    if (loop[i] == -1 || region.held[i]) continue;
    for (const int w : neighbours[region.face_vertex[i]]) {
      if (beyond[w]) more_hidden[loop[i]] += hidden[w] ? 1 : -1;
    }
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto found = more_hidden.find(loop[i]);
    if (loop[i] != -1 && found != more_hidden.end() && found->second < 0) region.held[i] = true;
  }
}

/// The vertices of the face beyond holes that are not held: the pieces of the rest of the face that
/// touch the region there and nowhere else.
std::vector<int> beyond_free_holes(const std::vector<std::vector<int>>& neighbours,
                                   const IntermediateMesh& region) {
  enum : unsigned char { unseen, seen, free_rim, held_rim };
  std::vector<unsigned char> state(neighbours.size(), unseen);
  for (std::size_t i = 0; i < region.rim.size(); ++i) {
    state[region.face_vertex[i]] = region.rim[i] && !region.held[i] ? free_rim : held_rim;
  }
  std::vector<int> enclosed;
  for (int start = 0; start < static_cast<int>(state.size()); ++start) {
    if (state[start] != unseen) continue;
    std::vector<int> piece{start};
    state[start] = seen;
    bool touches_free = false, touches_held = false;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      for (const int w : neighbours[piece[k]]) {
        touches_free = touches_free || state[w] == free_rim;
        touches_held = touches_held || state[w] == held_rim;
        if (state[w] != unseen) continue;
        state[w] = seen;
        piece.push_back(w);
      }
    }
    if (touches_free && !touches_held) enclosed.insert(enclosed.end(), piece.begin(), piece.end());
  }
  return enclosed;
}

}  // namespace

IntermediateMesh suggest_region(const TriangleMesh& face, const BspTree& segment, double reach) {
  std::vector<bool> near(static_cast<std::size_t>(face.vertices.rows()));
  for (Eigen::Index v = 0; v < face.vertices.rows(); ++v) {
    near[v] = segment.nearest(face.vertices.row(v), reach).has_value();
  }
  const std::vector<bool> hidden = hidden_vertices(face, near);
  std::vector<bool> chosen(near.size());
  for (std::size_t v = 0; v < near.size(); ++v) chosen[v] = near[v] && !hidden[v];
  std::vector<bool> keep = inside_triangles(face, chosen);
  int pieces = keep_largest_piece(face, keep);
  while (pieces > 0 && drop_hanging_triangles(face, keep)) pieces = keep_largest_piece(face, keep);
  if (pieces == 0) {
    throw Error(
        ErrorKind::anatomy, kSubject,
        "no part of the face is within " + std::to_string(reach) + " mm of the bone segment",
        "check the photograph's transform and unit, or raise region.reach_mm");
  }
  IntermediateMesh region = make_region(face, keep);
  free_holes(region);
  region.enclosed = enclosed_vertices(face, region.face_vertex, near);
  return region;
}

IntermediateMesh region_of_vertices(const TriangleMesh& face, const std::vector<int>& vertices) {
  std::vector<bool> chosen(static_cast<std::size_t>(face.vertices.rows()));
  for (const int v : vertices) {
    if (v < 0 || v >= face.vertices.rows()) {
      throw Error(ErrorKind::anatomy, kSubject,
                  "vertex " + std::to_string(v) + " does not exist: the face has " +
                      std::to_string(face.vertices.rows()) + " (counted from 0)",
                  "give indices of the vertices of this face");
    }
    chosen[v] = true;
  }
  std::vector<bool> keep = inside_triangles(face, chosen);
  std::vector<bool> largest = keep;
  const int pieces = keep_largest_piece(face, largest);
  if (pieces == 0) {
    throw Error(ErrorKind::anatomy, kSubject, "its vertices span no triangle of the face",
                "choose a patch of neighbouring vertices");
  }
  if (pieces > 1) {
    throw Error(ErrorKind::anatomy, kSubject, "it is in " + std::to_string(pieces) + " pieces",
                "choose one connected region around the segment");
  }
  IntermediateMesh region = make_region(face, keep);
  free_holes(region);
  const auto neighbours = vertex_neighbours(face);
  hold_visible_holes(face, neighbours, region);
  region.enclosed = beyond_free_holes(neighbours, region);
  return region;
}

}  // namespace gnathion
