#pragma once

#include <string>

#include "geometry/mesh_types.h"

namespace gnathion::bench {

/// The boundary of a tetrahedral mesh: the faces that belong to one tet, outward, with the vertices
/// they use in the mesh's order.
TriangleMesh boundary_surface(const TetMesh& mesh);

/// What `tetgen` made of a closed surface.
struct TetgenResult {
  TetMesh mesh;
  double seconds = 0;   ///< of the whole program: it reads and writes text files
  std::string failure;  ///< empty when there is a mesh; otherwise in words
};

/// Runs TetGen (Si 2015) with these switches, e.g. "pq". It is stopped after `limit_seconds`.
TetgenResult run_tetgen(const TriangleMesh& closed_surface, const std::string& switches,
                        int limit_seconds);

}  // namespace gnathion::bench
