#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Which of the asked vertices of a closed or open surface lie in a pocket: the inside of the mouth
/// or of a nostril, which scans of a whole head have. A vertex is hidden when at most one in ten of
/// the directions around its normal leads out, that is, meets no other part of the surface within
/// 60 mm. `asked`: one flag a vertex; the others are not hidden.
std::vector<bool> hidden_vertices(const TriangleMesh& surface, const std::vector<bool>& asked);

}  // namespace gnathion
