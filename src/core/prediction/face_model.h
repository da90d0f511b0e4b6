#pragma once

#include <memory>
#include <span>

#include "fem/quadratic_correction.h"
#include "fem/response_basis.h"
#include "prediction/tissue_problem.h"

namespace gnathion {

/// The face as a function of the segments' poses, linear in them: made once for a region, asked for
/// every frame of a drag. Its values never change, and it may be asked from several threads; what
/// quadratic elements need is made once, when first asked for, while other askers wait. Motions:
/// one a segment.
class FaceModel {
 public:
  /// Assembles, factorises and solves for the response basis on linear elements, and corrects it to
  /// quadratic ones where `model.elements` asks for them. Throws as build_tissue and StaticSolver.
  FaceModel(const Anatomy& anatomy, const RegionChoice& region, const TissueModel& model,
            Progress& progress);

  /// The same tissue on quadratic elements, factorised: a frame costs the same. Force transfer has
  /// linear elements only.
  FaceModel on_quadratic_elements(Progress& progress) const;

  /// The predicted face: n×3, mm, LPS, all vertices of the face. Exact for the linear model.
  /// Throws Error(case_file) when force transfer is asked for a rotation, which it has no model of.
  void predict(std::span<const RigidMotion> motions, Points& face_points) const;

  /// Displacements of the tissue's vertices from the basis, n×3, mm.
  Points tissue_displacements(std::span<const RigidMotion> motions) const;

  /// On linear elements, by a direct solve of the equations, with their residual.
  /// Throws as predict() and StaticSolver::solve.
  StaticSolution solve(std::span<const RigidMotion> motions) const;

  /// The same for the tissue's vertices on quadratic elements. \pre displacement transfer
  Points solve_quadratic(std::span<const RigidMotion> motions, Progress& progress) const;

  /// What quadratic elements would add to a solution on linear ones, estimated, n×3, mm.
  Points estimated_correction(const Points& displacements, Progress& progress) const;

  /// The face when the tissue's vertices are displaced so: W u on the face at rest. n×3, mm, LPS.
  Points face_with(const Points& tissue_displacements) const;

  LoadModel load() const { return load_; }
  ElementOrder order() const { return order_; }
  const TissueProblem& problem() const { return *problem_; }
  std::shared_ptr<const TissueProblem> problem_ptr() const { return problem_; }
  const StaticSolver& solver() const { return *solver_; }  ///< on linear elements
  /// On quadratic elements, factorised when first asked for.
  const StaticSolver& quadratic_solver(Progress& progress) const;
  /// Vertices of the face that move, ascending.
  const std::vector<int>& moving_vertices() const { return moving_vertices_; }

 private:
  void set_basis(ResponseBasis basis);
  const QuadraticCorrection& correction(Progress& progress) const;

  LoadModel load_;
  ElementOrder order_ = ElementOrder::linear;
  std::shared_ptr<const TissueProblem> problem_;
  std::shared_ptr<const StaticSolver> solver_;
  /// Made when first asked for; shared by copies.
  struct QuadraticParts;
  std::shared_ptr<QuadraticParts> quadratic_;
  ResponseBasis basis_;               ///< of all vertices of the tissue (displacement transfer)
  ForceBasis force_basis_;            ///< likewise (force transfer)
  ResponseBasis face_basis_;          ///< W composed with the basis, for moving_vertices_
  std::vector<int> moving_vertices_;  ///< of the face: the non-empty rows of W
  std::shared_ptr<const Points> rest_face_;
};

}  // namespace gnathion
