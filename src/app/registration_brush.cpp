#include "app/registration_brush.h"

#include <utility>

namespace gnathion {

StableRegionEditor::StableRegionEditor(CaseController& controller, QObject* parent)
    : QObject(parent), controller_(controller) {
  outline_timer_.setSingleShot(true);
  connect(&outline_timer_, &QTimer::timeout, this, &StableRegionEditor::show_outline);
  connect(&controller_, &CaseController::history_changed, this, &StableRegionEditor::take_plan);
}

void StableRegionEditor::set_photograph(std::shared_ptr<const SurfaceBrush> brush,
                                        double mm_per_unit, const Selection& proposed) {
  const bool same = brush == brush_ && mm_per_unit == mm_per_unit_ && proposed == proposed_;
  if (same) return;
  if (brush != brush_) {
    stroke_ = false;
    region_.clear();
  }
  brush_ = std::move(brush);
  mm_per_unit_ = mm_per_unit;
  proposed_ = proposed;
  take_plan();
}

std::vector<int> StableRegionEditor::planned() const {
  if (!controller_.has_case() || !controller_.plan().photograph) return {};
  return controller_.plan().photograph->stable_vertices;
}

void StableRegionEditor::take_plan() {
  if (stroke_) return;
  const Eigen::Index count = brush_ ? brush_->face().vertices.rows() : 0;
  const std::vector<int> painted = planned();
  const bool proposes = painted.empty() && static_cast<Eigen::Index>(proposed_.size()) == count;
  Selection region = proposes ? proposed_ : selection_of(painted, count);
  if (region == region_ && !outline_timer_.isActive()) return;
  region_ = std::move(region);
  show_outline();
}

void StableRegionEditor::show_outline() {
  outline_timer_.stop();
  outline_ = brush_ ? outline_of(*brush_, region_) : RegionOutline{};
  emit changed();
}

void StableRegionEditor::take_proposal() {
  commit(tr("Take the proposed stable region"), {});
}

const TriangleMesh* StableRegionEditor::surface() const {
  return brush_ ? &brush_->face() : nullptr;
}

std::vector<std::array<EdgePoint, 2>> StableRegionEditor::circle(const SurfacePoint& centre,
                                                                 double radius) const {
  return brush_->circle(centre, radius / mm_per_unit_);
}

void StableRegionEditor::begin_stroke(bool erases) {
  erases_ = erases;
  stroke_ = true;
}

void StableRegionEditor::stamp(const SurfacePoint& at, double radius) {
  if (!stroke_) return;
  for (const ReachedVertex& reached : brush_->disc(at, radius / mm_per_unit_)) {
    region_[static_cast<std::size_t>(reached.vertex)] = !erases_;
  }
  if (!outline_timer_.isActive()) outline_timer_.start(0);
}

void StableRegionEditor::end_stroke() {
  if (!stroke_) return;
  stroke_ = false;
  commit(erases_ ? tr("Erase from the stable region") : tr("Paint the stable region"),
         vertices_of(region_));
}

void StableRegionEditor::drop_stroke() {
  stroke_ = false;
  take_plan();
}

void StableRegionEditor::commit(const QString& step, std::vector<int> vertices) {
  SurgicalCase plan = controller_.plan();
  if (!plan.photograph) return;
  plan.photograph->stable_vertices = std::move(vertices);
  if (plan != controller_.plan()) controller_.edit(step, std::move(plan));
  take_plan();
}

}  // namespace gnathion
