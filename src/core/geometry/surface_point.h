#pragma once

#include <optional>

#include "geometry/bsp_tree.h"

namespace gnathion {

/// A point that belongs to a surface, wherever its vertices are moved to.
struct SurfacePoint {
  int triangle = -1;
  Eigen::Vector3d weight = Eigen::Vector3d::Zero();  ///< of the triangle's three vertices, sum 1

  /// Where it is, mm, LPS. vertices: n×3, of the surface in any shape.
  Eigen::Vector3d position(const Triangles& triangles, const Points& vertices) const;
  /// Of one number a vertex.
  double value(const Triangles& triangles, const Eigen::VectorXd& values) const;
};

/// The first point of the surface on a line of sight: `direction` of unit length. tree: of the
/// surface as it is shown. Nothing where the line misses it.
std::optional<SurfacePoint> point_in_sight(const BspTree& tree, const Eigen::Vector3d& eye,
                                           const Eigen::Vector3d& direction);

/// The point of `surface` nearest to `place`, mm, LPS; nothing within `reach` mm. tree: of the same
/// surface.
std::optional<SurfacePoint> nearest_surface_point(const BspTree& tree, const TriangleMesh& surface,
                                                  const Eigen::Vector3d& place, double reach);

}  // namespace gnathion
