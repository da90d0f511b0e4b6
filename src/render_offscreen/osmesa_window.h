#pragma once

#include <GL/osmesa.h>
#include <vtkGenericOpenGLRenderWindow.h>

namespace gnathion {

/// A VTK render window that draws with OSMesa, Mesa's software OpenGL in memory: it needs neither a
/// display nor a graphics card. VTK draws into a framebuffer object of its own, so the context's
/// own buffer stays tiny.
class OsmesaWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static OsmesaWindow* New();
  vtkTypeMacro(OsmesaWindow, vtkGenericOpenGLRenderWindow);

  /// false when OSMesa gave no OpenGL 3.3 context.
  bool has_context() const { return context_ != nullptr; }

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return has_context() ? 1 : 0; }
  vtkTypeBool IsDirect() override { return 0; }
  void OpenGLInitContext() override;
  void Finalize() override;

 protected:
  OsmesaWindow();
  ~OsmesaWindow() override;

 private:
  static constexpr int side = 32;  // pixels of the context's own buffer
  OSMesaContext context_ = nullptr;
  unsigned char buffer_[side * side * 4] = {};
};

}  // namespace gnathion
