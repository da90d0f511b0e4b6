#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app/background_task.h"
#include "app/case_controller.h"
#include "app/view_tool.h"
#include "geometry/surface_point.h"
#include "render/compare_scene.h"
#include "render/measure_marks.h"

namespace gnathion {

class FaceView;

/// A point of the face under the mouse.
struct FaceReading {
  Eigen::Vector3d before, after;    ///< mm, LPS
  bool on_before = false;           ///< which of the two faces the mouse is on
  std::optional<double> signed_mm;  ///< of the predicted face to the one before; none: not refined
};

/// Between two points of the face, mm.
struct DistanceReading {
  double before = 0, after = 0;
};

/// The comparison in the 3D view: how the two faces are laid side by side, the divider that the
/// mouse drags, and what is measured on the face. Shows what it is told and knows no panel.
class CompareView : public QObject, private ViewTool {
  Q_OBJECT
 public:
  /// Both must outlive this object.
  CompareView(CaseController& controller, FaceView& view, QObject* parent = nullptr);
  ~CompareView() override;

  /// While active it has the left mouse button and its renderers in the view.
  void set_active(bool active);
  bool is_active() const { return active_; }

  void set_mode(CompareMode mode);
  CompareMode mode() const { return mode_; }
  void set_wipe(double fraction);
  void set_blend(double share_of_before);
  /// The profile's plane, mm to the patient's left of the face's middle.
  void set_section(double left_mm);
  /// The middle: x of a sagittal plane, LPS mm: the median of the landmarks, else the tip of the
  /// nose. \pre the controller has a case
  double middle_x() const;

  /// While measuring a click on the face sets an end of a distance.
  void set_measuring(bool measuring);
  void clear_distance();
  /// None before two ends are set.
  std::optional<DistanceReading> distance() const;
  std::size_t ends() const { return ends_.size(); }

  /// Whether the face can be asked for points: what that needs is made beside the window.
  bool can_point() const { return rest_tree_ != nullptr && after_tree_ != nullptr; }
  /// What lies under a place of the canvas (logical pixels); nothing beside the face.
  std::optional<FaceReading> reading_at(QPoint pixel) const;
  const CompareScene& scene() const { return scene_; }
  /// The profile that is drawn.
  const Profile& profile() const { return profile_; }

 signals:
  void wipe_dragged(double fraction);
  void distance_changed();
  /// The mouse is on the face, or (nothing) has left it.
  void pointed(const std::optional<gnathion::FaceReading>& reading);
  void ready_to_point();

 private:
  bool pressed(const ViewPoint& at) override;
  void dragged(const ViewPoint& at) override;
  void released(const ViewPoint& at) override;
  void hovered(const ViewPoint& at) override;
  void left() override;

  void show_case();
  void show_answer();
  void show_words();
  void show_profile();
  void frame_profile();
  void show_distance();
  void grow_trees();
  void fill_before();
  double fraction(QPoint pixel) const;
  bool on_divider(QPoint pixel) const;
  std::optional<SurfacePoint> point_at(QPoint pixel) const;
  double aspect_ratio() const;

  CaseController& controller_;
  FaceView& view_;
  CompareScene scene_;
  MeasureMarks marks_before_, marks_after_;
  Profile profile_;
  bool active_ = false;
  bool before_filled_ = false;
  bool measuring_ = false;
  bool drags_divider_ = false;
  QPoint paper_from_;  ///< where the paper of the profile was grasped last
  CompareMode mode_ = CompareMode::side_by_side;
  double blend_ = 0.5;
  double section_mm_ = 0;
  std::shared_ptr<const LoadedCase> shown_;  ///< the case that the parts below belong to
  std::vector<SurfacePoint> ends_;           ///< of the distance
  std::shared_ptr<const BspTree> rest_tree_, after_tree_;  ///< null: being made
  QTimer rest_;                                            ///< runs out when the face has rested
  BackgroundTask growing_;
};

}  // namespace gnathion
