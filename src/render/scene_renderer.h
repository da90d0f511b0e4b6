#pragma once

#include <vtkOpenGLRenderer.h>

namespace gnathion {

/// VTK's renderer, which can save what it spends on putting translucent surfaces in order: two more
/// passes over the whole picture, a third of a frame's time for a software renderer.
class SceneRenderer : public vtkOpenGLRenderer {
 public:
  static SceneRenderer* New();
  vtkTypeMacro(SceneRenderer, vtkOpenGLRenderer);

  /// true: translucent surfaces are laid over what is behind them in the order in which they were
  /// added. Right where there is one at a place, or where the outer ones were added later.
  void set_quick(bool quick) { quick_ = quick; }
  void DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* frame) override;

 private:
  bool quick_ = false;
};

}  // namespace gnathion
