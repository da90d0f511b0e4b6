#pragma once

#include <functional>
#include <memory>

#include "bone/osteotomy.h"

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace gnathion {

/// A blade or a box in the view, translucent, with grips for the mouse: the yellow ball before it
/// moves it in the picture's plane, white balls at its sides make it larger or smaller, the two
/// green balls near its front corners turn it about its centre. The balls stand where bone rarely
/// hides them: at the side that looks forward. mm, LPS.
///
/// The handle only reports; it changes nothing but itself. One thread, the window's own.
class CutHandle {
 public:
  using Listener = std::function<void(const BoundedCut& cut)>;

  CutHandle();
  ~CutHandle();
  CutHandle(const CutHandle&) = delete;
  CutHandle& operator=(const CutHandle&) = delete;

  /// Shows it in `renderer`, which must be in the interactor's window. Both must outlive this
  /// handle, or detach() must be called before.
  void attach(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  void detach();
  bool is_attached() const;

  /// Shows another cut without calling a listener. Throws Error(anatomy) as box_of().
  void set_cut(const BoundedCut& cut);
  const BoundedCut& cut() const;
  /// RGB, 0..1, of the blade's or box's sides.
  void set_colour(const Eigen::Vector3d& colour);

  /// Called for every step of a drag. A blade's seed moves and turns with it.
  void on_changed(Listener listener);
  /// Called once when the mouse button is let go.
  void on_released(Listener listener);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
