#pragma once

#include "geometry/bsp_tree.h"

namespace gnathion {

/// Outward unit normals of a surface at its points nearest to the given ones, averaged over
/// `radius` mm: bone surfaces from a CT are stair-stepped, and mucosa slides over the bone, not
/// over its voxels. The mean is over the triangles that are connected with the nearest one within
/// the radius, their vector areas weighted by (1 − r²/radius²)²; so the far side of a thin plate
/// does not count. `tree`: of `surface`; points: n×3, mm, LPS. Returns n×3; the zero vector only
/// when the surface has no triangle or none with an area there.
Points smooth_normals(const TriangleMesh& surface, const BspTree& tree, const Points& points,
                      double radius = 3);

}  // namespace gnathion
