#pragma once

#include <memory>

#include "render/picture.h"

class vtkRenderer;

namespace gnathion {

/// Draws with the display's own OpenGL without being seen, beside the 3D view: for films and
/// pictures of another size. On the window's thread.
class HiddenCanvas {
 public:
  /// width, height: pixels. Throws Error(output) when the display gives no second context.
  HiddenCanvas(int width, int height);
  /// Takes its renderers out again.
  ~HiddenCanvas();
  HiddenCanvas(const HiddenCanvas&) = delete;
  HiddenCanvas& operator=(const HiddenCanvas&) = delete;

  /// The renderer must outlive the canvas and be in no other window.
  void add(vtkRenderer* renderer);
  /// All renderers, drawn now.
  Picture picture();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
