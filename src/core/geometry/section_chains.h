#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Where a plane through `origin` (mm, LPS) cuts a surface, as outlines to be drawn: chains of
/// points, n×3, mm, LPS, longest first. A closed chain ends with its first point. A vertex on the
/// plane counts as above it, so that every triangle is cut twice or not at all. `normal` needs no
/// unit length. Many planes through one surface: PlaneSection, whose lines are not chained.
std::vector<Points> section_chains(const TriangleMesh& mesh, const Eigen::Vector3d& origin,
                                   const Eigen::Vector3d& normal);

}  // namespace gnathion
