#pragma once

#include <vector>

#include "base/progress.h"
#include "geometry/rigid_motion.h"
#include "registration/skin_target.h"

namespace gnathion {

/// A place where the photograph may belong.
struct PossibleStart {
  Similarity lps_from_photograph;
  double matched_mm2 =
      0;  ///< area of the photograph that lies on the skin there, the nearer the more
};

/// How hard is looked for them.
struct StartEffort {
  std::size_t prominences = 40;  ///< of the photograph that are tried
  std::size_t improved = 150;    ///< places that are fitted quickly
};

/// Places for a photograph of known unit and unknown turn and place, found from shape alone, best
/// first, no two within 15° and 15 mm of each other, at most `most`.
///
/// Points that stand out by much over 22 mm (nose tip, chin, but hair and shoulders too) are taken
/// in turn for those of the skin that face forward, with 24 turns about the way they face and nine
/// tilts of it; each such place is scored by how much of the photograph lies on the skin and faces
/// as it does; the best are improved by a quick fit and scored again.
/// photograph: own frame; mm_per_unit above 0. Empty when there is nothing to match.
std::vector<PossibleStart> automatic_starts(const SampledSurface& photograph, double mm_per_unit,
                                            const SkinTarget& skin, const StartEffort& effort,
                                            std::size_t most, const Progress& progress);

}  // namespace gnathion
