#include "app/motion_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLocale>
#include <QMouseEvent>
#include <QShortcut>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/face_view.h"
#include "app/motion_words.h"
#include "app/theme.h"
#include "bone/condyles.h"
#include "geometry/triangle_mesh.h"
#include "ui_motion_panel.h"

namespace gnathion {
namespace {

/// In the order of the choices in the box.
enum PivotChoice { centre_pivot, hinge_pivot, front_pivot, typed_pivot };

std::array<double JawMotion::*, 6> members() {
  return {&JawMotion::forward_mm, &JawMotion::up_mm,    &JawMotion::left_mm,
          &JawMotion::pitch_deg,  &JawMotion::roll_deg, &JawMotion::yaw_deg};
}

/// Whether the controller takes it as it is.
bool can_be_set(const JawMotion& motion) {
  for (std::size_t i = 0; i < 6; ++i) {
    const double limit = i < 3 ? largest_shift_mm : largest_turn_deg;
    if (std::abs(motion.*members()[i]) > limit) return false;
  }
  return true;
}

QString fixed(double value, int decimals) {
  // A value that rounds to zero is written without a sign.
  const QString text = QLocale().toString(value, 'f', decimals);
  return text.toDouble() == 0 ? QLocale().toString(0.0, 'f', decimals) : text;
}

void put(QTableWidget* table, int row, int column, const QString& text) {
  if (table->item(row, column) == nullptr) {
    auto* item = new QTableWidgetItem;
    item->setTextAlignment(static_cast<int>(Qt::AlignVCenter) |
                           static_cast<int>(column == 0 ? Qt::AlignLeft : Qt::AlignRight));
    table->setItem(row, column, item);
  }
  table->item(row, column)->setText(text);
}

/// Without reporting it as edited.
void put(QDoubleSpinBox* box, double value) {
  // Setting the value that a box has would disturb the text that is being typed into it.
  const double hundredths = std::pow(10.0, box->decimals());
  const double rounded = std::round(value * hundredths) / hundredths;
  if (box->value() == rounded) return;
  const QSignalBlocker silent(box);
  box->setValue(rounded);
}

/// The segment's most forward point: the pogonion of a chin, the incisors' edge of an upper jaw.
Eigen::Vector3d front_of(const BoneSegment& segment) {
  Eigen::Index front = 0;
  segment.mesh.vertices.col(1).minCoeff(&front);
  return segment.mesh.vertices.row(front);
}

/// The condyles of the piece of bone that the lowest segment was cut from.
HingeAxis condylar_axis(const Anatomy& anatomy) {
  Eigen::Vector3d lowest = front_of(anatomy.segments.front());
  for (const BoneSegment& segment : anatomy.segments) {
    const Eigen::Vector3d front = front_of(segment);
    if (front.z() < lowest.z()) lowest = front;
  }
  const Condyles condyles = find_condyles(anatomy.bone, lowest);
  return {condyles.right, condyles.left};
}

/// Where to begin when the condyles must be typed: behind and above the segment.
HingeAxis likely_axis(const BoneSegment& segment) {
  const Eigen::Vector3d middle = front_of(segment) + Eigen::Vector3d(0, 80, 75);
  return {middle - Eigen::Vector3d(50, 0, 0), middle + Eigen::Vector3d(50, 0, 0)};
}

bool about_equal(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).norm() < 0.01;
}

}  // namespace

MotionPanel::MotionPanel(QWidget* parent)
    : QWidget(parent), ui_(std::make_unique<Ui::MotionPanel>()) {
  ui_->setupUi(this);
  boxes_ = {ui_->forward_box, ui_->up_box,   ui_->left_box,
            ui_->pitch_box,   ui_->roll_box, ui_->yaw_box};
  pivot_boxes_ = {ui_->pivot_x_box, ui_->pivot_y_box, ui_->pivot_z_box};
  axis_boxes_ = {ui_->axis_right_x_box, ui_->axis_right_y_box, ui_->axis_right_z_box,
                 ui_->axis_left_x_box,  ui_->axis_left_y_box,  ui_->axis_left_z_box};
  lock_buttons_ = {ui_->lock_x_button, ui_->lock_y_button, ui_->lock_z_button};
  connect_widgets();
  connect_locks();
  ui_->segment_box->hide();
  ui_->axis_group->hide();
  ui_->pivot_note->hide();
  QHeaderView* header = ui_->landmark_table->horizontalHeader();
  header->setSectionResizeMode(0, QHeaderView::Stretch);
  header->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  header->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  ui_->no_landmarks_label->hide();  // until a case says so
  ui_->landmark_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
}

MotionPanel::~MotionPanel() = default;

void MotionPanel::connect_widgets() {
  const auto changed = QOverload<double>::of(&QDoubleSpinBox::valueChanged);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const double limit = i < 3 ? largest_shift_mm : largest_turn_deg;
    boxes_[i]->setRange(-limit, limit);
    connect(boxes_[i], changed, this, [this, i] { edit_member(i); });
  }
  ui_->hinge_box->setRange(-largest_turn_deg, largest_turn_deg);
  connect(ui_->hinge_box, changed, this, &MotionPanel::edit_hinge);
  connect(ui_->reset_button, &QPushButton::clicked, this, [this] { emit motion_edited({}); });
  connect(ui_->segment_box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &MotionPanel::segment_chosen);
  connect(ui_->pivot_box, QOverload<int>::of(&QComboBox::activated), this,
          &MotionPanel::choose_pivot);
  for (QDoubleSpinBox* box : pivot_boxes_) {
    box->setRange(-9999, 9999);
    box->setKeyboardTracking(false);  // each change makes a step of the history
    connect(box, changed, this, &MotionPanel::type_pivot);
  }
  for (QDoubleSpinBox* box : axis_boxes_) box->setRange(-9999, 9999);
  connect(ui_->axis_button, &QToolButton::toggled, ui_->axis_group, &QWidget::setVisible);
  connect(ui_->axis_use_button, &QPushButton::clicked, this, &MotionPanel::type_hinge);
  connect(ui_->axis_find_button, &QPushButton::clicked, this, &MotionPanel::forget_hinge);
  connect(ui_->ghost_check, &QCheckBox::toggled, this, &MotionPanel::show_in_view);
}

void MotionPanel::connect_locks() {
  constexpr std::array<int, 3> keys{Qt::Key_X, Qt::Key_Y, Qt::Key_Z};
  for (int axis = 0; axis < 3; ++axis) {
    QToolButton* button = lock_buttons_[static_cast<std::size_t>(axis)];
    connect(button, &QToolButton::clicked, this, [this, axis](bool checked) {
      set_lock(checked ? std::optional<int>(axis) : std::nullopt);
    });
    auto* key = new QShortcut(keys[static_cast<std::size_t>(axis)], this, nullptr, nullptr,
                              Qt::WindowShortcut);
    connect(key, &QShortcut::activated, button, [this, button] {
      if (active_ && button->isEnabled()) button->click();
    });
  }
}

void MotionPanel::connect_to(CaseController& controller, FaceView& view) {
  controller_ = &controller;
  view_ = &view;
  view.canvas()->installEventFilter(this);
  connect(&view, &FaceView::segment_turned, this, &MotionPanel::turn_by_ring);
  connect(&view, &FaceView::drag_ended, this, [this] { turned_from_.reset(); });
  connect(&view, &FaceView::look_changed, this, &MotionPanel::show_in_view);
  connect(&view, &FaceView::case_shown, this, &MotionPanel::show_case);
  connect(&controller, &CaseController::motion_changed, this, [this] {
    watch_.look(controller_->response().poses);
    show_hinge();
    show_in_view();
  });
  connect(&controller, &CaseController::history_changed, this, &MotionPanel::take_hinge);
  connect(&controller, &CaseController::active_segment_changed, this, &MotionPanel::show_segment);
  connect(&watch_, &CollisionWatch::found, this, &MotionPanel::show_collisions);
  connect(&finding_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    QString note = tr("%1: %2.").arg(failure.problem, failure.remedy);
    note[0] = note[0].toUpper();
    put_hinge({}, note);
  });
}

void MotionPanel::set_active(bool active) {
  if (active == active_) return;
  active_ = active;
  if (active) {
    ghost_.attach(view_->renderer());
    marks_.attach(view_->renderer());
  }
  show_in_view();
  show_collisions();
  if (!active) {
    ghost_.detach();
    marks_.detach();
  }
}

const BoneSegment& MotionPanel::active_bone() const {
  return controller_->loaded().anatomy->segments[controller_->active_segment()];
}

/// What does not change with a motion.
void MotionPanel::show_case() {
  turned_from_.reset();
  watch_.watch(controller_->shared_case());
  if (controller_->has_segments()) {
    watch_.look(controller_->response().poses);
    take_hinge();
    view_->set_active_segment(controller_->active_segment());
    show_segment();
  }
  show_collisions();
  show_in_view();
}

void MotionPanel::show_segment() {
  const std::size_t s = controller_->active_segment();
  ghost_.set_bone(active_bone().mesh.vertices, controller_->loaded().ready->coarse_segments[s]);
  show_pivot();
  show_hinge();
  show_in_view();
}

/// Rings and ghost.
void MotionPanel::show_in_view() {
  if (view_ == nullptr) return;
  const bool any = active_ && controller_->has_segments();
  const bool moved = any && controller_->response().poses.size() > controller_->active_segment() &&
                     controller_->response().poses[controller_->active_segment()] != RigidMotion{};
  ghost_.set_visible(moved && ui_->ghost_check->isChecked() && !view_->is_before_visible());
  // Through skin that is opaque nobody looks for bone.
  ghost_.set_in_front(view_->face_opacity() < 1);
  view_->set_pivot(any && turns_ ? std::optional(active_bone().pivot) : std::nullopt);
  view_->render_soon();
}

void MotionPanel::edit_member(std::size_t member) {
  JawMotion motion = shown_;
  motion.*members()[member] = boxes_[member]->value();
  emit motion_edited(motion);
}

/// Rounded to a tenth of a degree, so that the angle turned is one that can be typed.
void MotionPanel::turn_by_ring(int axis, double degrees) {
  if (!turned_from_) turned_from_ = controller_->motion();
  const double tenths = std::round(10 * degrees) / 10;
  const JawMotion motion = turned(*turned_from_, Eigen::Vector3d::Unit(axis), tenths);
  if (!can_be_set(motion)) return;  // the bone waits at its limit for the mouse
  controller_->hold_motion(true);
  controller_->set_motion(motion);
}

void MotionPanel::set_lock(std::optional<int> axis) {
  for (int a = 0; a < 3; ++a) lock_buttons_[static_cast<std::size_t>(a)]->setChecked(axis == a);
  if (view_ == nullptr) return;
  view_->set_axis_lock(axis);
  view_->render_soon();
}

void MotionPanel::show_pivot() {
  const BoneSegment& bone = active_bone();
  const auto& planned = controller_->loaded().plan.segments[controller_->active_segment()].pivot;
  int choice = typed_pivot;
  if (!planned) {
    choice = centre_pivot;
  } else if (hinge_ && about_equal(*planned, hinge_->middle())) {
    choice = hinge_pivot;
  } else if (about_equal(*planned, front_of(bone))) {
    choice = front_pivot;
  }
  ui_->pivot_box->setCurrentIndex(choice);
  for (int k = 0; k < 3; ++k) put(pivot_boxes_[static_cast<std::size_t>(k)], bone.pivot[k]);
}

void MotionPanel::choose_pivot(int choice) {
  ui_->pivot_note->hide();
  if (choice == hinge_pivot && !hinge_) {
    show_pivot();
    ui_->pivot_note->setText(tr("The hinge axis is not known: give it below, with Axis…"));
    ui_->pivot_note->show();
    return;
  }
  if (choice == centre_pivot) set_pivot({});
  if (choice == hinge_pivot) set_pivot(hinge_->middle());
  if (choice == front_pivot) set_pivot(front_of(active_bone()));
  if (choice == typed_pivot) {
    ui_->pivot_x_box->setFocus();
    ui_->pivot_x_box->selectAll();
  }
}

void MotionPanel::type_pivot() {
  ui_->pivot_note->hide();
  Eigen::Vector3d pivot = active_bone().pivot;
  for (int k = 0; k < 3; ++k) {
    const QDoubleSpinBox* box = pivot_boxes_[static_cast<std::size_t>(k)];
    // What was not typed keeps its decimals.
    if (std::abs(box->value() - pivot[k]) > 0.5 * std::pow(0.1, box->decimals())) {
      pivot[k] = box->value();
    }
  }
  set_pivot(pivot);
}

/// The bone stays where it is: its motion is told anew.
void MotionPanel::set_pivot(const std::optional<Eigen::Vector3d>& pivot) {
  SurgicalCase plan = controller_->plan();
  const std::size_t s = controller_->active_segment();
  const auto& known = controller_->loaded().plan.segments;
  if (plan.segments.size() != known.size() || plan.segments[s].cut != known[s].cut) {
    show_pivot();  // the segment is just being cut anew
    return;
  }
  // Motions that are no step yet; during an edit the plan has them.
  for (std::size_t i = 0; !controller_->is_editing() && i < plan.segments.size(); ++i) {
    plan.segments[i].motion = controller_->motions()[i];
  }
  PlannedSegment& segment = plan.segments[s];
  const auto place = [&](const std::optional<Eigen::Vector3d>& given) {
    return given ? *given : centre_of_volume(active_bone().mesh);
  };
  segment.motion = about_pivot(segment.motion, place(segment.pivot), place(pivot));
  segment.pivot = pivot;
  if (can_be_set(segment.motion)) {
    controller_->edit(tr("Set the pivot"), std::move(plan));
    return;
  }
  show_pivot();
  ui_->pivot_note->setText(
      tr("About that point the same position takes a shift of more than %1 mm: turn the segment "
         "less, or reset its motion first.")
          .arg(largest_shift_mm));
  ui_->pivot_note->show();
}

/// The axis of the plan, or else that of the bone.
void MotionPanel::take_hinge() {
  if (!controller_->has_segments() || controller_->is_editing()) return;
  const std::optional<HingeAxis>& given = controller_->plan().hinge;
  if (given) {
    if (hinge_ == given && hinge_is_given_) return;
    hinge_is_given_ = true;
    finding_.cancel();
    put_hinge(given, tr("Axis through two typed points, %1 mm apart.")
                         .arg(fixed((given->left - given->right).norm(), 0)));
    return;
  }
  const bool same_bone = hinge_case_ && hinge_case_->plan.ct == controller_->loaded().plan.ct &&
                         hinge_case_->plan.bone == controller_->loaded().plan.bone;
  if (same_bone && !hinge_is_given_) return;
  hinge_is_given_ = false;
  find_condyles();
}

/// Looks for the axis on the bone again.
void MotionPanel::forget_hinge() {
  SurgicalCase plan = controller_->plan();
  if (!plan.hinge) return find_condyles();
  plan.hinge.reset();
  controller_->edit(tr("Find the hinge axis"), std::move(plan));
}

void MotionPanel::find_condyles() {
  hinge_case_ = controller_->shared_case();
  put_hinge({}, tr("The condyles are being looked for."));
  finding_.start([this, loaded = hinge_case_](Progress&) {
    const HingeAxis hinge = condylar_axis(*loaded->anatomy);
    return [this, hinge] {
      put_hinge(hinge, tr("Condyles found on the bone, %1 mm apart.")
                           .arg(fixed((hinge.left - hinge.right).norm(), 0)));
    };
  });
}

void MotionPanel::put_hinge(const std::optional<HingeAxis>& hinge, const QString& note) {
  hinge_ = hinge;
  ui_->hinge_note->setText(note);
  if (!controller_->has_segments()) return;
  const HingeAxis shown = hinge ? *hinge : likely_axis(active_bone());
  for (int k = 0; k < 3; ++k) {
    put(axis_boxes_[static_cast<std::size_t>(k)], shown.right[k]);
    put(axis_boxes_[static_cast<std::size_t>(k) + 3], shown.left[k]);
  }
  show_pivot();
  show_hinge();
}

void MotionPanel::type_hinge() {
  HingeAxis hinge;
  for (int k = 0; k < 3; ++k) {
    hinge.right[k] = axis_boxes_[static_cast<std::size_t>(k)]->value();
    hinge.left[k] = axis_boxes_[static_cast<std::size_t>(k) + 3]->value();
  }
  if (hinge.left.x() - hinge.right.x() < least_hinge_mm) {
    ui_->hinge_note->setText(
        tr("The left point must lie at least %1 mm to the patient's left (x) of the right one.")
            .arg(least_hinge_mm));
    return;
  }
  SurgicalCase plan = controller_->plan();
  plan.hinge = hinge;
  if (plan == controller_->plan()) return;
  controller_->edit(tr("Set the hinge axis"), std::move(plan));
}

void MotionPanel::show_hinge() {
  const bool usable = hinge_ && turns_ && controller_->has_segments();
  ui_->hinge_box->setEnabled(usable);
  const auto& poses = controller_->response().poses;
  const std::size_t s = controller_->active_segment();
  put(ui_->hinge_box, usable && s < poses.size() ? hinge_angle(poses[s], *hinge_) : 0);
}

void MotionPanel::edit_hinge(double degrees) {
  const Eigen::Vector3d& pivot = active_bone().pivot;
  const RigidMotion before = rigid_motion(controller_->motion(), pivot);
  const auto motion = [&](double angle) {
    return jaw_motion(with_hinge_angle(before, *hinge_, angle), pivot);
  };
  // As far as the segment may be moved: cut at its limits a motion would no longer be the hinge's.
  double reached = degrees, refused = degrees;
  if (!can_be_set(motion(degrees))) {
    reached = hinge_angle(before, *hinge_);
    while (std::abs(refused - reached) > 0.01) {
      const double middle = (reached + refused) / 2;
      (can_be_set(motion(middle)) ? reached : refused) = middle;
    }
  }
  emit motion_edited(motion(reached));
}

void MotionPanel::show_collisions() {
  if (view_ == nullptr) return;
  QStringList said;
  Points places(0, 3);
  std::vector<PlacedWord> depths;
  const bool any = controller_->has_segments();
  const double middle = any ? (controller_->loaded().anatomy->bone.vertices.col(0).minCoeff() +
                               controller_->loaded().anatomy->bone.vertices.col(0).maxCoeff()) /
                                  2
                            : 0;
  QStringList names;
  for (std::size_t b = 0; any && b < controller_->loaded().anatomy->segments.size(); ++b) {
    names << QString::fromStdString(controller_->loaded().anatomy->segments[b].name);
  }
  for (const Collision& collision : watch_.collisions()) {
    said << collision_words(collision, names, middle);
    const Eigen::Index before = places.rows();
    places.conservativeResize(before + collision.places.rows(), 3);
    places.bottomRows(collision.places.rows()) = collision.places;
    depths.push_back({collision.deepest, tr("%1 mm").arg(fixed(collision.depth, 1)).toStdString()});
  }
  const bool shown = active_ && !view_->is_before_visible();
  marks_.show(shown ? places : Points(0, 3), shown ? depths : std::vector<PlacedWord>{});
  QString text = said.join("\n").toHtmlEscaped().replace("\n", "<br>");
  if (said.isEmpty()) {
    text =
        watch_.is_ready() ? tr("No bone runs into other bone.") : tr("Bones are being prepared.");
  } else {
    text = QString("<b style='color:%1'>%2</b>").arg(warning_colour(palette()).name(), text);
  }
  ui_->collision_label->setText(any ? text : QString());
  view_->render_soon();
}

bool MotionPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool pressed = event->type() == QEvent::MouseButtonPress;
  if (!pressed && event->type() != QEvent::MouseButtonRelease) {
    return QWidget::eventFilter(watched, event);
  }
  const auto* mouse = static_cast<QMouseEvent*>(event);
  if (mouse->button() != Qt::LeftButton) return false;
  if (pressed) pressed_at_ = mouse->pos();
  if (!pressed && mouse->pos() == pressed_at_) click_segment(mouse->pos());
  return false;
}

/// A click on a segment that is seen, through the skin, chooses it.
void MotionPanel::click_segment(QPoint pixel) {
  if (!active_ || !controller_->has_segments() || view_->tool() != nullptr) return;
  if (view_->face_opacity() >= 1 || view_->is_before_visible() || view_->is_grip_held()) return;
  const int segment = watch_.segment_at(view_->view_point(pixel), controller_->response().poses);
  if (segment >= 0) emit segment_chosen(segment);
}

void MotionPanel::set_segments(const QStringList& names) {
  const QSignalBlocker silent(ui_->segment_box);
  ui_->segment_box->clear();
  ui_->segment_box->addItems(names);
  ui_->segment_box->setVisible(names.size() > 1);
  if (controller_ != nullptr && controller_->has_segments()) {
    ui_->segment_box->setCurrentIndex(static_cast<int>(controller_->active_segment()));
  }
}

void MotionPanel::show_active_segment(int segment) {
  const QSignalBlocker silent(ui_->segment_box);
  ui_->segment_box->setCurrentIndex(segment);
}

void MotionPanel::show_motion(const JawMotion& motion) {
  shown_ = motion;
  for (std::size_t i = 0; i < boxes_.size(); ++i) put(boxes_[i], motion.*members()[i]);
}

void MotionPanel::show_response(const Response& response) {
  ui_->mean_value->setText(tr("%1 mm").arg(fixed(response.displacement.mean, 1)));
  ui_->p95_value->setText(tr("%1 mm").arg(fixed(response.displacement.p95, 1)));
  ui_->max_value->setText(tr("%1 mm").arg(fixed(response.displacement.max, 1)));
  QTableWidget* table = ui_->landmark_table;
  const bool any = !response.landmarks.empty();
  table->setVisible(any);
  ui_->no_landmarks_label->setVisible(!any);
  table->setRowCount(static_cast<int>(response.landmarks.size()));
  int row = 0;
  for (const auto& [name, landmark] : response.landmarks) {
    put(table, row, 0, landmark_words(name));
    put(table, row, 1, fixed(landmark.displacement.norm(), 1));
    put(table, row, 2, landmark.bone_mm > 0 ? fixed(landmark.ratio, 2) : QString(QChar(0x2013)));
    ++row;
  }
}

void MotionPanel::set_turns_enabled(bool enabled) {
  turns_ = enabled;
  for (QDoubleSpinBox* box : {ui_->pitch_box, ui_->roll_box, ui_->yaw_box}) {
    box->setEnabled(enabled);
  }
  if (controller_ == nullptr) return;
  show_hinge();
  show_in_view();
}

}  // namespace gnathion
