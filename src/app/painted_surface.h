#pragma once

#include <array>
#include <vector>

#include "geometry/surface_point.h"
#include "tissue/region_brush.h"

namespace gnathion {

/// A surface that a brush paints on: what is painted is its own affair.
class PaintedSurface {
 public:
  virtual ~PaintedSurface() = default;

  /// In any place and unit; null: there is nothing to paint on yet.
  virtual const TriangleMesh* surface() const = 0;
  /// The edge of a brush of `radius` mm, as SurfaceBrush::circle(). \pre surface()
  virtual std::vector<std::array<EdgePoint, 2>> circle(const SurfacePoint& centre,
                                                       double radius) const = 0;

  virtual bool is_stroke() const = 0;
  /// \pre surface(), and no stroke
  virtual void begin_stroke(bool erases) = 0;
  /// Paints or erases a disc of `radius` mm; nothing outside a stroke.
  virtual void stamp(const SurfacePoint& at, double radius) = 0;
  virtual void end_stroke() = 0;
  /// What was painted since begin_stroke() is gone.
  virtual void drop_stroke() = 0;
};

}  // namespace gnathion
