#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/mesh_types.h"

class vtkRenderer;

namespace gnathion {

/// How the tissue below a point of the skin is held at its inner side.
enum class SupportMark { attached, sliding, fixed, free };
inline constexpr std::array support_marks{SupportMark::attached, SupportMark::sliding,
                                          SupportMark::fixed, SupportMark::free};

/// A mark at a vertex of the face.
struct SupportPoint {
  int vertex = -1;
  SupportMark mark = SupportMark::free;
};

/// RGB, 0..1: of Okabe and Ito's palette (2008), which the colour-blind tell apart; sizes differ,
/// too.
Eigen::Vector3d colour_of(SupportMark mark);
/// Of the point, in pixels.
int size_of(SupportMark mark);
inline const Eigen::Vector3d region_colour{0.08, 0.62, 0.28};
inline const Eigen::Vector3d sliding_area_colour{0.15, 0.35, 0.85};
inline const Eigen::Vector3d fault_colour{0.85, 0.10, 0.60};

/// The painted region on the face: translucent over the photograph, its rim a line, how the tissue
/// below is held, what makes it no region, and the brush. In a stroke only lists of indices change,
/// the positions stay on the graphics card. Vertices are the face's; mm, LPS. One thread, the
/// window's own.
class RegionOverlay {
 public:
  RegionOverlay();
  ~RegionOverlay();
  RegionOverlay(const RegionOverlay&) = delete;
  RegionOverlay& operator=(const RegionOverlay&) = delete;

  /// The renderer must outlive the overlay, or detach() must be called before.
  void attach(vtkRenderer* renderer);
  void detach();
  bool is_attached() const;

  /// Replaces the face; everything on it is gone.
  void set_face(const TriangleMesh& face);
  /// The face moved: n×3 as its own.
  void set_points(const Points& points);

  /// triangles: of the region; rim: its border edges.
  void set_region(const Triangles& triangles, const std::vector<std::array<int, 2>>& rim);
  /// Where the user has marked that the tissue slides.
  void set_sliding_area(const Triangles& triangles);
  /// Where marks are nearer than 4 mm to each other one stands for them.
  void set_supports(const std::vector<SupportPoint>& supports);
  /// Vertices that make it no region.
  void set_faults(const std::vector<int>& vertices);
  /// The brush's edge: 2k×3, the ends of k segments, mm, LPS, on the skin. None: no cursor.
  void set_cursor(const Points& segment_ends, bool erases);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
