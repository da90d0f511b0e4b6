#include "offscreen/osmesa_window.h"

#include <vtkObjectFactory.h>

#include "offscreen/glew_for_osmesa.h"

namespace gnathion {

vtkStandardNewMacro(OsmesaWindow);

OsmesaWindow::OsmesaWindow() {
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_DEPTH_BITS,
                        24,
                        OSMESA_STENCIL_BITS,
                        8,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0};
  context_ = OSMesaCreateContextAttribs(wanted, nullptr);
  SetReadyForRendering(true);
  SetFrameBlitModeToNoBlit();
  SetOffScreenRendering(1);
}

OsmesaWindow::~OsmesaWindow() {
  if (!context_) return;
  Finalize();
  OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
  OSMesaDestroyContext(context_);
}

void OsmesaWindow::MakeCurrent() {
  if (!context_ || IsCurrent()) return;
  OSMesaMakeCurrent(context_, buffer_, GL_UNSIGNED_BYTE, side, side);
}

bool OsmesaWindow::IsCurrent() {
  return context_ && OSMesaGetCurrentContext() == context_;
}

void OsmesaWindow::OpenGLInitContext() {
  if (Initialized || !context_) return;
  MakeCurrent();
  GlewInitValid = load_opengl_functions();
  Initialized = true;
}

void OsmesaWindow::Finalize() {
  MakeCurrent();
  ReleaseGraphicsResources(this);
}

}  // namespace gnathion
