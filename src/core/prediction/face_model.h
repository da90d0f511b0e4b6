#pragma once

#include <memory>

#include "fem/response_basis.h"
#include "prediction/anatomy.h"
#include "tissue/bone_map.h"
#include "tissue/st_generator.h"
#include "tissue/surface_map.h"
#include "tissue/unfold.h"

namespace gnathion {

/// The soft tissue between the segment and the face, meshed and held: what the equations are about.
struct TissueProblem {
  IntermediateMesh region;
  std::vector<BoneLink> links;         ///< the bone map
  std::vector<Underlying> bone_below;  ///< M, of the region's vertices
  SoftTissueMesh tissue;
  Supports supports;          ///< of the tissue's nodes
  std::vector<int> forced;    ///< surface nodes that the bone map links to the segment
  int attached_count = 0;     ///< inner nodes that follow the segment
  int on_skull_count = 0;     ///< inner nodes held by other bone
  int released_count = 0;     ///< inner nodes on bone next to the cut, which does not hold them
  int unfolded_count = 0;     ///< vertices that were smoothed at folds before meshing
  double unfolded_mm = 0;     ///< by at most this
  double rim_to_segment = 0;  ///< mm, smallest distance from the rim to the moving bone
};

/// Chooses the region and meshes, maps and holds its tissue.
/// Throws Error(anatomy): as the region's choice and the generator; when no bone of the segment
/// lies under the region, so that nothing is driven; when the paper's generator inverts elements.
TissueProblem build_tissue(const Anatomy& anatomy, const RegionChoice& region,
                           const TissueModel& model, Progress& progress);

/// The face as a function of the segment's pose: made once for a region, asked for every frame of a
/// drag. Immutable; may be asked from several threads.
class FaceModel {
 public:
  /// Assembles, factorises and solves for the response basis. Throws as build_tissue and
  /// StaticSolver.
  FaceModel(const Anatomy& anatomy, const RegionChoice& region, const TissueModel& model,
            Progress& progress);

  /// The predicted face: n×3, mm, LPS, all vertices of the face. Exact for the linear model.
  /// Throws Error(case_file) when force transfer is asked for a rotation, which it has no model of.
  void predict(const RigidMotion& motion, Points& face_points) const;

  /// Displacements of all nodes of the tissue by a direct solve of the equations, with their
  /// residual: what predict() is checked against. Throws as predict() and StaticSolver::solve.
  StaticSolution solve(const RigidMotion& motion) const;

  /// The same from the basis.
  Points tissue_displacements(const RigidMotion& motion) const;

  const TissueProblem& problem() const { return problem_; }
  const StaticSolver& solver() const { return *solver_; }
  const std::vector<int>& moving_vertices() const { return moving_vertices_; }

 private:
  LoadModel load_;
  TissueProblem problem_;
  std::unique_ptr<StaticSolver> solver_;
  ResponseBasis basis_;               ///< of all nodes (displacement transfer)
  ForceBasis force_basis_;            ///< of all nodes (force transfer)
  SurfaceMap surface_map_;            ///< W
  ResponseBasis face_basis_;          ///< W composed with the basis, for moving_vertices_
  std::vector<int> moving_vertices_;  ///< of the face: the non-empty rows of W
  Points rest_face_;
};

}  // namespace gnathion
