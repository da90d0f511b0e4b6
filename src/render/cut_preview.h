#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// Bone in the view, coloured by what a cut would do with it, in place of the bone itself. One
/// thread, the window's own.
class CutPreviewLayer {
 public:
  CutPreviewLayer();
  ~CutPreviewLayer();
  CutPreviewLayer(const CutPreviewLayer&) = delete;
  CutPreviewLayer& operator=(const CutPreviewLayer&) = delete;

  /// Shows it in `renderer`, which must outlive this, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();
  bool is_attached() const;

  /// The bone, mm, LPS, and fewer triangles over its vertices for frames while something moves
  /// (coarse_triangles() in render/coarse_surface.h); none: always drawn whole. Throws Error(input)
  /// as check_surface().
  void set_bone(const TriangleMesh& bone, const Triangles& coarse);
  /// part: m, of the triangles, rows of `colours` (RGB, 0..1); a vertex takes the largest of its
  /// triangles'. \pre as many as set_bone() got.
  void set_parts(const std::vector<std::uint8_t>& part, const Points& colours);
  /// true: coarse triangles, while the cut or the camera moves.
  void set_quick(bool quick);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
