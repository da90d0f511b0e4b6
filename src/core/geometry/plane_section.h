#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A piece of a section: where a plane crosses a triangle, mm, LPS.
using SectionLine = std::array<Eigen::Vector3d, 2>;

/// Cuts one surface by planes, many times: runs of triangles that lie on one side of the plane are
/// passed over by their boxes.
class PlaneSection {
 public:
  /// surface: shared, not copied.
  explicit PlaneSection(std::shared_ptr<const TriangleMesh> surface);

  /// As it was given: at rest.
  const TriangleMesh& surface() const { return *surface_; }

  /// Other places for the surface's vertices (n×3, mm, LPS), as of a face that has moved.
  void set_points(Points points);

  /// Where the plane normal · x = offset crosses the surface, a line a triangle. A vertex in the
  /// plane counts as above it, so that the lines of a closed surface close.
  std::vector<SectionLine> cut(const Eigen::Vector3d& normal, double offset) const;

 private:
  struct Box {
    Eigen::Vector3d centre, half;
  };
  const Points& points() const { return moved_.rows() > 0 ? moved_ : surface_->vertices; }
  void sort_triangles();
  void make_boxes();
  void cut_triangle(Eigen::Index triangle, const Eigen::Vector3d& normal, double offset,
                    std::vector<SectionLine>& lines) const;

  std::shared_ptr<const TriangleMesh> surface_;
  Points moved_;            ///< empty: the surface's own
  std::vector<int> order_;  ///< the triangles, such that neighbours are near
  std::vector<Box> boxes_;  ///< of runs of them
};

}  // namespace gnathion
