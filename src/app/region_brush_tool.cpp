#include "app/region_brush_tool.h"

#include <QKeyEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/face_view.h"
#include "render/region_overlay.h"

namespace gnathion {
namespace {

constexpr double kStep = 0.3;        // of the radius: the distance of stamps along a stroke
constexpr int kMostStamps = 60;      // between two places of the mouse
constexpr double kCursorLift = 0.8;  // mm off the skin, so that it stays in sight

}  // namespace

RegionBrushTool::RegionBrushTool(FaceView& view, PaintedSurface& surface, RegionOverlay& overlay,
                                 QObject* parent)
    : QObject(parent), view_(view), surface_(surface), overlay_(overlay) {
  view_.canvas()->installEventFilter(this);
}

void RegionBrushTool::set_radius(double mm) {
  const double wanted = std::clamp(mm, least_radius, largest_radius);
  if (wanted == radius_) return;
  radius_ = wanted;
  emit radius_changed(radius_);
  if (view_.tool() == this && last_) hovered(*last_);
}

void RegionBrushTool::set_points(const Points& points) {
  set_points(points, nullptr, {});
}

void RegionBrushTool::set_points(const Points& points, std::shared_ptr<const BspTree> tree,
                                 const Similarity& lps_from_tree) {
  points_ = points;
  tree_ = std::move(tree);
  lps_from_tree_ = lps_from_tree;
}

std::optional<RegionBrushTool::Hit> RegionBrushTool::hit(const ViewPoint& at) {
  const TriangleMesh* surface = surface_.surface();
  if (surface == nullptr || points_.rows() != surface->vertices.rows()) return {};
  if (!tree_) tree_ = std::make_shared<const BspTree>(TriangleMesh{points_, surface->triangles});
  const auto found = point_in_sight(
      *tree_, lps_from_tree_.displacement_to_source(at.eye - lps_from_tree_.translation),
      lps_from_tree_.rotation.transpose() * at.direction);
  if (!found) return {};
  return Hit{*found, found->position(surface->triangles, points_)};
}

bool RegionBrushTool::erases(const ViewPoint& at) const {
  return (mode_ == BrushMode::erase) != at.modifiers.testFlag(Qt::ShiftModifier);
}

bool RegionBrushTool::pressed(const ViewPoint& at) {
  const auto found = hit(at);
  if (!found) return false;
  stroke_erases_ = erases(at);
  last_ = at;
  last_place_ = found->place;
  emit stroke_began();
  surface_.begin_stroke(stroke_erases_);
  surface_.stamp(found->on, radius_);
  show_cursor(found, stroke_erases_);
  return true;
}

/// Stamps along the straight way of the mouse, so close that a fast stroke has no gaps.
void RegionBrushTool::stamp_to(const ViewPoint& at) {
  const auto found = hit(at);
  const QPoint way = at.pixel - last_->pixel;
  const double pixels = std::hypot(way.x(), way.y());
  int count = 1;
  if (found && last_place_) {
    count = static_cast<int>(std::ceil((found->place - *last_place_).norm() / (kStep * radius_)));
  } else {
    count = static_cast<int>(std::ceil(pixels / 8));
  }
  count = std::clamp(count, 1, kMostStamps);
  for (int i = 1; i < count; ++i) {
    const auto between = hit(view_.view_point(last_->pixel + way * i / count, at.modifiers));
    if (between) surface_.stamp(between->on, radius_);
  }
  if (found) surface_.stamp(found->on, radius_);
  last_ = at;
  last_place_.reset();
  if (found) last_place_ = found->place;
  show_cursor(found, stroke_erases_);
}

void RegionBrushTool::dragged(const ViewPoint& at) {
  if (surface_.is_stroke() && last_) stamp_to(at);
}

void RegionBrushTool::released(const ViewPoint& at) {
  if (surface_.is_stroke() && last_ && at.pixel != last_->pixel) stamp_to(at);
  surface_.end_stroke();
  emit stroke_ended();
}

void RegionBrushTool::hovered(const ViewPoint& at) {
  last_ = at;
  show_cursor(hit(at), erases(at));
}

void RegionBrushTool::left() {
  if (surface_.is_stroke()) return;
  last_.reset();
  show_cursor({}, false);
}

/// The circle on the skin, as segments; where it lies within one triangle, round about the normal.
Points RegionBrushTool::cursor_at(const Hit& at) const {
  const Triangles& triangles = surface_.surface()->triangles;
  const auto corners = triangles.row(at.on.triangle);
  const Eigen::Vector3d a = points_.row(corners[0]);
  const Eigen::Vector3d b = points_.row(corners[1]);
  const Eigen::Vector3d c = points_.row(corners[2]);
  const Eigen::Vector3d out = (b - a).cross(c - a).stableNormalized();
  const auto circle = surface_.circle(at.on, radius_);
  if (!circle.empty()) {
    Points ends(2 * circle.size(), 3);
    Eigen::Index row = 0;
    for (const auto& segment : circle) {
      for (const EdgePoint& end : segment) {
        ends.row(row++) = (1 - end.share) * points_.row(end.a) + end.share * points_.row(end.b);
      }
    }
    const Eigen::RowVector3d towards = (view_.view_point({0, 0}).eye - at.place).normalized();
    ends.rowwise() += kCursorLift * towards;
    return ends;
  }
  constexpr int kSides = 32;
  const Eigen::Vector3d x = out.unitOrthogonal(), y = out.cross(x);
  Points ends(2 * kSides, 3);
  for (int i = 0; i < 2 * kSides; ++i) {
    const int corner = (i + 1) / 2;  // each side has two ends
    const double angle = 2 * std::numbers::pi * corner / kSides;
    ends.row(i) =
        at.place + radius_ * (std::cos(angle) * x + std::sin(angle) * y) + kCursorLift * out;
  }
  return ends;
}

void RegionBrushTool::show_cursor(const std::optional<Hit>& at, bool erasing) {
  overlay_.set_cursor(at ? cursor_at(*at) : Points(), erasing);
  view_.render_soon();
}

bool RegionBrushTool::eventFilter(QObject*, QEvent* event) {
  if (view_.tool() != this) return false;
  if (event->type() == QEvent::Wheel) {
    const auto* wheel = static_cast<QWheelEvent*>(event);
    if (!wheel->modifiers().testFlag(Qt::ControlModifier)) return false;
    set_radius(radius_ * std::pow(1.1, wheel->angleDelta().y() / 120.0));
    return true;
  }
  if (event->type() == QEvent::KeyPress && surface_.is_stroke() &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    surface_.drop_stroke();
    emit stroke_ended();
    return true;
  }
  return false;
}

}  // namespace gnathion
