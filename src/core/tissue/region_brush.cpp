#include "tissue/region_brush.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

namespace gnathion {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

std::vector<double> triangle_areas(const TriangleMesh& mesh) {
  std::vector<double> areas(static_cast<std::size_t>(mesh.triangles.rows()));
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(f, 0));
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(f, 1));
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(f, 2));
    areas[f] = (b - a).cross(c - a).norm() / 2;
  }
  return areas;
}

/// The two sides of an edge, found by sorting, which is sooner done than a table of edges.
std::vector<int> triangles_across(const Triangles& triangles) {
  std::vector<std::pair<std::uint64_t, int>> sides;
  sides.reserve(static_cast<std::size_t>(triangles.size()));
  for (int f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles(f, k), triangles(f, (k + 1) % 3));
      sides.emplace_back(static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint64_t>(high),
                         3 * f + k);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<int> across(sides.size(), -1);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].first == sides[i].first) ++end;
    if (end == i + 2) {
      across[sides[i].second] = sides[i + 1].second / 3;
      across[sides[i + 1].second] = sides[i].second / 3;
    }
    i = end;
  }
  return across;
}

/// The triangles of each vertex, in one list with where each vertex's part begins.
void list_triangles(const TriangleMesh& mesh, std::vector<int>& start, std::vector<int>& of) {
  start.assign(static_cast<std::size_t>(mesh.vertices.rows()) + 1, 0);
  for (const int v : mesh.triangles.reshaped<Eigen::RowMajor>()) ++start[v + 1];
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  of.resize(static_cast<std::size_t>(mesh.triangles.size()));
  std::vector<int> next = start;
  for (int f = 0; f < mesh.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) of[next[mesh.triangles(f, k)]++] = f;
  }
}

}  // namespace

SurfaceBrush::SurfaceBrush(TriangleMesh face)
    : face_(std::move(face)),
      areas_(triangle_areas(face_)),
      across_(triangles_across(face_.triangles)) {
  list_triangles(face_, triangle_start_, triangle_of_);
  const auto n = static_cast<std::size_t>(face_.vertices.rows());
  neighbour_start_.push_back(0);
  std::vector<int> around;
  for (std::size_t v = 0; v < n; ++v) {
    around.clear();
    for (int i = triangle_start_[v]; i < triangle_start_[v + 1]; ++i) {
      for (const int w : face_.triangles.row(triangle_of_[i])) {
        if (w != static_cast<int>(v)) around.push_back(w);
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    neighbour_of_.insert(neighbour_of_.end(), around.begin(), around.end());
    neighbour_start_.push_back(static_cast<int>(neighbour_of_.size()));
  }
  distance_.assign(n, kFar);
  settled_.assign(n, false);
}

SurfaceBrush::Range SurfaceBrush::neighbours(int vertex) const {
  return {neighbour_of_.data() + neighbour_start_[vertex],
          neighbour_of_.data() + neighbour_start_[vertex + 1]};
}

double SurfaceBrush::area_of(int vertex) const {
  double area = 0;
  for (int i = triangle_start_[vertex]; i < triangle_start_[vertex + 1]; ++i) {
    area += areas_[triangle_of_[i]] / 3;
  }
  return area;
}

/// The distance of c when those of a and b are known, in the plane of the triangle: a at the
/// origin, b at (length, 0), c at (x, y). Infinite when the way to c does not cross the edge a b.
double SurfaceBrush::through_triangle(int a, int b, int c, Shape shape) const {
  const Eigen::RowVector3d ab = face_.vertices.row(b) - face_.vertices.row(a);
  const Eigen::RowVector3d ac = face_.vertices.row(c) - face_.vertices.row(a);
  const double length = ab.norm();
  if (length == 0) return kFar;
  const double x = ac.dot(ab) / length;
  const double y = std::sqrt(std::max(0.0, ac.squaredNorm() - x * x));
  const double ta = distance_[a], tb = distance_[b];
  double crossing = 0, distance = 0;
  if (shape == Shape::point) {
    const double source_x = (ta * ta - tb * tb + length * length) / (2 * length);
    const double below = std::sqrt(std::max(0.0, ta * ta - source_x * source_x));
    if (below + y == 0) return kFar;
    crossing = source_x + (x - source_x) * below / (y + below);
    distance = std::hypot(x - source_x, y + below);
  } else {
    const double along = (tb - ta) / length;
    if (std::abs(along) >= 1) return kFar;
    const double rise = std::sqrt(1 - along * along);
    crossing = x - along * y / rise;
    distance = ta + along * x + rise * y;
  }
  return crossing >= 0 && crossing <= length ? distance : kFar;
}

/// Dijkstra's order over the vertices, with distances through triangles as well as along edges.
/// distance_ holds them until forget(), those of vertices just beyond reach included.
std::vector<ReachedVertex> SurfaceBrush::march(const std::vector<Start>& starts, double reach,
                                               Shape shape, const std::vector<bool>* within) const {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](int v, double distance) {
    if (settled_[v] || distance >= distance_[v] || (within != nullptr && !(*within)[v])) return;
    if (distance_[v] == kFar) touched_.push_back(v);
    distance_[v] = distance;
    queue.emplace(distance, v);
  };
  for (const Start& start : starts) offer(start.vertex, start.distance);
  std::vector<ReachedVertex> reached;
  while (!queue.empty()) {
    const auto [distance, u] = queue.top();
    queue.pop();
    if (settled_[u] || distance > distance_[u]) continue;
    if (distance > reach) break;
    settled_[u] = true;
    reached.push_back({u, distance});
    for (int i = triangle_start_[u]; i < triangle_start_[u + 1]; ++i) {
      const auto corners = face_.triangles.row(triangle_of_[i]);
      const int k = corners[0] == u ? 0 : corners[1] == u ? 1 : 2;
      const int v = corners[(k + 1) % 3], w = corners[(k + 2) % 3];
      for (const auto& [to, other] : {std::pair(v, w), std::pair(w, v)}) {
        offer(to, distance + (face_.vertices.row(to) - face_.vertices.row(u)).norm());
        if (settled_[other]) offer(to, through_triangle(u, other, to, shape));
      }
    }
  }
  return reached;
}

void SurfaceBrush::forget() const {
  for (const int v : touched_) {
    distance_[v] = kFar;
    settled_[v] = false;
  }
  touched_.clear();
}

std::vector<SurfaceBrush::Start> SurfaceBrush::starts_at(const SurfacePoint& centre) const {
  const Eigen::RowVector3d middle = centre.position(face_.triangles, face_.vertices).transpose();
  std::vector<Start> starts;
  for (const int v : face_.triangles.row(centre.triangle)) {
    starts.push_back({v, (face_.vertices.row(v) - middle).norm()});
  }
  return starts;
}

std::vector<ReachedVertex> SurfaceBrush::disc(const SurfacePoint& centre, double radius) const {
  const std::vector<Start> starts = starts_at(centre);
  const auto nearest =
      std::min_element(starts.begin(), starts.end(),
                       [](const Start& a, const Start& b) { return a.distance < b.distance; });
  std::vector<ReachedVertex> reached =
      march(starts, std::max(radius, nearest->distance), Shape::point, nullptr);
  forget();
  return reached;
}

std::vector<std::array<EdgePoint, 2>> SurfaceBrush::circle(const SurfacePoint& centre,
                                                           double radius) const {
  march(starts_at(centre), radius, Shape::point, nullptr);
  std::vector<std::array<EdgePoint, 2>> segments;
  for (const int v : touched_) {
    if (!settled_[v]) continue;
    for (int i = triangle_start_[v]; i < triangle_start_[v + 1]; ++i) {
      const auto corners = face_.triangles.row(triangle_of_[i]);
      // Each triangle once: at the first of its corners that lies within.
      const auto first = std::find_if(corners.begin(), corners.end(),
                                      [&](int corner) { return bool(settled_[corner]); });
      if (*first != v) continue;
      std::array<EdgePoint, 2> ends;
      std::size_t count = 0;
      for (int k = 0; k < 3; ++k) {
        int a = corners[k], b = corners[(k + 1) % 3];
        if (settled_[a] == settled_[b]) continue;
        if (settled_[b]) std::swap(a, b);
        if (distance_[b] == kFar) continue;
        ends[count++] = {a, b, (radius - distance_[a]) / (distance_[b] - distance_[a])};
      }
      if (count == 2) segments.push_back(ends);
    }
  }
  forget();
  return segments;
}

std::vector<ReachedVertex> SurfaceBrush::front(const std::vector<int>& sources, double reach,
                                               const std::vector<bool>& within) const {
  std::vector<Start> starts;
  starts.reserve(sources.size());
  for (const int v : sources) {
    if (within[v]) starts.push_back({v, 0});
  }
  std::vector<ReachedVertex> reached = march(starts, reach, Shape::line, &within);
  forget();
  return reached;
}

}  // namespace gnathion
