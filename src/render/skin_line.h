#pragma once

#include <memory>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// A line traced on the skin, with a knob at each point that was clicked: light on dark, so that it
/// stands out from any skin. Hidden by what lies before it. One thread, the window's own.
class SkinLine {
 public:
  SkinLine();
  ~SkinLine();
  SkinLine(const SkinLine&) = delete;
  SkinLine& operator=(const SkinLine&) = delete;

  /// The renderer must outlive the line, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();

  /// Places on the skin, n×3, mm, LPS, and the skin's outward normals there, unit.
  struct Places {
    Points on{0, 3}, outward{0, 3};
  };
  /// line: its places in order; knobs: any. Empty: not drawn.
  void set_line(const Places& line, const Places& knobs);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
