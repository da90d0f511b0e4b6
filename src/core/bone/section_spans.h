#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A rectangle in space, mm, LPS.
struct Rectangle {
  Eigen::Vector3d centre;
  Eigen::Vector3d u, v, normal;  ///< unit, at right angles
  double half_u = 0, half_v = 0;
};

/// A stretch of a row that lies inside a solid.
struct Span {
  int row = 0;
  double begin = 0, end = 0;  ///< along u, from the rectangle's centre, mm
  int first = -1, last = -1;  ///< the triangles where it begins and ends; −1: at the border
};

/// Where a rectangle passes through a solid: rows along u, `row_height` apart.
struct RectangleSection {
  int rows = 0;
  double row_height = 0;       ///< mm
  std::vector<Span> spans;     ///< by row, then along u
  std::vector<int> triangles;  ///< those that meet the rectangle

  /// The middle of a row along v, from the rectangle's centre, mm.
  double row_v(int row) const { return (row + 0.5 - 0.5 * rows) * row_height; }
};

/// The section of a closed surface. crossing: the triangles that have vertices on both sides of
/// the rectangle's plane; codes: n, of the vertices, with `bit` set on the plane's positive side
/// (and at distance 0). step: mm, the rows' distance at most.
RectangleSection section_of(const TriangleMesh& mesh, const Rectangle& rectangle,
                            const std::vector<int>& crossing,
                            const std::vector<std::uint8_t>& codes, std::uint8_t bit, double step);

}  // namespace gnathion
