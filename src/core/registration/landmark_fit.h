#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "geometry/rigid_motion.h"

namespace gnathion {

/// The same place of the face, picked in the photograph and on the CT's skin.
struct LandmarkPair {
  std::string name;
  Eigen::Vector3d photograph;  ///< in the photograph's own frame and unit
  Eigen::Vector3d lps;         ///< mm

  bool operator==(const LandmarkPair&) const = default;
};

/// The best transform between named pairs of points.
struct LandmarkFit {
  Similarity lps_from_photograph;
  std::map<std::string, double> residual_mm;  ///< distance left at each landmark
  double rms_mm = 0;                          ///< over the landmarks
};

/// mm from where the transform puts each landmark to its place on the CT.
std::map<std::string, double> landmark_residuals(std::span<const LandmarkPair> pairs,
                                                 const Similarity& lps_from_photograph);

/// The similarity, scale included, with the least sum of squared residuals (Umeyama 1991), never a
/// reflection. Throws Error(input) naming the landmark: fewer than three pairs, a name given twice,
/// a coordinate that is no finite number, two landmarks at one place, or all of them on a line (in
/// the photograph or on the CT), when the turn about that line would be left to chance; also when
/// the pairs fit their mirror image better than themselves, as when left and right are exchanged.
LandmarkFit fit_landmarks(std::span<const LandmarkPair> pairs);

/// The same with a known scale: `mm_per_unit` of the photograph's frame, above 0. Throws
/// Error(input) as above, and when the scale is not above 0.
LandmarkFit fit_landmarks(std::span<const LandmarkPair> pairs, double mm_per_unit);

}  // namespace gnathion
