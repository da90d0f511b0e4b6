#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace gnathion {

/// Three rings about a point for turning something with the mouse about the patient's axes: the
/// ring about left–right pitches, that about front–back rolls, that about the vertical yaws. They
/// are drawn before everything else, so that a pivot inside the head can be taken hold of. All
/// points mm, LPS; axes 0, 1, 2 are +x (left), +y (back), +z (up).
///
/// The rings only report; they turn nothing. One thread, the window's own.
class TurningRings {
 public:
  /// How far the mouse has turned a ring since it was taken, degrees, right-handed about the axis.
  using Listener = std::function<void(int axis, double degrees)>;

  static constexpr double radius = 32;  ///< mm

  TurningRings();
  ~TurningRings();
  TurningRings(const TurningRings&) = delete;
  TurningRings& operator=(const TurningRings&) = delete;

  /// Both must outlive the rings, or detach() must be called before. Events that a grip with a
  /// higher priority takes never arrive here; those taken here never reach the camera.
  void attach(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  void detach();
  /// Hidden rings take no events; one that is held is let go without a word.
  void set_visible(bool visible);
  void set_centre(const Eigen::Vector3d& centre);
  /// Only the ring about this axis is there; none: all.
  void set_axis_lock(std::optional<int> axis);
  bool is_held() const;

  /// Called when a ring is taken, before the frame that shows it.
  void on_taken(std::function<void()> listener);
  /// Called for every step of a drag, which draws a frame afterwards.
  void on_turned(Listener listener);
  /// Called once when the mouse button is let go.
  void on_released(std::function<void()> listener);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
