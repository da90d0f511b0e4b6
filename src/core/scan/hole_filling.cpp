#include <Eigen/Geometry>
#include <limits>
#include <numeric>
#include <utility>

#include "scan/half_edges.h"
#include "scan/scan_problems.h"
#include "scan/scan_repairs.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostVerticesOfHole = 300;  // the triangulation takes their cube

/// The triangulation of a loop with the least area: places in the loop.
class LeastArea {
 public:
  explicit LeastArea(const Points& loop)
      : loop_(loop),
        count_(static_cast<int>(loop.rows())),
        area_(static_cast<std::size_t>(count_) * count_, 0),
        apex_(area_.size(), -1) {
    for (int span = 2; span < count_; ++span) {
      for (int from = 0; from + span < count_; ++from) find(from, from + span);
    }
  }

  std::vector<Eigen::RowVector3i> triangles() const {
    std::vector<Eigen::RowVector3i> found;
    std::vector<std::pair<int, int>> open{{0, count_ - 1}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      if (to - from < 2) continue;
      const int apex = apex_[at(from, to)];
      found.emplace_back(from, apex, to);
      open.emplace_back(from, apex);
      open.emplace_back(apex, to);
    }
    return found;
  }

 private:
  std::size_t at(int from, int to) const {
    return static_cast<std::size_t>(from) * static_cast<std::size_t>(count_) +
           static_cast<std::size_t>(to);
  }
  void find(int from, int to) {
    double least = std::numeric_limits<double>::infinity();
    for (int apex = from + 1; apex < to; ++apex) {
      const Vector3d a = loop_.row(from), b = loop_.row(apex), c = loop_.row(to);
      const double area = area_[at(from, apex)] + area_[at(apex, to)] + (b - a).cross(c - a).norm();
      if (area >= least) continue;
      least = area;
      apex_[at(from, to)] = apex;
    }
    area_[at(from, to)] = least;
  }

  const Points& loop_;
  int count_;
  std::vector<double> area_;
  std::vector<int> apex_;
};

/// The material of the triangle at the border from a to b.
int material_beside(const RawScan& scan, const std::vector<HalfEdge>& edges, int a, int b) {
  const int low = std::min(a, b), high = std::max(a, b);
  const auto found = std::lower_bound(
      edges.begin(), edges.end(), std::pair(low, high),
      [](const HalfEdge& e, const auto& key) { return std::pair(e.low, e.high) < key; });
  return scan.material[static_cast<std::size_t>(found->triangle)];
}

void add_triangle(RawScan& scan, const Eigen::RowVector3i& corners, int material) {
  const Eigen::Index row = scan.surface.triangles.rows();
  scan.surface.triangles.conservativeResize(row + 1, 3);
  scan.corner_texture.conservativeResize(row + 1, 3);
  scan.surface.triangles.row(row) = corners;
  scan.corner_texture.row(row).setConstant(-1);
  scan.material.push_back(material);
}

/// Whether it bounds a hole that may be closed: no vertex twice, which would pinch the patch.
bool is_simple(const BorderLoop& loop) {
  std::vector<int> sorted = loop.vertices;
  std::sort(sorted.begin(), sorted.end());
  return sorted.size() >= 3 && sorted.size() <= kMostVerticesOfHole &&
         std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
}

}  // namespace

RepairedScan with_holes_filled(const RawScan& scan, double length) {
  RepairedScan repaired{scan, std::vector<int>(std::size_t(scan.surface.vertices.rows())), 0, ""};
  std::iota(repaired.vertex_of.begin(), repaired.vertex_of.end(), 0);
  const std::vector<HalfEdge> edges = half_edges(scan.surface);
  const std::vector<BorderLoop> borders = border_loops(scan.surface);
  std::size_t filled = 0, left = 0;
  for (std::size_t i = 1; i < borders.size(); ++i) {
    if (borders[i].length > length) continue;
    if (!is_simple(borders[i])) {
      ++left;
      continue;
    }
    ++filled;
    const std::vector<int>& loop = borders[i].vertices;
    const Points places = scan.surface.vertices(loop, Eigen::all);
    const int material = material_beside(scan, edges, loop[0], loop[1]);
    for (const Eigen::RowVector3i& t : LeastArea(places).triangles()) {
      // The border runs as its triangles do: the patch against it.
      add_triangle(repaired.scan, {loop[t[0]], loop[t[2]], loop[t[1]]}, material);
      ++repaired.changed;
    }
  }
  repaired.said = std::to_string(filled) + (filled == 1 ? " hole" : " holes") + " closed with " +
                  std::to_string(repaired.changed) + " triangles";
  if (left > 0)
    repaired.said += "; " + std::to_string(left) + " not, for their borders are tangled";
  return repaired;
}

}  // namespace gnathion
