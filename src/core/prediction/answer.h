#pragma once

#include <string>

#include "fem/neo_hookean_solver.h"
#include "geometry/surface_distance.h"
#include "prediction/face_model.h"

namespace gnathion {

/// What is known of the error of a predicted face, by vertex of FaceModel::moving_vertices(), mm.
/// Errors of the anatomy, the material and the plan are not in it.
struct FaceError {
  Eigen::VectorXd discretisation;  ///< of the elements: by what quadratic ones would add
  Eigen::VectorXd linearisation;   ///< of small strain: by one correction towards large strain
  DistanceStatistics total;        ///< of their sum

  bool within(double tolerance_mm) const { return total.p95 <= tolerance_mm; }
};

/// A prediction for one motion, the model that gave it, and why that one.
struct Answer {
  Points displacements;  ///< of the tissue's vertices, n×3, mm
  ElementOrder order = ElementOrder::linear;
  bool large_strain = false;
  FaceError error;                  ///< estimated, of this answer
  FaceError quick_error;            ///< estimated, of the linear model's answer that a drag shows
  std::string why;                  ///< a sentence for the user: what was chosen, for which reason
  double neo_hookean_residual = 0;  ///< relative; 0 for small strain
  int load_steps = 0;               ///< of the neo-Hookean solver; 0 for small strain
};

/// Part of what quadratic elements add to linear ones that is left as their own error; see
/// docs/evidence.md for what was measured.
inline constexpr double kQuadraticRest = 0.25;

/// The answer to these motions: the quick one of `model` where its estimated error keeps the
/// tolerance, else quadratic elements, large strain, or both, as `wanted` lets: the cheapest that
/// is estimated to keep it. Where both are needed, what quadratic elements add to the linear model
/// is added to the neo-Hookean solution on linear ones.
/// Throws as FaceModel::solve and NeoHookeanSolver::solve, Error(cancelled).
Answer choose_answer(const FaceModel& model, const TissueModel& wanted,
                     std::span<const RigidMotion> motions, Progress& progress);

}  // namespace gnathion
