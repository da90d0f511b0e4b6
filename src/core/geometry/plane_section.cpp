#include "geometry/plane_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gnathion {
namespace {

constexpr std::size_t run_length = 64;
constexpr double cell_mm = 6;

}  // namespace

PlaneSection::PlaneSection(std::shared_ptr<const TriangleMesh> surface)
    : surface_(std::move(surface)) {
  sort_triangles();
  make_boxes();
}

/// By the cell of a grid that a triangle's first corner lies in, at rest: surfaces come row by row
/// of a volume, where a run of triangles would reach across half the head.
void PlaneSection::sort_triangles() {
  const Triangles& triangles = surface_->triangles;
  std::vector<std::pair<std::array<int, 3>, int>> cells;
  cells.reserve(static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Eigen::Array3i cell =
        (surface_->vertices.row(triangles(t, 0)).array() / cell_mm).floor().cast<int>();
    cells.push_back({{cell.x(), cell.y(), cell.z()}, static_cast<int>(t)});
  }
  std::sort(cells.begin(), cells.end());
  order_.clear();
  for (const auto& [cell, triangle] : cells) order_.push_back(triangle);
}

void PlaneSection::set_points(Points points) {
  moved_ = std::move(points);
  make_boxes();
}

void PlaneSection::make_boxes() {
  const Triangles& triangles = surface_->triangles;
  const Points& places = points();
  boxes_.clear();
  for (std::size_t first = 0; first < order_.size(); first += run_length) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
    Eigen::Vector3d high = -low;
    for (std::size_t t = first; t < std::min(first + run_length, order_.size()); ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector3d p = places.row(triangles(order_[t], corner));
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
    const std::size_t first = run * run_length;
    const std::size_t end = std::min(first + run_length, order_.size());
    for (std::size_t t = first; t < end; ++t) cut_triangle(order_[t], normal, offset, lines);
  }
  return lines;
}

}  // namespace gnathion
