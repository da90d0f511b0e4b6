#pragma once

#include <memory>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// Where bone was before it was moved: a glassy shape with dark outlines, through which the bone as
/// it is now is seen. LPS, mm. One thread, the window's own.
class GhostBones {
 public:
  GhostBones();
  ~GhostBones();
  GhostBones(const GhostBones&) = delete;
  GhostBones& operator=(const GhostBones&) = delete;

  void attach(vtkRenderer* renderer);
  void detach();
  /// triangles: those of the bone, or fewer over its vertices, which draws sooner.
  void set_bone(const Points& vertices, const Triangles& triangles);
  void set_visible(bool visible);
  bool is_visible() const;
  /// true: before all else, also before bone that hides it; false: hidden by what is before it.
  void set_in_front(bool in_front);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
