#include "tissue/lip_slit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <string>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw Error(ErrorKind::anatomy, "region.lip_line", problem, remedy);
}

std::string text(const Vector3d& x) {
  return "LPS (" + std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " +
         std::to_string(x[2]) + ") mm";
}

Vector3d nearest_on_line(const std::vector<Vector3d>& line, const Vector3d& x) {
  Vector3d nearest = line.front();
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vector3d along = line[k + 1] - line[k];
    const double squared = along.squaredNorm();
    const double part =
        squared > 0 ? std::clamp((x - line[k]).dot(along) / squared, 0.0, 1.0) : 0.0;
    const Vector3d point = line[k] + part * along;
    if ((point - x).squaredNorm() < (nearest - x).squaredNorm()) nearest = point;
  }
  return nearest;
}

void require_on(const IntermediateMesh& region, const std::vector<Vector3d>& line) {
  constexpr double kOff = 3;   // mm: between the clicked points a line cuts the lips' curve short
  constexpr double kStep = 1;  // mm
  if (line.size() < 2) refuse("it has fewer than two points", "trace it from corner to corner");
  const BspTree surface(region.mesh);
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const int steps =
        std::max(1, static_cast<int>(std::ceil((line[k + 1] - line[k]).norm() / kStep)));
    for (int i = 0; i <= steps; ++i) {
      const Vector3d x = line[k] + (line[k + 1] - line[k]) * i / steps;
      if (surface.nearest(x, kOff)) continue;
      refuse("it leaves the region at " + text(x),
             "trace it on the skin, with more points where the lips curve, or paint the region "
             "there; where the mouth of the scan is open, no line is needed");
    }
  }
}

/// The vertex of the region at an end of the line.
int end_vertex(const IntermediateMesh& region, const Vector3d& place) {
  Eigen::Index nearest = 0;
  (region.mesh.vertices.rowwise() - place.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  if (region.rim[static_cast<std::size_t>(nearest)]) {
    refuse("it ends at the region's rim, at " + text(place),
           "end it at the corner of the mouth, or paint a larger region");
  }
  return static_cast<int>(nearest);
}

/// The way to each vertex: the one before it; −1 where there is none.
std::vector<int> ways_from(const IntermediateMesh& region, const std::vector<Vector3d>& line,
                           int start) {
  const Points& x = region.mesh.vertices;
  const auto neighbours = vertex_neighbours(region.mesh);
  const double mild = mean_edge_length(region.mesh) / 2;  // mm off the line: an edge counts twice
  std::vector<double> cost(neighbours.size(), kInfinity);
  std::vector<int> before(neighbours.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  cost[start] = 0;
  queue.emplace(0, start);
  while (!queue.empty()) {
    const auto [so_far, v] = queue.top();
    queue.pop();
    if (so_far > cost[v]) continue;
    for (const int w : neighbours[v]) {
      if (region.rim[w]) continue;
      const Vector3d middle = (x.row(v) + x.row(w)) / 2;
      const double off = (nearest_on_line(line, middle) - middle).norm() / mild;
      const double there = so_far + (x.row(v) - x.row(w)).norm() * (1 + off * off);
      if (there >= cost[w]) continue;
      cost[w] = there;
      before[w] = v;
      queue.emplace(there, w);
    }
  }
  return before;
}

/// Leaves out vertices whose neighbours on the path share an edge: one side of them would be a
/// triangle that hangs on by a corner.
std::vector<int> without_shortcuts(const IntermediateMesh& region, std::vector<int> path) {
  const auto neighbours = vertex_neighbours(region.mesh);
  for (std::size_t k = 1; k + 1 < path.size();) {
    const std::vector<int>& near = neighbours[path[k - 1]];
    if (std::binary_search(near.begin(), near.end(), path[k + 1])) {
      path.erase(path.begin() + static_cast<std::ptrdiff_t>(k));
    } else {
      ++k;
    }
  }
  return path;
}

}  // namespace

std::vector<int> lip_path(const IntermediateMesh& region, const std::vector<Vector3d>& line) {
  require_on(region, line);
  const int start = end_vertex(region, line.front()), end = end_vertex(region, line.back());
  const std::vector<int> before = ways_from(region, line, start);
  std::vector<int> path{end};
  while (path.back() != start && before[path.back()] != -1) path.push_back(before[path.back()]);
  const double allowed = 2 * mean_edge_length(region.mesh);
  const bool off = std::any_of(path.begin(), path.end(), [&](int v) {
    const Vector3d x = region.mesh.vertices.row(v);
    return (nearest_on_line(line, x) - x).norm() > allowed;
  });
  if (path.back() != start || off) {
    refuse("it crosses the region's rim, so that no way along the region follows it",
           "trace it where the lips are joined; where the mouth of the scan is open, no line is "
           "needed");
  }
  std::reverse(path.begin(), path.end());
  path = without_shortcuts(region, std::move(path));
  constexpr std::size_t kFewest = 5;
  if (path.size() >= kFewest) return path;
  refuse("it is too short: it spans " + std::to_string(path.size() - 1) + " edges of the region",
         "trace it from one corner of the mouth to the other, or remove it");
}

namespace {

/// Twice the area over the longest edge squared: 0.87 for an equilateral triangle, 0 for a sliver.
double roundness(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() / longest;
}

/// Whether the triangles of a vertex stay sound when it moves.
bool may_move(const TriangleMesh& mesh, const std::vector<int>& triangles, int vertex,
              const Vector3d& to) {
  constexpr double kRound = 0.3;
  constexpr double kTurn = 0.7;  // cosine
  for (const int t : triangles) {
    std::array<Vector3d, 3> before, after;
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = mesh.triangles(t, static_cast<Eigen::Index>(k));
      before[k] = mesh.vertices.row(v);
      after[k] = v == vertex ? to : before[k];
    }
    const Vector3d m = (before[1] - before[0]).cross(before[2] - before[0]).normalized();
    const Vector3d n = (after[1] - after[0]).cross(after[2] - after[0]).normalized();
    const double least = std::min(kRound, roundness(before[0], before[1], before[2]));
    if (m.dot(n) < kTurn || roundness(after[0], after[1], after[2]) < least) return false;
  }
  return true;
}

std::map<int, std::vector<int>> triangles_at(const TriangleMesh& mesh,
                                             const std::vector<int>& vertices) {
  std::map<int, std::vector<int>> triangles;
  for (const int v : vertices) triangles[v];
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    for (const int v : mesh.triangles.row(t)) {
      const auto found = triangles.find(v);
      if (found != triangles.end()) found->second.push_back(t);
    }
  }
  return triangles;
}

}  // namespace

IntermediateMesh drawn_to_line(const IntermediateMesh& region, const BspTree& surface,
                               const std::vector<int>& path, const std::vector<Vector3d>& line) {
  IntermediateMesh drawn = region;
  const auto triangles = triangles_at(region.mesh, path);
  constexpr int kRounds = 3;  // what a neighbour's place forbids at first it may allow later
  for (int round = 0; round < kRounds; ++round) {
    for (const int v : path) {
      const Vector3d x = drawn.mesh.vertices.row(v);
      const Vector3d aim = v == path.front()  ? line.front()
                           : v == path.back() ? line.back()
                                              : nearest_on_line(line, x);
      for (const double part : {1.0, 0.5, 0.25}) {
        const auto to = surface.nearest(x + part * (aim - x), kInfinity);
        if (!to || !may_move(drawn.mesh, triangles.at(v), v, to->point)) continue;
        drawn.mesh.vertices.row(v) = to->point;
        break;
      }
    }
  }
  return drawn;
}

namespace {

/// The triangles at an inner vertex of the path to the right of it: from the one before it on the
/// path anticlockwise, seen from outside, to the one after it.
std::vector<int> right_of(const TriangleMesh& mesh, const std::vector<int>& around, int before,
                          int vertex, int after) {
  std::map<int, std::pair<int, int>> next;  // from a corner: the triangle, and its other corner
  for (const int t : around) {
    const auto f = mesh.triangles.row(t);
    const int k = f[0] == vertex ? 0 : f[1] == vertex ? 1 : 2;
    next[f[(k + 1) % 3]] = {t, f[(k + 2) % 3]};
  }
  std::vector<int> right;
  for (int corner = before; corner != after; corner = next.at(corner).second) {
    right.push_back(next.at(corner).first);
  }
  return right;
}

/// What the rows of the surface map need to know of a slit.
struct Doubling {
  std::map<int, int> copy;                    ///< of a vertex before: the one to the right
  std::map<int, std::vector<int>> triangles;  ///< at it
  std::map<int, std::vector<int>> right;      ///< of those, the ones to the right
};

/// How much of the weight at a doubled vertex goes to the right: 0, 1/2 or 1. columns: of the row.
double share_to_the_right(const TriangleMesh& mesh, const Doubling& doubling, int vertex,
                          const std::vector<int>& columns) {
  const std::vector<int>& right = doubling.right.at(vertex);
  bool on_left = false, on_right = false;
  for (const int t : doubling.triangles.at(vertex)) {
    const auto f = mesh.triangles.row(t);
    const bool holds_row = std::all_of(columns.begin(), columns.end(), [&](int column) {
      return f[0] == column || f[1] == column || f[2] == column;
    });
    if (!holds_row) continue;
    (std::find(right.begin(), right.end(), t) != right.end() ? on_right : on_left) = true;
  }
  return on_left == on_right ? 0.5 : on_right ? 1 : 0;
}

SurfaceMap split_map(const TriangleMesh& mesh, const Doubling& doubling, const SurfaceMap& before) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(before.nonZeros()));
  std::vector<int> columns;
  for (int row = 0; row < before.rows(); ++row) {
    columns.clear();
    for (SurfaceMap::InnerIterator w(before, row); w; ++w) {
      columns.push_back(static_cast<int>(w.col()));
    }
    for (SurfaceMap::InnerIterator w(before, row); w; ++w) {
      const int column = static_cast<int>(w.col());
      const auto copy = doubling.copy.find(column);
      const double right =
          copy == doubling.copy.end() ? 0 : share_to_the_right(mesh, doubling, column, columns);
      if (right < 1) entries.emplace_back(row, column, (1 - right) * w.value());
      if (right > 0) entries.emplace_back(row, copy->second, right * w.value());
    }
  }
  SurfaceMap after(before.rows(), before.cols() + static_cast<Eigen::Index>(doubling.copy.size()));
  after.setFromTriplets(entries.begin(), entries.end());
  return after;
}

}  // namespace

LipSlit slit_along(const IntermediateMesh& region, const SurfaceMap& surface_map,
                   const std::vector<int>& path) {
  const TriangleMesh& whole = region.mesh;
  const Points normals = vertex_normals(whole);
  LipSlit slit{region, {}, {}};
  Doubling doubling{{}, triangles_at(whole, path), {}};
  Points& x = slit.region.mesh.vertices;
  const Eigen::Index count = x.rows();
  x.conservativeResize(count + static_cast<Eigen::Index>(path.size()) - 2, 3);
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const int v = path[k], copy = static_cast<int>(count) + static_cast<int>(k) - 1;
    x.row(copy) = whole.vertices.row(v);
    doubling.copy[v] = copy;
    doubling.right[v] = right_of(whole, doubling.triangles[v], path[k - 1], v, path[k + 1]);
    for (const int t : doubling.right[v]) {
      for (int& corner : slit.region.mesh.triangles.row(t)) {
        if (corner == v) corner = copy;
      }
    }
    const Vector3d along = whole.vertices.row(path[k + 1]) - whole.vertices.row(path[k - 1]);
    const Vector3d outward = normals.row(v);
    slit.vertices.push_back({v, copy, outward.cross(along).normalized()});
    if (!region.face_vertex.empty()) slit.region.face_vertex.push_back(region.face_vertex[v]);
    slit.region.held.push_back(false);
  }
  slit.region.edges = edges_of(slit.region.mesh, "region");
  slit.region.rim = rim_vertices(slit.region.mesh, slit.region.edges);
  slit.surface_map = split_map(whole, doubling, surface_map);
  return slit;
}

Points parted_directions(const std::vector<SlitVertex>& slit, const Points& directions) {
  constexpr double kApart = 0.05;  // sine of 3°: at a depth of 10 mm a gap of 1 mm
  Points parted = directions;
  const auto turn = [&](int vertex, const Vector3d& away) {
    const Vector3d d = parted.row(vertex);
    const double now = d.dot(away);
    if (now < kApart) parted.row(vertex) = (d + (kApart - now) * away).normalized();
  };
  for (const SlitVertex& v : slit) {
    turn(v.left, v.leftward);
    turn(v.right, -v.leftward);
  }
  return parted;
}

}  // namespace gnathion
