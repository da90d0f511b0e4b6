#pragma once

#include "base/progress.h"
#include "geometry/rigid_motion.h"
#include "registration/skin_target.h"

namespace gnathion {

struct SurfaceFitOptions {
  double reach_mm = 15;       ///< pairs farther apart than this do not count, at first
  double least_reach_mm = 4;  ///< nor farther than this, or four standard deviations, in the end
  double trimmed = 0.2;       ///< of the pairs, the worst, left out
  bool fit_scale = false;     ///< within a factor of 1.25 of the start; else the start's
  /// Whether the skin may lie a constant distance below the photograph, as the level at which a
  /// CT's skin is taken makes it. It cannot be told from a scale: not both.
  bool fit_offset = true;
  int most_iterations = 80;
  /// Converged: an iteration moves the points (RMS) less than this, or a hundredth of the spread.
  double settled_mm = 0.003;
};

struct SurfaceFit {
  Similarity lps_from_photograph;
  double offset_mm = 0;  ///< of the photograph above the skin of the CT
  int iterations = 0;
  bool converged = false;
  /// Standard deviation of the distances, mm, by the median: strays do not count.
  double spread_mm = 0;
  Eigen::Index pairs = 0;  ///< points that decided
  /// How well the shape holds the least certain motion, 0 (slides freely: a plane, a sphere) to
  /// about 0.3: the smallest eigenvalue of the mean of J Jᵀ, J the change of a point's distance
  /// with translation and with turns (and scale) in units of the points' RMS radius.
  double grip = 0;
};

/// Moves a sample of the photograph (own frame and unit) onto the skin from `start`, which should
/// be right to about 20° and 15 mm: iterated nearest points, point-to-plane (Chen and Medioni
/// 1992), trimmed (Chetverikov 2002), Tukey's biweight with a spread that only falls, pairs only
/// where the surfaces face the same way to 45°. What it could not do is in the result: fewer than
/// 20 pairs leave it not converged. Throws Error(cancelled).
SurfaceFit fit_surface(const SurfaceSample& photograph, const Similarity& start,
                       const SkinTarget& skin, const SurfaceFitOptions& options,
                       const Progress& progress);

/// How far a sample of the photograph lies from the skin.
struct SurfaceAgreement {
  Eigen::VectorXd distance;  ///< signed, mm, of the points within reach that face as the skin does
  std::vector<Eigen::Index> row;  ///< of the sample, for each distance
};

SurfaceAgreement agreement(const SurfaceSample& photograph, const Similarity& lps_from_photograph,
                           const SkinTarget& skin, double reach_mm);

}  // namespace gnathion
