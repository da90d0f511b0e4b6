#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace gnathion {

/// Grips in the view for moving a bone segment with the mouse: a ball that follows the mouse in the
/// picture's plane, three smaller balls on stalks that move along one anatomical axis only (left,
/// forward, up), and three rings about the pivot that turn about these axes. All vectors are mm,
/// LPS; axes 0, 1, 2 are left–right, front–back, up–down. The balls' size on the screen stays the
/// same.
///
/// The handle only reports; it moves nothing but itself. One thread, the window's own.
class SegmentHandle {
 public:
  /// translation: of the segment from where it was before any motion, mm, LPS.
  using Listener = std::function<void(const Eigen::Vector3d& translation)>;

  SegmentHandle();
  ~SegmentHandle();
  SegmentHandle(const SegmentHandle&) = delete;
  SegmentHandle& operator=(const SegmentHandle&) = delete;

  /// Shows the grips in `renderer`, which must be in the interactor's window. Both must outlive
  /// this handle, or detach() must be called before.
  void attach(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  void detach();
  bool is_attached() const;

  /// Shows or hides the grips. Hidden grips take no mouse events.
  void set_visible(bool visible);

  /// Where the ball is at translation zero. Choose a place in front of the skin, since what lies
  /// inside an opaque face cannot be seen: 20 mm before the chin, say.
  void set_home(const Eigen::Vector3d& position);
  /// Moves the grips without calling a listener, so that numbers typed elsewhere can be shown.
  void set_translation(const Eigen::Vector3d& translation);
  Eigen::Vector3d translation() const;
  /// About which the rings turn, where it is at translation zero; without one there are no rings.
  void set_pivot(const std::optional<Eigen::Vector3d>& pivot);
  /// Keeps all grips to one axis: the big ball moves along it, the grips of the others are hidden.
  void set_axis_lock(std::optional<int> axis);
  /// Whether the mouse is on a grip or holds one.
  bool is_held() const;

  /// Called when a grip or a ring is taken, before the frame that shows it.
  void on_taken(std::function<void()> listener);
  /// Called for every step of a drag.
  void on_moved(Listener listener);
  /// Called once when the mouse button is let go, after the last on_moved: one undo step.
  void on_released(Listener listener);
  /// Called for every step of a ring's drag: the turn about the axis since the press, degrees,
  /// right-handed. When it ends, on_released's listener is called.
  void on_turned(std::function<void(int axis, double degrees)> listener);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
