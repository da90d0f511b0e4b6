#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A unit that a photograph may be in.
struct LengthUnit {
  std::string name;  ///< "mm", "cm", "m"
  double mm_per_unit = 1;
  double size_mm = 0;  ///< the photograph's longest side in this unit
};

/// The usual units that would make the photograph as large as a face or a head with shoulders, 110
/// to 1300 mm along its longest side; the likeliest first (nearest to 300 mm). Empty when it is in
/// none of them. A proposal to be confirmed: a face in centimetres and a body in millimetres can
/// have the same numbers. vertices: n×3, in the photograph's unit; a hundredth of them at either
/// end of each axis are not counted, for they may be strays.
std::vector<LengthUnit> proposed_units(const Points& vertices);

/// The longest side of the vertices' axis-parallel box without those strays, in their own unit.
double robust_size(const Points& vertices);

}  // namespace gnathion
