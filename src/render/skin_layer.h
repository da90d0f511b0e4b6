#pragma once

#include <memory>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// The CT's skin beside a photograph: solid, or a veil that what lies below is seen through. One
/// thread, the window's own.
class SkinLayer {
 public:
  SkinLayer();
  ~SkinLayer();
  SkinLayer(const SkinLayer&) = delete;
  SkinLayer& operator=(const SkinLayer&) = delete;

  /// The renderer must outlive this, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();

  /// mm, LPS, outward. Throws Error(input) as check_surface().
  void set_skin(const TriangleMesh& skin);
  /// 0 (not drawn) to 1. Below 1 only the side turned to the viewer is drawn.
  void set_opacity(double opacity);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
