#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>

#include "scan/scan_problems.h"

namespace gnathion {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::Box_with_handle_d<double, 3, const int*>;

class Crossing {
 public:
  explicit Crossing(const TriangleMesh& surface) : surface_(surface) {}

  bool operator()(int f, int g) const {
    // Turned so that shared vertices come first, in the same order.
    std::array<int, 3> a = corners(f), b = corners(g);
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
      const auto same = std::find(b.begin() + shared, b.end(), a[i]);
      if (same == b.end()) continue;
      std::swap(a[shared], a[i]);
      std::iter_swap(b.begin() + shared++, same);
    }
    switch (shared) {
      case 0:
        return CGAL::do_intersect(triangle(a), triangle(b));
      case 1:
        return touches_beyond(a, b) || touches_beyond(b, a);
      case 2:
        return folded(a, b);
      default:
        return true;  // the same triangle twice
    }
  }

 private:
  std::array<int, 3> corners(int f) const {
    const auto t = surface_.triangles.row(f);
    return {t[0], t[1], t[2]};
  }
  Point point(int v) const {
    return {surface_.vertices(v, 0), surface_.vertices(v, 1), surface_.vertices(v, 2)};
  }
  Kernel::Triangle_3 triangle(const std::array<int, 3>& t) const {
    return {point(t[0]), point(t[1]), point(t[2])};
  }
  /// The first corner is shared: two triangles then cross when one's far side meets the other.
  bool touches_beyond(const std::array<int, 3>& a, const std::array<int, 3>& b) const {
    return CGAL::do_intersect(Kernel::Segment_3(point(a[1]), point(a[2])), triangle(b));
  }
  /// A side is shared: they lie in one plane, on the same side of it.
  bool folded(const std::array<int, 3>& a, const std::array<int, 3>& b) const {
    const Point p = point(a[0]), q = point(a[1]), r = point(a[2]), s = point(b[2]);
    return CGAL::coplanar(p, q, r, s) && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
  }

  const TriangleMesh& surface_;
};

}  // namespace

std::vector<std::array<int, 2>> crossing_triangles(const TriangleMesh& surface,
                                                   Progress& progress) {
  std::vector<int> rows;
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    if (!is_degenerate(surface, f)) rows.push_back(static_cast<int>(f));
  }
  std::vector<Box> boxes;
  boxes.reserve(rows.size());
  for (const int& f : rows) {
    const Points corners = surface.vertices(surface.triangles.row(f), Eigen::all);
    Eigen::RowVector3d low = corners.colwise().minCoeff(), high = corners.colwise().maxCoeff();
    boxes.emplace_back(low.data(), high.data(), &f);
  }
  const Crossing crossing(surface);
  std::vector<std::array<int, 2>> pairs;
  std::size_t looked = 0;
  const auto look = [&](const Box& a, const Box& b) {
    if (++looked % 4096 == 0) progress.check();
    const int f = std::min(*a.handle(), *b.handle()), g = std::max(*a.handle(), *b.handle());
    if (crossing(f, g)) pairs.push_back({f, g});
  };
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), look);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace gnathion
