#pragma once

#include <span>
#include <vector>

#include "registration/landmark_fit.h"
#include "registration/skin_target.h"

namespace gnathion {

/// Names of landmarks that say where the upper face is.
inline constexpr const char* nasion_name = "nasion";
inline constexpr const char* nose_tip_name = "nose_tip";

/// Flags of the photograph's vertices on forehead, brows and bridge of the nose: above the wings of
/// the nose, at most 75 mm to either side and 80 mm behind, where a face is the same with another
/// expression. The nose is where the landmarks' places on the CT say (nasion_name, else
/// nose_tip_name), else where the skin stands out most to the front. points: n×3 in the
/// photograph's own frame, put into place by the transform, right to some 15 mm. Empty when nothing
/// tells where the nose is.
std::vector<bool> upper_face(const Points& points, const Similarity& lps_from_photograph,
                             const SkinTarget& skin, std::span<const LandmarkPair> landmarks);

}  // namespace gnathion
