#include "tissue/inner_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace gnathion {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Corners = std::array<int, 3>;

/// A triangle's corners, those that it has in common with another one first, and how many.
Corners common_first(const Corners& triangle, const Corners& other, int& common) {
  Corners sorted{};
  std::size_t front = 0, back = 3;
  for (const int node : triangle) {
    const bool in_other = node == other[0] || node == other[1] || node == other[2];
    sorted[in_other ? front++ : --back] = node;
  }
  common = static_cast<int>(front);
  return sorted;
}

class CrossingTest {
 public:
  explicit CrossingTest(const Points& x) {
    points_.reserve(static_cast<std::size_t>(x.rows()));
    for (Eigen::Index i = 0; i < x.rows(); ++i) points_.emplace_back(x(i, 0), x(i, 1), x(i, 2));
  }

  /// Whether two triangles meet elsewhere than in what they have in common.
  bool operator()(const Corners& s, const Corners& t) const {
    int common = 0;
    const Corners a = common_first(s, t, common);
    const Corners b = common_first(t, s, common);
    if (common == 0) return apart(a, b, 0) ? false : CGAL::do_intersect(triangle(a), triangle(b));
    if (common == 1) {
      if (apart(a, b, 1) || apart(b, a, 1)) return false;
      return CGAL::do_intersect(segment(a), triangle(b)) ||
             CGAL::do_intersect(segment(b), triangle(a));
    }
    if (common == 3) return true;
    const Point &p = at(a[0]), &q = at(a[1]), &r = at(a[2]), &u = at(b[2]);
    return CGAL::coplanar(p, q, r, u) &&
           CGAL::coplanar_orientation(p, q, r, u) == CGAL::POSITIVE;  // folded onto each other
  }

 private:
  const Point& at(int node) const { return points_[node]; }
  Kernel::Triangle_3 triangle(const Corners& t) const { return {at(t[0]), at(t[1]), at(t[2])}; }
  Kernel::Segment_3 segment(const Corners& t) const { return {at(t[1]), at(t[2])}; }

  /// Whether the corners of b from `first` on are all strictly on one side of a's plane.
  bool apart(const Corners& a, const Corners& b, std::size_t first) const {
    const auto side = CGAL::orientation(at(a[0]), at(a[1]), at(a[2]), at(b[first]));
    if (side == CGAL::COPLANAR) return false;
    for (std::size_t k = first + 1; k < 3; ++k) {
      if (CGAL::orientation(at(a[0]), at(a[1]), at(a[2]), at(b[k])) != side) return false;
    }
    return true;
  }

  std::vector<Point> points_;
};

Corners corners_of(const Triangles& triangles, int f) {
  return {triangles(f, 0), triangles(f, 1), triangles(f, 2)};
}

/// The box of a triangle.
struct Box {
  Eigen::Array3d low, high;
  bool meets(const Box& other) const {
    return (low <= other.high).all() && (other.low <= high).all();
  }
};

std::vector<Box> boxes_of(const Points& x, const std::vector<Corners>& triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& t : triangles) {
    const Eigen::Array3d a = x.row(t[0]), b = x.row(t[1]), c = x.row(t[2]);
    boxes.push_back({a.min(b).min(c), a.max(b).max(c)});
  }
  return boxes;
}

/// Triangles in the cells of a regular grid: triangles of about one size, as these, are found in a
/// third of the time that CGAL's box_intersection_d takes.
class TriangleGrid {
 public:
  explicit TriangleGrid(const std::vector<Box>& boxes) : boxes_(boxes) {
    if (boxes.empty()) return;
    origin_ = boxes.front().low;
    double mean = 0, largest = 0;
    for (const Box& box : boxes) {
      origin_ = origin_.min(box.low);
      const double size = (box.high - box.low).maxCoeff();
      mean += size / static_cast<double>(boxes.size());
      largest = std::max(largest, size);
    }
    // Not so small that a large triangle among small ones fills very many cells.
    constexpr double kMostCells = 16;
    cell_ = std::max({2 * mean, largest / kMostCells, 1e-9});
    fill();
  }

  /// Calls what(i, j), i < j, once for any two triangles whose boxes meet.
  template <typename What>
  void for_pairs(const What& what) const {
    for (std::size_t bucket = 0; bucket + 1 < start_.size(); ++bucket) {
      for (int p = start_[bucket]; p < start_[bucket + 1]; ++p) {
        for (int q = start_[bucket]; q < p; ++q) {
          const auto& [i, cell_of_i] = entries_[q];
          const auto& [j, cell_of_j] = entries_[p];
          if (cell_of_i != cell_of_j || !boxes_[i].meets(boxes_[j])) continue;
          // Of the cells that both are in, the one with the least corner of what they share counts.
          if (key(cell(boxes_[i].low.max(boxes_[j].low))) != cell_of_i) continue;
          what(std::min(i, j), std::max(i, j));
        }
      }
    }
  }

 private:
  using Cell = Eigen::Array<std::int64_t, 3, 1>;
  struct Entry {
    int triangle = 0;
    std::uint64_t cell = 0;
  };

  Cell cell(const Eigen::Array3d& point) const {
    return ((point - origin_) / cell_).floor().cast<std::int64_t>();
  }
  static std::uint64_t key(const Cell& c) {
    constexpr int kBits = 21;
    return static_cast<std::uint64_t>(c[0] | c[1] << kBits | c[2] << 2 * kBits);
  }
  std::size_t bucket(std::uint64_t cell) const {
    return (cell * 0x9E3779B97F4A7C15ULL >> 20U) % (start_.size() - 1);  // Fibonacci hashing
  }

  template <typename What>
  void for_cells(const What& what) const {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Cell low = cell(boxes_[i].low), high = cell(boxes_[i].high);
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        for (std::int64_t y = low[1]; y <= high[1]; ++y) {
          for (std::int64_t x = low[0]; x <= high[0]; ++x) {
            what(static_cast<int>(i), key({x, y, z}));
          }
        }
      }
    }
  }

  void fill() {
    start_.assign(4 * boxes_.size() + 2, 0);
    for_cells([&](int, std::uint64_t cell) { ++start_[bucket(cell) + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    entries_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for_cells([&](int i, std::uint64_t cell) { entries_[next[bucket(cell)]++] = {i, cell}; });
  }

  const std::vector<Box>& boxes_;
  Eigen::Array3d origin_ = Eigen::Array3d::Zero();
  double cell_ = 1;
  std::vector<int> start_;  ///< of each bucket, in entries_
  std::vector<Entry> entries_;
};

}  // namespace

Triangles inner_surface(const IntermediateMesh& region, const SoftTissueMesh& tissue) {
  std::vector<Corners> triangles;
  for (const Edge& edge : region.edges) {
    if (edge.right == -1) continue;
    const int cf = tissue.centre(edge.left), cg = tissue.centre(edge.right);
    triangles.push_back({cf, cg, tissue.inner(edge.a)});
    triangles.push_back({cf, tissue.inner(edge.b), cg});
  }
  Triangles rows(triangles.size(), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) << triangles[i][0], triangles[i][1], triangles[i][2];
  }
  return rows;
}

InnerSurfaceCrossings inner_surface_crossings(const IntermediateMesh& region,
                                              const Triangles& inner,
                                              const SoftTissueMesh& tissue) {
  std::vector<Corners> triangles;
  for (int f = 0; f < inner.rows(); ++f) triangles.push_back(corners_of(inner, f));
  const int first_of_skin = static_cast<int>(triangles.size());
  for (int f = 0; f < region.mesh.triangles.rows(); ++f) {
    triangles.push_back(corners_of(region.mesh.triangles, f));
  }
  const CrossingTest cross(tissue.mesh.vertices);
  const std::vector<Box> boxes = boxes_of(tissue.mesh.vertices, triangles);
  InnerSurfaceCrossings crossings;
  TriangleGrid(boxes).for_pairs([&](int i, int j) {
    if (i >= first_of_skin || !cross(triangles[i], triangles[j])) return;
    if (j < first_of_skin) {
      crossings.with_itself.push_back({i, j});
    } else {
      crossings.with_skin.push_back({i, j - first_of_skin});
    }
  });
  std::sort(crossings.with_itself.begin(), crossings.with_itself.end());
  std::sort(crossings.with_skin.begin(), crossings.with_skin.end());
  return crossings;
}

}  // namespace gnathion
