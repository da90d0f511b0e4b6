#include "geometry/plane_section.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gnathion {
namespace {

constexpr Eigen::Index run_length = 64;

}  // namespace

PlaneSection::PlaneSection(std::shared_ptr<const TriangleMesh> surface)
    : surface_(std::move(surface)) {
  make_boxes();
}

void PlaneSection::set_points(Points points) {
  moved_ = std::move(points);
  make_boxes();
}

void PlaneSection::make_boxes() {
  const Triangles& triangles = surface_->triangles;
  const Points& places = points();
  boxes_.clear();
  for (Eigen::Index first = 0; first < triangles.rows(); first += run_length) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
    Eigen::Vector3d high = -low;
    for (Eigen::Index t = first; t < std::min(first + run_length, triangles.rows()); ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector3d p = places.row(triangles(t, corner));
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
    boxes_.push_back({(low + high) / 2, (high - low) / 2});
  }
}

void PlaneSection::cut_triangle(Eigen::Index triangle, const Eigen::Vector3d& normal, double offset,
                                std::vector<SectionLine>& lines) const {
  std::array<Eigen::Vector3d, 3> p;
  std::array<double, 3> height;
  for (int corner = 0; corner < 3; ++corner) {
    p[corner] = points().row(surface_->triangles(triangle, corner));
    height[corner] = normal.dot(p[corner]) - offset;
  }
  SectionLine line;
  int ends = 0;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3;
    if ((height[a] >= 0) == (height[b] >= 0)) continue;
    const double t = height[a] / (height[a] - height[b]);
    line[ends++] = p[a] + t * (p[b] - p[a]);
  }
  if (ends == 2) lines.push_back(line);
}

std::vector<SectionLine> PlaneSection::cut(const Eigen::Vector3d& normal, double offset) const {
  std::vector<SectionLine> lines;
  const Eigen::Vector3d size = normal.cwiseAbs();
  for (std::size_t run = 0; run < boxes_.size(); ++run) {
    const Box& box = boxes_[run];
    if (std::abs(normal.dot(box.centre) - offset) > size.dot(box.half)) continue;
    const Eigen::Index first = static_cast<Eigen::Index>(run) * run_length;
    const Eigen::Index end = std::min(first + run_length, surface_->triangles.rows());
    for (Eigen::Index t = first; t < end; ++t) cut_triangle(t, normal, offset, lines);
  }
  return lines;
}

}  // namespace gnathion
