#include "prediction/face_model.h"

#include <mutex>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

/// Of force transfer: one translation for all.
Eigen::Vector3d common_translation(std::span<const RigidMotion> motions) {
  for (const RigidMotion& motion : motions) {
    const bool turns = !motion.rotation.isIdentity(1e-12);
    if (!turns && motion.translation == motions[0].translation) continue;
    throw Error(ErrorKind::case_file, "tissue.load",
                "force transfer has one force for all points of the bone and cannot turn it, nor "
                "move two segments apart",
                "set the rotations to 0, or use \"displacement\"");
  }
  return motions[0].translation;
}

}  // namespace

struct FaceModel::QuadraticParts {
  std::mutex mutex;
  std::unique_ptr<const QuadraticCorrection> correction;
  std::unique_ptr<const StaticSolver> solver;
};

FaceModel::FaceModel(const Anatomy& anatomy, const RegionChoice& region, const TissueModel& model,
                     Progress& progress)
    : load_(model.load),
      problem_(
          std::make_shared<const TissueProblem>(build_tissue(anatomy, region, model, progress))),
      quadratic_(std::make_shared<QuadraticParts>()),
      rest_face_(std::make_shared<const Points>(anatomy.face.mesh.surface.vertices)) {
  solver_ = std::make_shared<const StaticSolver>(problem_->tissue.mesh, problem_->materials,
                                                 problem_->supports, progress);
  const bool wants_quadratic = model.elements == Elements::quadratic;
  if (load_ == LoadModel::displacement) {
    {
      const auto stage = progress.stage("response basis");
      set_basis(response_basis(*solver_, anatomy.pivots()));
    }
    if (wants_quadratic) *this = on_quadratic_elements(progress);
    return;
  }
  if (wants_quadratic) {
    throw Error(ErrorKind::case_file, "tissue.elements",
                "force transfer, the paper's load, has linear elements only",
                "give \"linear\", or \"displacement\" as tissue.load");
  }
  const auto stage = progress.stage("response basis");
  const Points normals = vertex_normals(problem_->region.mesh)(problem_->forced, Eigen::all);
  force_basis_ = force_basis(*solver_, problem_->forced, normals);
  compose(problem_->surface_map, force_basis_.columns(), moving_vertices_);
}

void FaceModel::set_basis(ResponseBasis basis) {
  basis_ = std::move(basis);
  face_basis_ = {compose(problem_->surface_map, basis_.columns(), moving_vertices_),
                 basis_.centres()};
}

const QuadraticCorrection& FaceModel::correction(Progress& progress) const {
  const std::lock_guard lock(quadratic_->mutex);
  if (!quadratic_->correction) {
    quadratic_->correction = std::make_unique<const QuadraticCorrection>(*solver_, progress);
  }
  return *quadratic_->correction;
}

const StaticSolver& FaceModel::quadratic_solver(Progress& progress) const {
  const std::lock_guard lock(quadratic_->mutex);
  if (!quadratic_->solver) {
    const ElementMesh elements(problem_->tissue.mesh, ElementOrder::quadratic);
    quadratic_->solver = std::make_unique<const StaticSolver>(
        elements, problem_->materials, supports_of_nodes(elements, problem_->supports), progress);
  }
  return *quadratic_->solver;
}

FaceModel FaceModel::on_quadratic_elements(Progress& progress) const {
  if (order_ == ElementOrder::quadratic || load_ == LoadModel::force) return *this;
  const StaticSolver& solver = quadratic_solver(progress);
  const auto stage = progress.stage("response basis on quadratic elements");
  const ResponseBasis all = response_basis(solver, basis_.centres());
  FaceModel model = *this;
  model.order_ = ElementOrder::quadratic;
  model.set_basis({all.columns().topRows(basis_.columns().rows()), basis_.centres()});
  return model;
}

void FaceModel::predict(std::span<const RigidMotion> motions, Points& face_points) const {
  if (load_ == LoadModel::force) {
    face_points = face_with(tissue_displacements(motions));
    return;
  }
  face_points = *rest_face_;
  Points u;
  face_basis_.displacements(motions, u);
  for (std::size_t i = 0; i < moving_vertices_.size(); ++i) {
    face_points.row(moving_vertices_[i]) += u.row(static_cast<Eigen::Index>(i));
  }
}

Points FaceModel::tissue_displacements(std::span<const RigidMotion> motions) const {
  if (load_ == LoadModel::force) {
    return force_basis_.displacements(common_translation(motions)).displacements;
  }
  Points u;
  basis_.displacements(motions, u);
  return u;
}

Points FaceModel::face_with(const Points& tissue_displacements) const {
  return *rest_face_ +
         problem_->surface_map * tissue_displacements.topRows(problem_->tissue.surface_count);
}

StaticSolution FaceModel::solve(std::span<const RigidMotion> motions) const {
  const Points& x = problem_->tissue.mesh.vertices;
  Points forces = Points::Zero(x.rows(), 3);
  if (load_ == LoadModel::displacement) {
    return solver_->solve(bone_displacements(x, problem_->supports, motions), forces);
  }
  const Eigen::Vector3d translation = common_translation(motions);
  if (!translation.isZero(0)) {
    const Eigen::Vector3d direction = translation.normalized();
    const double force = force_basis_.displacements(translation).force_N;
    const Points normals = vertex_normals(problem_->region.mesh);
    for (const int v : problem_->forced) {
      forces.row(v) = force * normals.row(v).dot(direction) * direction.transpose();
    }
  }
  return solver_->solve(Points::Zero(x.rows(), 3), forces);
}

Points FaceModel::solve_quadratic(std::span<const RigidMotion> motions, Progress& progress) const {
  const StaticSolver& solver = quadratic_solver(progress);
  const Points& x = solver.elements().nodes;
  const Points prescribed = bone_displacements(x, solver.supports(), motions);
  return solver.solve(prescribed, Points::Zero(x.rows(), 3))
      .displacements.topRows(solver_->elements().nodes.rows());
}

Points FaceModel::estimated_correction(const Points& displacements, Progress& progress) const {
  const Eigen::VectorXd u = displacements.reshaped<Eigen::RowMajor>();
  const Eigen::VectorXd more = correction(progress).correct(u, progress);
  return Eigen::Map<const Points>(more.data(), displacements.rows(), 3);
}

}  // namespace gnathion
