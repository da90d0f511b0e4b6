#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

#include "app/case_controller.h"
#include "app/collision_watch.h"
#include "plan/hinge.h"
#include "render/collision_marks.h"
#include "render/ghost_bones.h"

class QDoubleSpinBox;
class QToolButton;
namespace Ui {
class MotionPanel;
}

namespace gnathion {

class FaceView;

/// The step in which a segment is moved: the numbers of its motion in anatomical words, the pivot
/// that they are about, the hinge of the lower jaw, the lock of the grips, and what follows: where
/// bone runs into bone, and what the face does. In the view it adds the rings, the ghost of where
/// the segment was, and the marks of collisions.
class MotionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit MotionPanel(QWidget* parent = nullptr);
  ~MotionPanel() override;

  /// To be called once. Both must outlive the panel's use.
  void connect_to(CaseController& controller, FaceView& view);
  /// Whether this step is chosen: what it adds to the view is there.
  void set_active(bool active);

  /// What the segments are called; the choice is hidden where there is one.
  void set_segments(const QStringList& names);
  void show_active_segment(int segment);
  /// Shows a motion without reporting it as edited.
  void show_motion(const JawMotion& motion);
  void show_response(const Response& response);
  /// false: a model of forces, which cannot turn the bone.
  void set_turns_enabled(bool enabled);

  const CollisionWatch& collision_watch() const { return watch_; }
  /// None: not found, and not typed yet.
  const std::optional<HingeAxis>& hinge() const { return hinge_; }

 signals:
  void motion_edited(const gnathion::JawMotion& motion);
  void segment_chosen(int segment);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void connect_widgets();
  void connect_locks();
  void show_case();
  void show_segment();
  void show_in_view();
  void edit_member(std::size_t member);
  void turn_by_ring(int axis, double degrees);
  void set_lock(std::optional<int> axis);
  void show_pivot();
  void choose_pivot(int choice);
  void type_pivot();
  void set_pivot(const std::optional<Eigen::Vector3d>& pivot);
  void find_condyles();
  void show_hinge();
  void edit_hinge(double degrees);
  void type_hinge();
  void take_hinge();
  void forget_hinge();
  void put_hinge(const std::optional<HingeAxis>& hinge, const QString& note);
  void show_collisions();
  void click_segment(QPoint pixel);
  const BoneSegment& active_bone() const;

  std::unique_ptr<Ui::MotionPanel> ui_;
  std::array<QDoubleSpinBox*, 6> boxes_;  ///< in the order of JawMotion's members
  std::array<QDoubleSpinBox*, 3> pivot_boxes_;
  std::array<QDoubleSpinBox*, 6> axis_boxes_;  ///< right x, y, z, left x, y, z
  std::array<QToolButton*, 3> lock_buttons_;   ///< x, y, z
  CaseController* controller_ = nullptr;
  FaceView* view_ = nullptr;
  JawMotion shown_;  ///< in full, of which the boxes show hundredths
  bool active_ = false;
  bool turns_ = true;
  std::optional<JawMotion> turned_from_;  ///< what a ring that is held began with
  std::optional<HingeAxis> hinge_;
  bool hinge_is_given_ = false;                   ///< in the plan; else found on the bone
  std::shared_ptr<const LoadedCase> hinge_case_;  ///< in which it was looked for
  QPoint pressed_at_;
  GhostBones ghost_;
  CollisionMarks marks_;
  CollisionWatch watch_;
  BackgroundTask finding_;
};

}  // namespace gnathion
