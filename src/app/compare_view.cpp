#include "app/compare_view.h"

#include <algorithm>
#include <cmath>

#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "app/answer_words.h"
#include "app/face_view.h"
#include "app/motion_words.h"
#include "app/place_words.h"
#include "geometry/section_chains.h"
#include "render/segment_colours.h"

namespace gnathion {
namespace {

constexpr int grasp_pixels = 12;        // either side of the divider
constexpr double landmark_reach = 6;    // mm from the profile's plane, either side
constexpr double landmark_to_skin = 5;  // mm: farther off it is no point of this face

std::vector<Points> sagittal_section(const Triangles& triangles, const Points& vertices, double x) {
  // Seen from the patient's right side, as the drawing is.
  return section_chains({vertices, triangles}, {x, 0, 0}, -Eigen::Vector3d::UnitX());
}

/// y and z of what the profile is about: the part of the region near the plane, with its
/// surroundings; without a region the face's front.
Eigen::AlignedBox3d profile_box(const LoadedCase& loaded, double x) {
  constexpr double near = 25, above = 35, behind = 30, before = 25;
  const Points& face = loaded.anatomy->face.mesh.surface.vertices;
  Eigen::AlignedBox3d box;
  if (loaded.model) {
    for (const int v : loaded.model->moving_vertices()) {
      if (std::abs(face(v, 0) - x) < near) box.extend(face.row(v).transpose());
    }
  }
  if (box.isEmpty()) {
    for (const auto point : face.rowwise()) {
      if (std::abs(point.x() - x) < near) box.extend(point.transpose());
    }
  }
  if (box.isEmpty()) return {Eigen::Vector3d::Constant(-50), Eigen::Vector3d::Constant(50)};
  box.min() -= Eigen::Vector3d(0, before, above);
  box.max() += Eigen::Vector3d(0, behind, above);
  return box;
}

}  // namespace

CompareView::CompareView(CaseController& controller, FaceView& view, QObject* parent)
    : QObject(parent), controller_(controller), view_(view), scene_(view.scene()) {
  rest_.setSingleShot(true);
  rest_.setInterval(100);
  connect(&rest_, &QTimer::timeout, this, &CompareView::grow_trees);
  connect(&view, &FaceView::case_shown, this, [this] {
    if (active_) show_case();
  });
  for (const auto changed :
       {&CaseController::motion_changed, &CaseController::refinement_changed}) {
    connect(&controller, changed, this, [this] {
      if (active_) show_answer();
    });
  }
}

CompareView::~CompareView() {
  set_active(false);
}

void CompareView::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  if (active) {
    scene_.attach(view_.interactor()->GetRenderWindow());
    marks_after_.attach(view_.renderer());
    marks_before_.attach(scene_.before().renderer());
    view_.set_tool(this);
    show_case();
  } else {
    growing_.cancel();
    rest_.stop();
    if (view_.tool() == this) view_.set_tool(nullptr);
    marks_after_.detach();
    marks_before_.detach();
    scene_.detach();
    view_.canvas()->unsetCursor();
    view_.render_soon();
  }
}

/// Another case, or the same with other bones.
void CompareView::show_case() {
  if (!controller_.has_case() || shown_ == controller_.shared_case()) {
    set_mode(mode_);
    show_answer();
    return;
  }
  shown_ = controller_.shared_case();
  before_filled_ = false;
  rest_tree_.reset();
  ends_.clear();
  emit distance_changed();
  set_mode(mode_);
  show_answer();
  frame_profile();
}

void CompareView::set_mode(CompareMode mode) {
  mode_ = mode;
  if (!active_ || !shown_) return;
  const bool needs_before =
      mode == CompareMode::side_by_side || mode == CompareMode::wipe || mode == CompareMode::blend;
  if (needs_before && !before_filled_) fill_before();
  const bool paper_comes = mode == CompareMode::profile && scene_.mode() != mode;
  scene_.set_mode(mode);
  show_words();
  if (mode == CompareMode::profile) show_profile();
  if (paper_comes) frame_profile();
  view_.render_soon();
}

/// The face before and the bones at rest.
void CompareView::fill_before() {
  const ReadyAnatomy& ready = *shown_->ready;
  FaceScene& before = scene_.before();
  before.set_face(ready.face);
  before.remove_bones();
  before.set_bone("skull", ready.skull, skull_look);
  for (std::size_t s = 0; s < ready.segments.size(); ++s) {
    before.set_bone("segment " + shown_->anatomy->segments[s].name, ready.segments[s],
                    look_of_segment(s));
  }
  before_filled_ = true;
}

void CompareView::set_wipe(double fraction) {
  scene_.set_wipe(fraction);
  view_.render_soon();
}

void CompareView::set_blend(double share_of_before) {
  blend_ = share_of_before;
  scene_.set_blend(share_of_before);
  show_words();
  view_.render_soon();
}

void CompareView::set_section(double left_mm) {
  section_mm_ = left_mm;
  if (active_ && mode_ == CompareMode::profile) {
    show_profile();
    view_.render_soon();
  }
}

double CompareView::middle_x() const {
  const LoadedCase& loaded = controller_.loaded();
  std::vector<double> xs;
  for (const auto& [name, place] : loaded.plan.landmarks) xs.push_back(place.x());
  if (xs.empty()) {
    const Points& face = loaded.anatomy->face.mesh.surface.vertices;
    Eigen::Index nose = 0;
    face.col(1).minCoeff(&nose);
    return face(nose, 0);
  }
  std::sort(xs.begin(), xs.end());
  const std::size_t half = xs.size() / 2;
  return xs.size() % 2 == 1 ? xs[half] : (xs[half - 1] + xs[half]) / 2;
}

/// The motions' answer has changed, or what is known of it.
void CompareView::show_answer() {
  if (!shown_) return;
  after_tree_.reset();
  growing_.cancel();
  rest_.start();
  show_words();
  if (mode_ == CompareMode::profile) show_profile();
  show_distance();
  if (ends_.size() == 2) emit distance_changed();
  view_.render_soon();
}

void CompareView::show_words() {
  if (!controller_.has_case()) return;
  scene_.before().set_label(tr("Before").toStdString());
  // The veil's own words stand below it.
  if (mode_ == CompareMode::blend) scene_.before().set_label("");
  scene_.set_blend_words(tr("Before %1 % · predicted %2 %")
                             .arg(std::lround(100 * blend_))
                             .arg(100 - std::lround(100 * blend_))
                             .toStdString());
  const QString words = predicted_words(controller_) + "\n" +
                        answer_words(controller_, {}).caption + "\n" +
                        (std::abs(section_mm_) < 0.05
                             ? tr("profile in the middle of the face")
                             : tr("profile %1 of the middle of the face")
                                   .arg(direction_words(section_mm_ * Eigen::Vector3d::UnitX())));
  scene_.profile().set_words({words.toStdString(), tr("Before").toStdString(),
                              tr("Predicted").toStdString(),
                              tr("Soft-tissue landmarks").toStdString(), tr("grid").toStdString()});
}

void CompareView::show_profile() {
  const TriangleMesh& rest = shown_->anatomy->face.mesh.surface;
  const Points& after = controller_.response().face;
  const double x = middle_x() + section_mm_;
  profile_.before = sagittal_section(rest.triangles, rest.vertices, x);
  profile_.after = sagittal_section(rest.triangles, after, x);
  profile_.landmarks.clear();
  for (const auto& [name, place] : shown_->plan.landmarks) {
    if (!rest_tree_ || std::abs(place.x() - x) > landmark_reach) continue;
    if (const auto point = nearest_surface_point(*rest_tree_, rest, place, landmark_to_skin)) {
      profile_.landmarks.push_back({landmark_words(name).toStdString(),
                                    point->position(rest.triangles, rest.vertices),
                                    point->position(rest.triangles, after)});
    }
  }
  scene_.profile().show(profile_);
  show_words();
}

void CompareView::frame_profile() {
  if (!shown_) return;
  const Eigen::AlignedBox3d box = profile_box(*shown_, middle_x() + section_mm_);
  scene_.profile().frame(box.min(), box.max(), aspect_ratio());
}

double CompareView::aspect_ratio() const {
  return static_cast<double>(std::max(view_.canvas()->width(), 1)) /
         std::max(view_.canvas()->height(), 1);
}

/// What finds the point under the mouse: of the face before once a case, of the other once an
/// answer.
void CompareView::grow_trees() {
  if (!active_ || !shown_) return;
  growing_.start([this, loaded = shown_, after = controller_.response().face,
                  rest_tree = rest_tree_](Progress& progress) {
    const TriangleMesh& rest = loaded->anatomy->face.mesh.surface;
    auto before = rest_tree ? rest_tree : std::make_shared<const BspTree>(rest);
    progress.check();
    auto moved = std::make_shared<const BspTree>(TriangleMesh{after, rest.triangles});
    return [this, before, moved] {
      const bool first = rest_tree_ == nullptr;
      rest_tree_ = before;
      after_tree_ = moved;
      if (first && mode_ == CompareMode::profile) {
        show_profile();  // its landmarks lie on the skin
        view_.render_soon();
      }
      emit ready_to_point();
    };
  });
}

double CompareView::fraction(QPoint pixel) const {
  return (pixel.x() + 0.5) / std::max(view_.canvas()->width(), 1);
}

bool CompareView::on_divider(QPoint pixel) const {
  return mode_ == CompareMode::wipe &&
         std::abs(pixel.x() - scene_.wipe() * view_.canvas()->width()) <= grasp_pixels;
}

std::optional<SurfacePoint> CompareView::point_at(QPoint pixel) const {
  if (!can_point() || mode_ == CompareMode::profile) return {};
  const double x = fraction(pixel);
  const double shifted = scene_.in_predicted(x);
  const int columns = static_cast<int>(std::lround((shifted - x) * view_.canvas()->width()));
  const ViewPoint sight = view_.view_point(pixel + QPoint(columns, 0));
  return point_in_sight(scene_.shows_before(x) ? *rest_tree_ : *after_tree_, sight.eye,
                        sight.direction);
}

std::optional<FaceReading> CompareView::reading_at(QPoint pixel) const {
  const auto point = point_at(pixel);
  if (!point) return {};
  const TriangleMesh& rest = shown_->anatomy->face.mesh.surface;
  FaceReading reading;
  reading.before = point->position(rest.triangles, rest.vertices);
  reading.after = point->position(rest.triangles, controller_.response().face);
  reading.on_before = scene_.shows_before(fraction(pixel));
  if (const Prediction* refined = controller_.refined()) {
    const double mm = point->value(rest.triangles, refined->signed_distance);
    if (std::isfinite(mm)) reading.signed_mm = mm;
  }
  return reading;
}

void CompareView::set_measuring(bool measuring) {
  measuring_ = measuring;
}

void CompareView::clear_distance() {
  ends_.clear();
  show_distance();
  view_.render_soon();
  emit distance_changed();
}

std::optional<DistanceReading> CompareView::distance() const {
  if (ends_.size() < 2) return {};
  const TriangleMesh& rest = shown_->anatomy->face.mesh.surface;
  const auto between = [&](const Points& face) {
    return (ends_[1].position(rest.triangles, face) - ends_[0].position(rest.triangles, face))
        .norm();
  };
  return DistanceReading{between(rest.vertices), between(controller_.response().face)};
}

void CompareView::show_distance() {
  if (!shown_) return;
  const TriangleMesh& rest = shown_->anatomy->face.mesh.surface;
  std::vector<Eigen::Vector3d> before, after;
  for (const SurfacePoint& end : ends_) {
    before.push_back(end.position(rest.triangles, rest.vertices));
    after.push_back(end.position(rest.triangles, controller_.response().face));
  }
  const auto reading = distance();
  marks_before_.show(before, reading ? mm_words(reading->before).toStdString() : "");
  marks_after_.show(after, reading ? mm_words(reading->after).toStdString() : "");
}

bool CompareView::pressed(const ViewPoint& at) {
  if (mode_ == CompareMode::profile) {
    paper_from_ = at.pixel;
    return true;
  }
  drags_divider_ = on_divider(at.pixel);
  if (drags_divider_) return true;
  if (!measuring_) return false;
  const auto point = point_at(at.pixel);
  if (!point) return false;  // beside the face: the camera turns
  if (ends_.size() == 2) ends_.clear();
  ends_.push_back(*point);
  show_distance();
  view_.render_soon();
  emit distance_changed();
  return true;
}

void CompareView::dragged(const ViewPoint& at) {
  if (mode_ == CompareMode::profile) {
    const double height = std::max(view_.canvas()->height(), 1);
    const QPoint by = at.pixel - paper_from_;
    scene_.profile().pan(by.x() / height, -by.y() / height);
    paper_from_ = at.pixel;
    view_.render_soon();
  } else if (drags_divider_) {
    set_wipe(fraction(at.pixel));
    emit wipe_dragged(scene_.wipe());
  }
}

void CompareView::released(const ViewPoint&) {
  drags_divider_ = false;
}

void CompareView::hovered(const ViewPoint& at) {
  if (on_divider(at.pixel)) {
    view_.canvas()->setCursor(Qt::SplitHCursor);
  } else if (measuring_) {
    view_.canvas()->setCursor(Qt::CrossCursor);
  } else {
    view_.canvas()->unsetCursor();
  }
  emit pointed(reading_at(at.pixel));
}

void CompareView::left() {
  emit pointed({});
}

}  // namespace gnathion
