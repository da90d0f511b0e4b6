#include "app/region_editor.h"

#include <utility>

namespace gnathion {
namespace {

constexpr double kSmallHole = 200;  // mm²

}  // namespace

RegionEditor::RegionEditor(CaseController& controller, QObject* parent)
    : QObject(parent), controller_(controller) {
  connect(&mirroring_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    emit mirroring_changed();
    emit failed(failure);
  });
  for (const auto ended : {&BackgroundTask::finished, &BackgroundTask::cancelled}) {
    connect(&mirroring_, ended, this, &RegionEditor::mirroring_changed);
  }
}

bool RegionEditor::same_face(const TriangleMesh& face) const {
  if (!brush_) return false;
  const TriangleMesh& known = brush_->face();
  return known.vertices.rows() == face.vertices.rows() &&
         known.triangles.rows() == face.triangles.rows() && known.vertices == face.vertices &&
         known.triangles == face.triangles;
}

void RegionEditor::set_face(const TriangleMesh& face) {
  mirroring_.cancel();
  stroke_ = false;
  brush_ = std::make_shared<const SurfaceBrush>(face);
  pockets_ = std::make_shared<const PocketSearch>(face);
  depth_.assign(static_cast<std::size_t>(face.vertices.rows()), Depth::unknown);
  region_.clear();
}

/// The plan says "suggest", and what follows from that is not computed yet.
bool RegionEditor::is_suggestion_awaited() const {
  const RegionChoice& wanted = controller_.plan().region;
  return wanted.vertices.empty() && !wanted.erased && controller_.is_editing();
}

Selection RegionEditor::region_of_plan() const {
  const Eigen::Index count = brush_->face().vertices.rows();
  const RegionChoice& wanted = controller_.plan().region;
  if (!wanted.vertices.empty()) return selection_of(wanted.vertices, count);
  if (wanted.erased || !controller_.has_model()) return selection_of({}, count);
  return selection_of(controller_.loaded().model->problem().face_vertices, count);
}

void RegionEditor::take_plan() {
  const TriangleMesh& face = controller_.loaded().anatomy->face.mesh.surface;
  if (!same_face(face)) set_face(face);
  if (stroke_) return;
  known_ = !is_suggestion_awaited();
  // Until the suggestion is known the last region stays in sight.
  if (known_ || region_.empty()) region_ = region_of_plan();
  sliding_ = selection_of(controller_.plan().tissue.sliding_vertices, face.vertices.rows());
  outline_again();
  faults_ = region_faults(*brush_, region_);
  emit faults_changed();
}

void RegionEditor::outline_again() {
  outline_ = outline_of(*brush_, region_);
  sliding_outline_ = outline_of(*brush_, sliding_);
  emit changed();
}

bool RegionEditor::is_hidden(int vertex) {
  Depth& depth = depth_[static_cast<std::size_t>(vertex)];
  if (depth == Depth::unknown) depth = pockets_->is_hidden(vertex) ? Depth::hidden : Depth::open;
  return depth == Depth::hidden;
}

const TriangleMesh* RegionEditor::surface() const {
  return brush_ && known_ ? &brush_->face() : nullptr;
}

std::vector<std::array<EdgePoint, 2>> RegionEditor::circle(const SurfacePoint& centre,
                                                           double radius) const {
  return brush_->circle(centre, radius);
}

void RegionEditor::begin_stroke(bool erases) {
  painted_ = target_;
  erases_ = erases;
  stroke_ = true;
}

void RegionEditor::stamp(const SurfacePoint& at, double radius) {
  if (!stroke_) return;
  Selection& selection = painted_ == BrushTarget::region ? region_ : sliding_;
  bool any = false;
  for (const ReachedVertex& reached : brush_->disc(at, radius)) {
    const auto v = static_cast<std::size_t>(reached.vertex);
    if (selection[v] != erases_) continue;
    if (!erases_ && is_hidden(reached.vertex)) continue;
    selection[v] = !erases_;
    any = true;
  }
  if (!any) return;
  RegionOutline& outline = painted_ == BrushTarget::region ? outline_ : sliding_outline_;
  outline = outline_of(*brush_, selection);
  emit changed();
}

void RegionEditor::end_stroke() {
  if (!stroke_) return;
  stroke_ = false;
  if (painted_ == BrushTarget::sliding) {
    commit(erases_ ? tr("Erase sliding tissue") : tr("Paint sliding tissue"));
  } else {
    set_region(region_, erases_ ? tr("Erase from the region") : tr("Paint the region"));
  }
}

void RegionEditor::drop_stroke() {
  if (!stroke_) return;
  stroke_ = false;
  take_plan();
}

void RegionEditor::set_region(const Selection& region, const QString& step) {
  region_ = without_pinches(*brush_, region);
  outline_again();
  faults_ = region_faults(*brush_, region_);
  emit faults_changed();
  commit(step);
}

void RegionEditor::commit(const QString& step) {
  SurgicalCase plan = controller_.plan();
  plan.region.vertices = vertices_of(region_);
  plan.region.erased = plan.region.vertices.empty();
  plan.tissue.sliding_vertices = vertices_of(sliding_);
  if (plan == controller_.plan()) return;
  controller_.edit(step, std::move(plan));
}

void RegionEditor::grow(double mm) {
  set_region(grown(*brush_, region_, mm), tr("Grow the region"));
}

void RegionEditor::shrink(double mm) {
  set_region(shrunk(*brush_, region_, mm), tr("Shrink the region"));
}

void RegionEditor::smooth(double mm) {
  set_region(smoothed(*brush_, region_, mm), tr("Smooth the region"));
}

void RegionEditor::tidy() {
  // Where a pinch is cut a small piece may come off.
  const Selection clean = without_pinches(
      *brush_, filled(*brush_, *pockets_, largest_piece(*brush_, region_), kSmallHole));
  set_region(largest_piece(*brush_, clean), tr("Tidy the region"));
}

void RegionEditor::clear() {
  set_region(Selection(region_.size(), false), tr("Clear the region"));
}

void RegionEditor::suggest(double reach) {
  SurgicalCase plan = controller_.plan();
  plan.region.reach_mm = reach;
  plan.region.vertices.clear();
  plan.region.erased = false;
  if (plan == controller_.plan()) return;
  controller_.edit(tr("Suggest the region"), std::move(plan));
}

void RegionEditor::mirror() {
  mirroring_.start([this, brush = brush_, region = region_](Progress& progress) {
    const BspTree tree(brush->face());
    const SymmetryPlane plane = find_symmetry(brush->face(), tree);
    progress.check();
    // A brush keeps room to work in: the worker takes its own.
    Selection both = with_mirror_image(SurfaceBrush(brush->face()), tree, plane, region);
    return [this, both, region, error = plane.error_mm] {
      if (region != region_) return;  // painted on meanwhile
      set_region(both, tr("Mirror the region"));
      emit mirrored(error);
    };
  });
  emit mirroring_changed();
}

}  // namespace gnathion
