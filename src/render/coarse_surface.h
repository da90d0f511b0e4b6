#pragma once

#include "geometry/mesh_types.h"

namespace gnathion {

/// About `wanted` triangles over the surface's own vertices, for frames while something moves: the
/// surface to look at, not to compute with (parts may be missing). The surface's own triangles when
/// they are no more than that. Takes seconds on half a million triangles; pure, for any thread.
Triangles coarse_triangles(const TriangleMesh& surface, int wanted = 60000);

}  // namespace gnathion
