#include "render/pixel_ratio.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace gnathion {

double pixel_ratio(vtkRenderer* renderer) {
  constexpr double logical_dpi = 72;  // VTK's, at which a font's size is its height in pixels
  vtkRenderWindow* window = renderer->GetRenderWindow();
  return window == nullptr ? 1 : window->GetDPI() / logical_dpi;
}

}  // namespace gnathion
