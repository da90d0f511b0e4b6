#include "bone/section_spans.h"

#include <algorithm>
#include <cmath>

namespace gnathion {
namespace {

/// Where a triangle meets the plane, in the rectangle's coordinates.
struct Segment {
  Eigen::Vector2d a, b;
};

/// The point of the plane on an edge, always reckoned from the vertex beyond it: both triangles of
/// the edge then have the same point to the bit, and no row slips between them.
Eigen::Vector2d on_edge(const Rectangle& plane, const Eigen::Vector3d& beyond,
                        const Eigen::Vector3d& before) {
  const double from = (beyond - plane.centre).dot(plane.normal);
  const double to = (before - plane.centre).dot(plane.normal);
  const Eigen::Vector3d x = beyond + from / (from - to) * (before - beyond) - plane.centre;
  return {x.dot(plane.u), x.dot(plane.v)};
}

Segment segment_of(const TriangleMesh& mesh, const Rectangle& plane, int triangle,
                   const std::vector<std::uint8_t>& codes, std::uint8_t bit) {
  const auto corners = mesh.triangles.row(triangle);
  const auto is_beyond = [&](int k) {
    return (codes[static_cast<std::size_t>(corners(k))] & bit) != 0;
  };
  int lone = 0;  // the corner that is alone on its side
  while (is_beyond(lone) == is_beyond((lone + 1) % 3) ||
         is_beyond(lone) == is_beyond((lone + 2) % 3)) {
    ++lone;
  }
  const auto meet = [&](int other) {
    const Eigen::Vector3d p = mesh.vertices.row(corners(lone));
    const Eigen::Vector3d q = mesh.vertices.row(corners(other));
    return is_beyond(lone) ? on_edge(plane, p, q) : on_edge(plane, q, p);
  };
  return {meet((lone + 1) % 3), meet((lone + 2) % 3)};
}

/// Whether a part of the segment lies in |u| <= half.x, |v| <= half.y (Liang and Barsky 1984).
bool meets(const Segment& segment, const Eigen::Vector2d& half) {
  double from = 0, to = 1;
  for (int k = 0; k < 2; ++k) {
    const double start = segment.a(k), step = segment.b(k) - segment.a(k);
    if (step == 0) {
      if (std::abs(start) > half(k)) return false;
      continue;
    }
    const double t0 = (-half(k) - start) / step, t1 = (half(k) - start) / step;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  }
  return from <= to;
}

struct Crossing {
  double u;
  int triangle;
};

/// A row's crossings, paired: between the first and the second is bone, and so on.
void add_spans(std::vector<Crossing>& crossings, int row, double half_u, std::vector<Span>& spans) {
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.u < b.u; });
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    Span span{row, crossings[i].u, crossings[i + 1].u, crossings[i].triangle,
              crossings[i + 1].triangle};
    if (span.end <= -half_u || span.begin >= half_u) continue;
    if (span.begin < -half_u) {
      span.begin = -half_u;
      span.first = -1;
    }
    if (span.end > half_u) {
      span.end = half_u;
      span.last = -1;
    }
    spans.push_back(span);
  }
}

}  // namespace

RectangleSection section_of(const TriangleMesh& mesh, const Rectangle& rectangle,
                            const std::vector<int>& crossing,
                            const std::vector<std::uint8_t>& codes, std::uint8_t bit, double step) {
  RectangleSection section;
  section.rows = std::max(1, static_cast<int>(std::ceil(2 * rectangle.half_v / step)));
  section.row_height = 2 * rectangle.half_v / section.rows;
  std::vector<std::vector<Crossing>> rows(static_cast<std::size_t>(section.rows));
  // The first row whose middle is not below v.
  const auto row_from = [&](double v) {
    const double row = std::ceil(v / section.row_height + 0.5 * section.rows - 0.5);
    return static_cast<int>(std::clamp(row, 0.0, static_cast<double>(section.rows)));
  };
  for (const int triangle : crossing) {
    const Segment s = segment_of(mesh, rectangle, triangle, codes, bit);
    if (meets(s, {rectangle.half_u, rectangle.half_v})) section.triangles.push_back(triangle);
    const int low = row_from(std::min(s.a.y(), s.b.y()));
    const int high = row_from(std::max(s.a.y(), s.b.y()));
    for (int row = low; row < high; ++row) {
      const double t = (section.row_v(row) - s.a.y()) / (s.b.y() - s.a.y());
      rows[static_cast<std::size_t>(row)].push_back({s.a.x() + t * (s.b.x() - s.a.x()), triangle});
    }
  }
  for (int row = 0; row < section.rows; ++row) {
    add_spans(rows[static_cast<std::size_t>(row)], row, rectangle.half_u, section.spans);
  }
  return section;
}

}  // namespace gnathion
