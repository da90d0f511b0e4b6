#include "app/view_grid.h"

#include <QEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "app/camera_mouse.h"
#include "app/case_controller.h"
#include "app/face_view.h"
#include "app/slice_view.h"
#include "ui_view_grid.h"

namespace gnathion {
namespace {

constexpr int rest_ms = 120;

// Apart on black, grey and white, and for the common deficiencies of colour vision.
const Eigen::Vector3d bone_colour{0.95, 0.80, 0.25};
const Eigen::Vector3d segment_colour{0.25, 0.80, 0.95};
const Eigen::Vector3d before_colour{0.80, 0.62, 0.90};
const Eigen::Vector3d predicted_colour{1.00, 0.45, 0.20};

constexpr std::array<HuWindow, 3> presets{bone_window, soft_tissue_window, skin_window};

QString coloured(const Eigen::Vector3d& colour, const QString& text) {
  const QColor c = QColor::fromRgbF(colour.x(), colour.y(), colour.z());
  return QString("<span style='color:%1'>■</span> %2<br>").arg(c.name(), text);
}

bool any_motion(const CaseController& controller) {
  const auto& motions = controller.motions();
  return std::any_of(motions.begin(), motions.end(),
                     [](const JawMotion& motion) { return motion != JawMotion{}; });
}

}  // namespace

ViewGrid::ViewGrid(QWidget* parent) : QWidget(parent), ui_(std::make_unique<Ui::ViewGrid>()) {
  ui_->setupUi(this);
  rest_.setSingleShot(true);
  rest_.setInterval(rest_ms);
  connect(&rest_, &QTimer::timeout, this, &ViewGrid::take_motion);
  for (const SlicePlane plane : all_slice_planes) slice(plane).set_up(plane, scene_);
  ui_->outlines_button->setToolTip(coloured(bone_colour, tr("bone that stays")) +
                                   coloured(segment_colour, tr("segments")) +
                                   coloured(before_colour, tr("skin before")) +
                                   coloured(predicted_colour, tr("skin predicted")));
}

ViewGrid::~ViewGrid() {
  cube_.detach();
  scale_bar_.detach();
  mark_.detach();
}

SliceView& ViewGrid::slice(SlicePlane plane) const {
  return *slices()[static_cast<std::size_t>(plane)];
}

std::array<SliceView*, 3> ViewGrid::slices() const {
  return {ui_->axial_view, ui_->coronal_view, ui_->sagittal_view};
}

void ViewGrid::set_up(CaseController& controller, FaceView& view) {
  controller_ = &controller;
  face_view_ = &view;
  ui_->view_splitter->insertWidget(0, &view);
  ui_->view_splitter->setStretchFactor(0, 1);
  ui_->view_splitter->setStretchFactor(1, 0);
  view.setMinimumSize(240, 200);
  view.canvas()->installEventFilter(this);
  vtkRenderer* renderer = view.renderer();
  for (Overlay* overlay : std::initializer_list<Overlay*>{&mark_, &cube_, &scale_bar_}) {
    overlay->attach(renderer);
  }
  mark_.set_visible(false);
  connect_slices();
  connect_controller();
  show_hu_window();
}

void ViewGrid::connect_slices() {
  for (SliceView* view : slices()) {
    connect(view, &SliceView::crosshair_chosen, this, &ViewGrid::set_crosshair);
    connect(view, &SliceView::hu_window_chosen, this, &ViewGrid::set_hu_window);
    connect(view, &SliceView::maximise_asked, this,
            [this, view] { maximise(maximised_ == view ? nullptr : view); });
  }
  connect(ui_->hu_window_box, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    if (index < static_cast<int>(presets.size())) set_hu_window(presets[index]);
  });
  connect(ui_->outlines_button, &QToolButton::toggled, this, &ViewGrid::set_outlines_visible);
}

void ViewGrid::connect_controller() {
  connect(controller_, &CaseController::case_opened, this, [this] { take_case(true); });
  connect(controller_, &CaseController::case_changed, this, [this] { take_case(false); });
  const auto wait = [this] { rest_.start(); };
  connect(controller_, &CaseController::motion_changed, this, wait);
  connect(controller_, &CaseController::refinement_changed, this, wait);
}

void ViewGrid::take_case(bool another) {
  const std::shared_ptr<const LoadedCase> loaded = controller_->shared_case();
  const Anatomy& anatomy = *loaded->anatomy;
  if (another || !scene_.has_volume() || &scene_.volume() != anatomy.ct.get()) {
    scene_.set_volume(anatomy.ct);
    for (SliceView* view : slices()) view->volume_changed();
    another = another || crosshair_ != scene_.lattice().nearest(crosshair_);
  }
  take_surfaces();
  if (another) {
    const SliceLattice& lattice = scene_.lattice();
    set_crosshair(anatomy.segments.empty() ? ((lattice.origin + lattice.last()) / 2).eval()
                                           : anatomy.segments.front().pivot);
  }
  lay_out();
}

/// What a segment is called in the slices: their surfaces' names are shown.
std::string ViewGrid::segment_words(const BoneSegment& segment) {
  return tr("Segment “%1”").arg(QString::fromStdString(segment.name)).toStdString();
}

/// The case's surfaces at rest; the motion is set when it rests.
void ViewGrid::take_surfaces() {
  const LoadedCase& loaded = controller_->loaded();
  const ReadyAnatomy& ready = *loaded.ready;
  scene_.remove_surfaces();
  scene_.set_surface(tr("Bone that stays").toStdString(), ready.skull_section, bone_colour);
  for (std::size_t s = 0; s < ready.segment_sections.size(); ++s) {
    scene_.set_surface(segment_words(loaded.anatomy->segments[s]), ready.segment_sections[s],
                       segment_colour);
  }
  scene_.set_surface(tr("Skin before").toStdString(), ready.face_section, before_colour);
  scene_.set_surface(tr("Skin predicted").toStdString(), ready.face_section, predicted_colour);
  scene_.set_surface_visible(tr("Skin predicted").toStdString(), false);
  rest_.start();
  for (SliceView* view : slices()) view->outlines_changed();
}

bool ViewGrid::slices_shown() const {
  return slices_visible_ && maximised_ != face_view_;
}

void ViewGrid::take_motion() {
  motion_stale_ = !slices_shown();
  if (motion_stale_ || !controller_->has_case()) return;
  const Anatomy& anatomy = *controller_->loaded().anatomy;
  const Response& response = controller_->response();
  for (std::size_t s = 0; s < anatomy.segments.size() && s < response.poses.size(); ++s) {
    scene_.set_surface_pose(segment_words(anatomy.segments[s]), response.poses[s]);
  }
  const std::string predicted = tr("Skin predicted").toStdString();
  const bool moved =
      any_motion(*controller_) && response.face.rows() == anatomy.face.mesh.surface.vertices.rows();
  if (moved) scene_.set_surface_points(predicted, response.face);
  scene_.set_surface_visible(predicted, moved);
  for (SliceView* view : slices()) view->outlines_changed();
}

void ViewGrid::set_crosshair(const Eigen::Vector3d& lps) {
  if (!scene_.has_volume()) return;
  crosshair_ = scene_.lattice().nearest(lps);
  for (SliceView* view : slices()) view->set_crosshair(crosshair_);
  mark_.set_place(crosshair_);
  face_view_->render_soon();
}

void ViewGrid::set_hu_window(const HuWindow& window) {
  hu_window_ = limited(window);
  for (SliceView* view : slices()) view->set_hu_window(hu_window_);
  show_hu_window();
}

/// A window that is no preset is an entry of its own, while it lasts.
void ViewGrid::show_hu_window() {
  QComboBox* box = ui_->hu_window_box;
  const int by_hand = static_cast<int>(presets.size());
  const auto preset = std::find(presets.begin(), presets.end(), hu_window_);
  if (preset != presets.end()) {
    box->removeItem(by_hand);
    box->setCurrentIndex(static_cast<int>(preset - presets.begin()));
    return;
  }
  const QString words = tr("By hand: level %1, width %2 HU")
                            .arg(std::lround(hu_window_.level))
                            .arg(std::lround(hu_window_.width));
  if (box->count() == by_hand) {
    box->addItem(words);
  } else {
    box->setItemText(by_hand, words);
  }
  box->setCurrentIndex(by_hand);
}

void ViewGrid::set_slices_visible(bool visible) {
  slices_visible_ = visible;
  if (!visible && maximised_ != face_view_) maximised_ = nullptr;
  lay_out();
}

void ViewGrid::set_outlines_visible(bool visible) {
  ui_->outlines_button->setChecked(visible);
  for (SliceView* view : slices()) view->set_outlines_visible(visible);
  emit outlines_toggled(visible);
}

void ViewGrid::maximise(QWidget* view) {
  if (view == maximised_) return;
  maximised_ = view;
  lay_out();
  if (view != nullptr) view->setFocus();
  emit maximised_changed(view != nullptr);
}

SliceView* ViewGrid::focused_slice() const {
  for (SliceView* view : slices()) {
    if (view->hasFocus()) return view;
  }
  return nullptr;
}

void ViewGrid::toggle_maximised() {
  QWidget* view = focused_slice();
  if (view == nullptr) view = face_view_;
  maximise(maximised_ == nullptr ? view : nullptr);
}

void ViewGrid::zoom(double factor) {
  if (SliceView* view = focused_slice()) return view->zoom(factor);
  face_view_->camera_mouse().zoom(factor);
}

void ViewGrid::fit_slices() {
  for (SliceView* view : slices()) view->fit();
}

/// A splitter gives a view that comes back no room that can be relied on: the room it had is kept.
void ViewGrid::keep_sizes() {
  if (!divided_ || !isVisible()) return;
  view_sizes_ = ui_->view_splitter->sizes();
  slice_sizes_ = ui_->slices_splitter->sizes();
}

void ViewGrid::lay_out() {
  keep_sizes();
  face_view_->setVisible(maximised_ == nullptr || maximised_ == face_view_);
  for (SliceView* view : slices()) {
    view->setVisible(maximised_ == nullptr || maximised_ == view);
  }
  ui_->slices_column->setVisible(slices_shown());
  const bool divided = maximised_ == nullptr && slices_visible_;
  if (divided && !divided_ && !view_sizes_.isEmpty()) {
    ui_->view_splitter->setSizes(view_sizes_);
    ui_->slices_splitter->setSizes(slice_sizes_);
  }
  divided_ = divided;
  mark_.set_visible(slices_shown() && scene_.has_volume());
  if (slices_shown() && motion_stale_) take_motion();
  face_view_->render_soon();
}

/// Shift and the mouse, as users of other programs know it. A tool may mean something else by it.
void ViewGrid::point_at(const QMouseEvent& mouse) {
  if (mouse.modifiers() != Qt::ShiftModifier || mouse.buttons() != Qt::NoButton) return;
  if (!slices_shown() || face_view_->tool() != nullptr) return;
  const auto place = face_view_->place_at(mouse.pos());
  if (!place) return;
  face_view_->camera_mouse().hurry();
  set_crosshair(*place);
}

bool ViewGrid::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseMove && watched == face_view_->canvas()) {
    point_at(*static_cast<QMouseEvent*>(event));
  }
  if (event->type() == QEvent::MouseButtonDblClick && watched == face_view_->canvas() &&
      static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
    maximise(maximised_ == face_view_ ? nullptr : face_view_);
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace gnathion
