#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// For each of n points, the row of the first one at exactly the same place (its own where there is
/// none before it; −0 is 0). points: n×3, finite.
std::vector<int> first_at_same_place(const Points& points);

}  // namespace gnathion
