#include "app/lip_line_tool.h"

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core_words.h"
#include "app/face_view.h"
#include "tissue/lip_line.h"

namespace gnathion {
namespace {

constexpr double kStep = 1;    // mm: the line is drawn along the skin between its points
constexpr double kReach = 10;  // mm: farther from the skin the line is not drawn

/// Where points of the face are, in its present shape.
SkinLine::Places places_of(const std::vector<SurfacePoint>& on, const Triangles& triangles,
                           const Points& points) {
  SkinLine::Places places{Points(on.size(), 3), Points(on.size(), 3)};
  for (std::size_t i = 0; i < on.size(); ++i) {
    const auto f = triangles.row(on[i].triangle);
    const Eigen::Vector3d a = points.row(f[0]), b = points.row(f[1]), c = points.row(f[2]);
    places.on.row(static_cast<Eigen::Index>(i)) = on[i].position(triangles, points);
    places.outward.row(static_cast<Eigen::Index>(i)) = (b - a).cross(c - a).stableNormalized();
  }
  return places;
}

}  // namespace

LipLineTool::LipLineTool(CaseController& controller, FaceView& view, RegionEditor& editor,
                         QObject* parent)
    : QObject(parent), controller_(controller), view_(view), editor_(editor) {
  view_.canvas()->installEventFilter(this);
}

void LipLineTool::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  if (active) {
    mark_.attach(view_.renderer());
  } else {
    drop();
    mark_.detach();
  }
}

void LipLineTool::set_points(const Points& points) {
  points_ = points;
  shown_tree_.reset();
  draw();
}

void LipLineTool::take_plan() {
  if (!active_ || !editor_.has_face()) return;
  if (rest_face_ != &editor_.brush()) {
    drop();
    rest_face_ = &editor_.brush();
    rest_tree_.reset();
  }
  tie_line();
  draw();
}

/// Ties the line that is traced, or else the plan's, to the face.
void LipLineTool::tie_line() {
  line_.clear();
  knobs_.clear();
  const TriangleMesh& face = editor_.brush().face();
  std::vector<Eigen::Vector3d> corners;
  if (tracing_) {
    for (const SurfacePoint& on : traced_) {
      corners.push_back(on.position(face.triangles, face.vertices));
    }
  } else {
    corners = controller_.plan().region.lip_line;
  }
  if (corners.empty()) return;
  if (!rest_tree_) rest_tree_.emplace(face);
  const auto tie = [&](const Eigen::Vector3d& place, std::vector<SurfacePoint>& to) {
    if (const auto on = nearest_surface_point(*rest_tree_, face, place, kReach)) to.push_back(*on);
  };
  tie(corners.front(), line_);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Eigen::Vector3d along = corners[k] - corners[k - 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(along.norm() / kStep)));
    for (int i = 1; i <= steps; ++i) tie(corners[k - 1] + along * i / steps, line_);
  }
  // Of a line that is done only the ends: a proposal has a point every few millimetres.
  if (!tracing_) corners = {corners.front(), corners.back()};
  for (const Eigen::Vector3d& corner : corners) tie(corner, knobs_);
}

void LipLineTool::draw() {
  if (!active_ || !editor_.has_face()) return;
  const Triangles& triangles = editor_.brush().face().triangles;
  if (rest_face_ != &editor_.brush() || points_.rows() != rest_face_->face().vertices.rows()) {
    mark_.set_line({}, {});
    return;
  }
  mark_.set_line(places_of(line_, triangles, points_), places_of(knobs_, triangles, points_));
  view_.render_soon();
}

void LipLineTool::begin() {
  if (tracing_ || !editor_.has_face()) return;
  tracing_ = true;
  traced_.clear();
  take_plan();
  emit tracing_changed();
}

void LipLineTool::end_tracing() {
  tracing_ = false;
  traced_.clear();
  take_plan();
  emit tracing_changed();
}

void LipLineTool::finish() {
  if (!tracing_) return;
  const TriangleMesh& face = editor_.brush().face();
  std::vector<Eigen::Vector3d> line;
  for (const SurfacePoint& on : traced_) {
    line.push_back(on.position(face.triangles, face.vertices));
  }
  if (line.size() >= 2) set_plan_line(tr("Trace the lip line"), std::move(line));
  end_tracing();
}

void LipLineTool::drop() {
  if (tracing_) end_tracing();
}

void LipLineTool::set_plan_line(const QString& step, std::vector<Eigen::Vector3d> line) {
  SurgicalCase plan = controller_.plan();
  plan.region.lip_line = std::move(line);
  if (plan == controller_.plan()) return;
  controller_.edit(step, std::move(plan));
}

void LipLineTool::propose() {
  if (!editor_.has_face()) return;
  drop();
  LipLineProposal proposal = propose_lip_line(editor_.brush().face(), controller_.plan().landmarks);
  QStringList words;
  for (const std::string& doubt : proposal.doubts) words << core_words(doubt);
  if (proposal.line.empty()) {
    emit controller_.noticed(
        tr("No lip line was found. %1 Trace it with the mouse.").arg(words.join(' ')));
    return;
  }
  set_plan_line(tr("Propose the lip line"), std::move(proposal.line));
  if (!words.isEmpty()) {
    emit controller_.noticed(tr("Look at the proposed lip line. %1").arg(words.join(' ')));
  }
}

void LipLineTool::remove() {
  drop();
  set_plan_line(tr("Remove the lip line"), {});
}

std::optional<SurfacePoint> LipLineTool::hit(const ViewPoint& at) {
  if (!editor_.has_face() || points_.rows() != editor_.brush().face().vertices.rows()) return {};
  if (!shown_tree_) shown_tree_.emplace(TriangleMesh{points_, editor_.brush().face().triangles});
  return point_in_sight(*shown_tree_, at.eye, at.direction);
}

bool LipLineTool::pressed(const ViewPoint& at) {
  if (!tracing_) return false;
  const auto found = hit(at);
  if (!found) return false;
  traced_.push_back(*found);
  take_plan();
  emit tracing_changed();
  return true;
}

bool LipLineTool::eventFilter(QObject*, QEvent* event) {
  if (!tracing_ || view_.tool() != this || event->type() != QEvent::KeyPress) return false;
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      finish();
      return true;
    case Qt::Key_Escape:
      drop();
      return true;
    case Qt::Key_Backspace:
      if (!traced_.empty()) traced_.pop_back();
      take_plan();
      emit tracing_changed();
      return true;
    default:
      return false;
  }
}

}  // namespace gnathion
