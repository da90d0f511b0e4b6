#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// How sure a proposal is, for words beside it; it is asked for all the same.
enum class Confidence { low, fair, high };

/// A unit that a scan may be in.
struct ProposedUnit {
  std::string name;  ///< "m", "cm", "mm", "inch"; empty: no usual one
  double mm_per_unit = 1;
  Confidence confidence = Confidence::low;
  std::string reason;  ///< a sentence for the user
};

/// The units that would make the scan as large as a face or a head with shoulders, 110 to 1300 mm
/// along its longest side, the likeliest first, each with its reason; inches last and never above
/// low confidence; where none does, one of low confidence without a name that makes the longest
/// side 260 mm. Proposals to be confirmed: a face in centimetres and a body in millimetres can have
/// the same numbers. vertices: n×3 in the scan's unit, finite. Strays are not counted
/// (robust_size()).
std::vector<ProposedUnit> proposed_units(const Points& vertices);

/// The longest side of the vertices' axis-parallel box, in their own unit, without strays: a
/// hundredth of them at either end of each axis.
double robust_size(const Points& vertices);

}  // namespace gnathion
