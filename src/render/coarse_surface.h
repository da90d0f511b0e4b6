#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Triangles of a frame while something moves: a software renderer takes about a microsecond for
/// each, and a drag should show 15 frames a second.
inline constexpr int kQuickFace = 20000, kQuickSkull = 20000, kQuickSegment = 8000;

/// At most `wanted` triangles over the surface's own vertices, for frames while something moves:
/// the surface to look at, not to compute with (thin parts may grow together or be missing). Its
/// own triangles when they are no more than that. Vertices are drawn together by the cells of a
/// grid (Rossignac and Borrel 1993, "Multi-resolution 3D approximations for rendering complex
/// scenes"), those whose normals are opposite apart; the one nearest to their middle stands for
/// them. Two tenths of a second on half a million triangles. Pure, for any thread. The vertices
/// flagged in `kept` (one a vertex; empty: none) stay as they are, so that surfaces that meet along
/// them leave no crack; they may make the triangles more than wanted. \pre wanted > 0.
Triangles coarse_triangles(const TriangleMesh& surface, int wanted,
                           const std::vector<bool>& kept = {});

}  // namespace gnathion
