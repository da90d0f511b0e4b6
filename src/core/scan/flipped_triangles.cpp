#include <Eigen/Geometry>
#include <cmath>

#include "scan/half_edges.h"
#include "scan/scan_problems.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

struct Neighbour {
  int triangle;
  bool agrees;  ///< it runs along the common edge the other way
};

std::vector<std::vector<Neighbour>> neighbours_of(const TriangleMesh& surface) {
  std::vector<std::vector<Neighbour>> neighbours(
      static_cast<std::size_t>(surface.triangles.rows()));
  const std::vector<HalfEdge> edges = half_edges(surface);
  for_edges(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 2) return;
    const HalfEdge &a = edges[begin], &b = edges[begin + 1];
    const bool agrees = a.upward != b.upward;
    neighbours[a.triangle].push_back({b.triangle, agrees});
    neighbours[b.triangle].push_back({a.triangle, agrees});
  });
  return neighbours;
}

/// Normal times twice the area.
Vector3d area_of(const TriangleMesh& surface, int triangle) {
  const auto t = surface.triangles.row(triangle);
  const Vector3d a = surface.vertices.row(t[0]);
  return (surface.vertices.row(t[1]).transpose() - a)
      .cross(surface.vertices.row(t[2]).transpose() - a);
}

Vector3d middle_of(const TriangleMesh& surface, int triangle) {
  const auto t = surface.triangles.row(triangle);
  return (surface.vertices.row(t[0]) + surface.vertices.row(t[1]) + surface.vertices.row(t[2]))
             .transpose() /
         3;
}

/// Whether the whole piece is to be turned once its triangles agree.
bool is_inside_out(const TriangleMesh& surface, const std::vector<int>& piece,
                   const std::vector<bool>& turned) {
  Vector3d centre = Vector3d::Zero();
  double area = 0, turned_area = 0;
  for (const int f : piece) {
    const double own = area_of(surface, f).norm();
    centre += own * middle_of(surface, f);
    area += own;
    if (turned[f]) turned_area += own;
  }
  if (area == 0) return false;
  centre /= area;
  double volume = 0;
  for (const int f : piece) {
    volume += (turned[f] ? -1 : 1) * area_of(surface, f).dot(middle_of(surface, f) - centre);
  }
  // Of a sphere this is 0.28; below, a sheet that bulges by less than some hundredth of its width.
  constexpr double kTooFlat = 0.01;
  if (std::abs(volume) < kTooFlat * std::pow(area, 1.5)) return turned_area > area / 2;
  return volume < 0;
}

}  // namespace

std::vector<bool> flipped_triangles(const TriangleMesh& surface) {
  const auto neighbours = neighbours_of(surface);
  std::vector<bool> flipped(neighbours.size(), false), seen(neighbours.size(), false);
  for (std::size_t first = 0; first < neighbours.size(); ++first) {
    if (seen[first]) continue;
    std::vector<int> piece{static_cast<int>(first)};
    seen[first] = true;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const int f = piece[i];
      for (const Neighbour& n : neighbours[f]) {
        if (seen[n.triangle]) continue;  // of a Möbius strip some edge stays inconsistent
        seen[n.triangle] = true;
        flipped[n.triangle] = n.agrees ? flipped[f] : !flipped[f];
        piece.push_back(n.triangle);
      }
    }
    if (!is_inside_out(surface, piece, flipped)) continue;
    for (const int f : piece) flipped[f] = !flipped[f];
  }
  return flipped;
}

}  // namespace gnathion
