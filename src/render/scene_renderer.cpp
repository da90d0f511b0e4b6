#include "render/scene_renderer.h"

#include <vtkObjectFactory.h>

namespace gnathion {

vtkStandardNewMacro(SceneRenderer);

void SceneRenderer::DeviceRenderTranslucentPolygonalGeometry(vtkFrameBufferObjectBase* frame) {
  if (quick_) {
    UpdateTranslucentPolygonalGeometry();
  } else {
    Superclass::DeviceRenderTranslucentPolygonalGeometry(frame);
  }
}

}  // namespace gnathion
