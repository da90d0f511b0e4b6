#pragma once

#include <memory>
#include <string>

#include "fem/neo_hookean_solver.h"
#include "geometry/surface_distance.h"
#include "prediction/face_model.h"

namespace gnathion {

/// What is known of the error of a predicted face, by vertex of FaceModel::moving_vertices(), mm.
/// Errors of the anatomy, the material and the plan are not in it.
struct FaceError {
  Eigen::VectorXd discretisation;  ///< of the elements: by what quadratic ones would add
  Eigen::VectorXd linearisation;   ///< of small strain: by the part of the second order
  DistanceStatistics total;        ///< of their sum

  bool within(double tolerance_mm) const { return total.p95 <= tolerance_mm; }
};

/// A prediction for one motion, the model that gave it, and why that one.
struct Answer {
  std::shared_ptr<const TissueProblem> tissue;  ///< what was computed on: a finer mesh at times
  Points displacements;                         ///< of its vertices, n×3, mm
  Points face_points;                           ///< mm, LPS, all vertices of the face
  ElementOrder order = ElementOrder::linear;
  bool large_strain = false;
  FaceError error;        ///< estimated, of this answer
  FaceError quick_error;  ///< estimated, of the answer that a drag shows
  std::string why;        ///< a sentence for the user: what was chosen, for which reason
  /// What large strain took; its displacements are left out. 0 everywhere for small strain.
  NeoHookeanSolution neo_hookean;
};

/// What is left of the two estimates when a better model gives the answer: measured against finer
/// elements and the neo-Hookean solution on them, see docs/evidence.md.
inline constexpr double kQuadraticRest = 0.25;  ///< quadratic elements, of what they add
/// Small strain errs more on quadratic elements, which resolve how the tissue bends at the edge of
/// the bone, than the estimate on linear ones says.
inline constexpr double kSmallStrainOnQuadratic = 3;
/// Above this many tets quadratic elements are not offered by themselves: their factor would take
/// gigabytes and minutes.
inline constexpr Eigen::Index kMostQuadraticTets = 100000;

/// The answer to these motions: that of `quick` where its estimated error keeps the tolerance of
/// `wanted`, else quadratic elements, large strain, or both, as `wanted` lets: the cheapest that is
/// estimated to keep it. Where none does on this mesh and the mesh is the program's choice, the
/// same on finer ones; where none does at all, the one with the least estimated error. Where large
/// strain is the program's choice and the tissue cannot follow the motion, small strain answers and
/// `why` says so. Throws as FaceModel::solve and NeoHookeanSolver::solve, Error(cancelled).
Answer choose_answer(const Anatomy& anatomy, const RegionChoice& region, const TissueModel& wanted,
                     const FaceModel& quick, std::span<const RigidMotion> motions,
                     Progress& progress);

}  // namespace gnathion
