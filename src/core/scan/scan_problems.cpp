#include "scan/scan_problems.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>

#include "geometry/same_places.h"
#include "geometry/triangle_mesh.h"
#include "scan/half_edges.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

void find_spare_vertices(const TriangleMesh& surface, ScanProblems& found) {
  const std::vector<int> first = first_at_same_place(surface.vertices);
  std::vector<bool> used(first.size(), false);
  for (const int v : surface.triangles.reshaped()) used[v] = true;
  for (std::size_t v = 0; v < first.size(); ++v) {
    const int row = static_cast<int>(v);
    if (first[v] != row) {
      found.duplicate_vertices.push_back(row);
    } else if (!used[v]) {
      found.unreferenced_vertices.push_back(row);
    }
  }
}

void find_bad_edges(const std::vector<HalfEdge>& edges, ScanProblems& found) {
  for_edges(edges, [&](std::size_t begin, std::size_t end) {
    const std::array<int, 2> edge{edges[begin].low, edges[begin].high};
    if (end - begin > 2) {
      found.non_manifold_edges.push_back(edge);
    } else if (end - begin == 2 && edges[begin].upward == edges[begin + 1].upward) {
      found.inconsistent_edges.push_back(edge);
    }
  });
}

/// Vertices whose triangles are not all neighbours of each other through edges at the vertex.
std::vector<int> touching_vertices(const TriangleMesh& surface,
                                   const std::vector<HalfEdge>& edges) {
  const auto corners = static_cast<std::size_t>(surface.triangles.size());
  std::vector<std::size_t> parent(corners);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  const auto corner = [&](int triangle, int vertex) {
    int k = 0;
    while (surface.triangles(triangle, k) != vertex) ++k;
    return static_cast<std::size_t>(3 * triangle + k);
  };
  for_edges(edges, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin + 1; e < end; ++e) {
      for (const int v : {edges[e].low, edges[e].high}) {
        parent[root(corner(edges[e].triangle, v))] = root(corner(edges[begin].triangle, v));
      }
    }
  });
  std::vector<std::size_t> fan(static_cast<std::size_t>(surface.vertices.rows()), corners);
  std::vector<bool> touching(fan.size(), false);
  for (std::size_t c = 0; c < corners; ++c) {
    const int v = surface.triangles.data()[c];
    if (fan[v] == corners) fan[v] = root(c);
    touching[v] = touching[v] || fan[v] != root(c);
  }
  std::vector<int> rows;
  for (std::size_t v = 0; v < touching.size(); ++v) {
    if (touching[v]) rows.push_back(static_cast<int>(v));
  }
  return rows;
}

}  // namespace

std::vector<BorderLoop> border_loops(const TriangleMesh& surface) {
  // Where several leave a vertex, they are taken in their own order.
  const std::vector<HalfEdge> edges = half_edges(surface);
  std::multimap<int, int> next;
  for_edges(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 1) return;
    const HalfEdge& e = edges[begin];
    next.emplace(e.upward ? e.low : e.high, e.upward ? e.high : e.low);
  });
  std::vector<BorderLoop> loops;
  while (!next.empty()) {
    BorderLoop loop;
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.vertices.back())) {
      if (loop.vertices.empty()) loop.vertices.push_back(at->first);
      loop.length += (surface.vertices.row(at->first) - surface.vertices.row(at->second)).norm();
      loop.vertices.push_back(at->second);
      next.erase(at);
      if (loop.vertices.back() == loop.vertices.front()) break;
    }
    // The last is the first again, unless faces run against each other there.
    if (loop.vertices.back() == loop.vertices.front()) loop.vertices.pop_back();
    loops.push_back(std::move(loop));
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const BorderLoop& a, const BorderLoop& b) { return a.length > b.length; });
  return loops;
}

std::vector<Island> islands_of(const TriangleMesh& surface) {
  const std::vector<int> component = triangle_components(surface);
  std::vector<Island> islands;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t f = 0; f < component.size(); ++f) {
    const auto c = static_cast<std::size_t>(component[f]);
    if (c >= islands.size()) {
      islands.resize(c + 1);
      boxes.resize(c + 1);
    }
    islands[c].triangles.push_back(static_cast<int>(f));
    for (const int v : surface.triangles.row(static_cast<Eigen::Index>(f))) {
      boxes[c].extend(surface.vertices.row(v).transpose());
    }
  }
  for (std::size_t c = 0; c < islands.size(); ++c) islands[c].size = boxes[c].diagonal().norm();
  std::stable_sort(islands.begin(), islands.end(),
                   [](const Island& a, const Island& b) { return a.size > b.size; });
  return islands;
}

bool is_degenerate(const TriangleMesh& surface, Eigen::Index triangle) {
  const auto t = surface.triangles.row(triangle);
  const Vector3d a = surface.vertices.row(t[0]), b = surface.vertices.row(t[1]),
                 c = surface.vertices.row(t[2]);
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() <= 1e-10 * longest;
}

ScanProblems scan_problems(const TriangleMesh& surface, Progress& progress) {
  const auto stage = progress.stage("look at the scan");
  ScanProblems found;
  find_spare_vertices(surface, found);
  const std::vector<HalfEdge> edges = half_edges(surface);
  progress.check();
  find_bad_edges(edges, found);
  found.non_manifold_vertices = touching_vertices(surface, edges);
  found.borders = border_loops(surface);
  progress.check();
  found.islands = islands_of(surface);
  const std::vector<bool> flipped = flipped_triangles(surface);
  for (std::size_t f = 0; f < flipped.size(); ++f) {
    const int triangle = static_cast<int>(f);
    if (flipped[f]) found.flipped_triangles.push_back(triangle);
    if (is_degenerate(surface, triangle)) found.degenerate_triangles.push_back(triangle);
  }
  found.crossing_triangles = crossing_triangles(surface, progress);
  return found;
}

std::vector<std::string> in_words(const ScanProblems& problems, const TriangleMesh& surface,
                                  const std::string& unit) {
  std::vector<std::string> lines{std::to_string(surface.vertices.rows()) + " vertices, " +
                                 std::to_string(surface.triangles.rows()) + " triangles"};
  const auto say = [&lines](std::size_t count, const char* one, const char* many,
                            const std::string& more = "") {
    if (count > 0) lines.push_back(std::to_string(count) + " " + (count == 1 ? one : many) + more);
  };
  const auto length = [&unit](double x) {
    std::ostringstream text;
    text.precision(3);
    text << x << " " << unit;
    return text.str();
  };
  say(problems.duplicate_vertices.size(), "vertex lies", "vertices lie",
      " exactly where another does (split seams)");
  say(problems.unreferenced_vertices.size(), "vertex is", "vertices are", " in no triangle");
  say(problems.degenerate_triangles.size(), "triangle has", "triangles have", " no area");
  say(problems.non_manifold_edges.size(), "edge has", "edges have", " more than two triangles");
  say(problems.non_manifold_vertices.size(), "vertex joins", "vertices join",
      " pieces that touch in a point only");
  say(problems.inconsistent_edges.size(), "edge lies", "edges lie",
      " between triangles that face opposite ways");
  say(problems.flipped_triangles.size(), "triangle faces", "triangles face", " inward");
  if (!problems.borders.empty()) {
    say(problems.borders.size(), "border", "borders",
        ", the longest " + length(problems.borders.front().length) + ", the shortest " +
            length(problems.borders.back().length));
  }
  if (problems.islands.size() > 1) {
    say(problems.islands.size(), "", "pieces that do not hang together",
        ", the smallest " + length(problems.islands.back().size) + " across");
  }
  say(problems.crossing_triangles.size(), "pair", "pairs", " of triangles run through each other");
  return lines;
}

}  // namespace gnathion
