#include "prediction/face_model.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/tet_quality.h"

namespace gnathion {
namespace {

IntermediateMesh choose_region(const TriangleMesh& face, const RegionChoice& choice,
                               const BspTree& segment) {
  return choice.vertices.empty() ? suggest_region(face, segment, choice.reach_mm)
                                 : region_of_vertices(face, choice.vertices);
}

/// mm: an inner vertex this near to a bone rests on it.
constexpr double kOnBone = 1;

/// Rim fixed, inner vertices held or moved by the bone they rest on (displacement transfer), unless
/// it is next to the bone on the other side of the cut; with force transfer only the rim is held,
/// as in the paper.
void set_supports(const TissueModel& model, const BspTree& segment, const BspTree& skull,
                  TissueProblem& problem) {
  const SoftTissueMesh& tissue = problem.tissue;
  problem.supports.assign(static_cast<std::size_t>(tissue.mesh.vertices.rows()), Support::free);
  for (int v = 0; v < tissue.surface_count; ++v) {
    Support& inner = problem.supports[tissue.inner(v)];
    const Underlying bone = problem.bone_below[v];
    if (problem.region.held[v]) problem.supports[v] = inner = Support::fixed;
    if (problem.region.held[v] || model.load == LoadModel::force || bone == Underlying::none) {
      continue;
    }
    const Eigen::Vector3d x = tissue.mesh.vertices.row(tissue.inner(v));
    const BspTree& own = bone == Underlying::segment ? segment : skull;
    const BspTree& other = bone == Underlying::segment ? skull : segment;
    // Tissue that had to be made thinner, or that only a ray from the bone's edge meets, may not
    // reach the bone. The paper's generator does not try to.
    if (model.generator == Generator::robust && !own.nearest(x, kOnBone)) continue;
    if (other.nearest(x, model.released_mm)) {
      ++problem.released_count;
      continue;
    }
    inner = bone == Underlying::segment ? Support::attached : Support::fixed;
    ++(bone == Underlying::segment ? problem.attached_count : problem.on_skull_count);
  }
}

void require_driven(LoadModel load, const TissueProblem& problem) {
  const bool driven =
      load == LoadModel::displacement ? problem.attached_count > 0 : !problem.forced.empty();
  if (driven) return;
  throw Error(ErrorKind::anatomy, "region",
              "no bone of the segment lies under it, so nothing would move the face",
              "choose a region over the segment, or raise tissue.bone_reach_mm");
}

void require_clean(const SoftTissueMesh& tissue) {
  const TetQuality quality = tet_quality(tissue.mesh);
  if (quality.inverted == 0) return;
  throw Error(ErrorKind::anatomy, "tissue.generator",
              "the paper's generator inverts " + std::to_string(quality.inverted) + " of " +
                  std::to_string(quality.count) + " tetrahedra on this region",
              "use the generator \"robust\", or a smaller tissue.depth_mm");
}

/// Of force transfer.
void require_translation(const RigidMotion& motion) {
  if (motion.rotation.isIdentity(1e-12)) return;
  throw Error(ErrorKind::case_file, "tissue.load",
              "force transfer has one force for all points of the bone and cannot turn it",
              "set the rotations to 0, or use \"displacement\"");
}

/// Surface vertices that a link meets, without those on the rim, ascending.
std::vector<int> forced_points(const TissueProblem& problem) {
  std::vector<int> forced;
  for (const BoneLink& link : problem.links) {
    for (const int v : problem.region.mesh.triangles.row(link.triangle)) {
      if (!problem.region.held[v]) forced.push_back(v);
    }
  }
  std::sort(forced.begin(), forced.end());
  forced.erase(std::unique(forced.begin(), forced.end()), forced.end());
  return forced;
}

/// Meshes the tissue and finds the bone below it. A region with folds deeper than the default depth
/// needs directions smoothed over more than that: each further try doubles the smoothing.
void mesh_tissue(const BspTree& segment, const BspTree& skull, const TissueModel& model,
                 TissueProblem& problem, Progress& progress) {
  BoneBelowOptions options;
  options.threshold = model.bone_reach_mm;
  options.default_depth = model.depth_mm;
  constexpr int kTries = 3;
  double length = model.depth_mm;
  for (int attempt = 1;; ++attempt, length *= std::sqrt(2.0)) {
    Points directions;
    BoneBelow below;
    {
      const auto stage = progress.stage("bone below the face");
      directions = offset_directions(problem.region, length);
      below = bone_below(problem.region, directions, segment, skull, problem.links, options);
    }
    const auto stage = progress.stage("ST Generator");
    problem.bone_below = std::move(below.bone);
    if (model.generator == Generator::paper) {
      problem.tissue = st_generator_paper(problem.region, model.depth_mm);
      require_clean(problem.tissue);
      return;
    }
    try {
      problem.tissue = st_generator(problem.region, directions, below.depth);
    } catch (const Error&) {
      if (attempt == kTries) throw;
      continue;
    }
    return;
  }
}

/// mm: a fixed rim nearer to the moving bone than this holds the face back where it should move.
constexpr double kNearRim = 15;

double rim_distance(const IntermediateMesh& region, const BspTree& segment) {
  double least = 1e3;
  for (std::size_t v = 0; v < region.held.size(); ++v) {
    if (!region.held[v]) continue;
    const auto nearest =
        segment.nearest(region.mesh.vertices.row(static_cast<Eigen::Index>(v)), least);
    if (nearest) least = nearest->distance;
  }
  return least;
}

}  // namespace

TissueProblem build_tissue(const Anatomy& anatomy, const RegionChoice& choice,
                           const TissueModel& model, Progress& progress) {
  TissueProblem problem;
  const auto [segment, skull] = [&] {
    const auto stage = progress.stage("search trees");
    return std::pair(BspTree(anatomy.cut.segment), BspTree(anatomy.cut.remainder));
  }();
  {
    const auto stage = progress.stage("region");
    problem.region = choose_region(anatomy.face.mesh.surface, choice, segment);
    if (model.generator == Generator::robust) {
      Unfolding unfolding = unfold(problem.region);
      problem.region = std::move(unfolding.region);
      problem.unfolded_count = unfolding.moved_count;
      problem.unfolded_mm = unfolding.largest_move;
    }
    problem.rim_to_segment = rim_distance(problem.region, segment);
    if (problem.rim_to_segment < kNearRim) {
      progress.notice("the fixed rim of the region comes within " +
                      std::to_string(std::lround(problem.rim_to_segment)) +
                      " mm of the moving bone, so the face is held back there; a larger region or "
                      "a photograph that reaches farther would be better");
    }
  }
  {
    const auto stage = progress.stage("bone map");
    const BspTree skin(problem.region.mesh);
    problem.links =
        bone_map(anatomy.cut.segment, segment, problem.region, skin, model.bone_reach_mm);
    problem.forced = forced_points(problem);
  }
  mesh_tissue(segment, skull, model, problem, progress);
  set_supports(model, segment, skull, problem);
  require_driven(model.load, problem);
  return problem;
}

FaceModel::FaceModel(const Anatomy& anatomy, const RegionChoice& region, const TissueModel& model,
                     Progress& progress)
    : load_(model.load),
      problem_(build_tissue(anatomy, region, model, progress)),
      rest_face_(anatomy.face.mesh.surface.vertices) {
  const SoftTissueMesh& tissue = problem_.tissue;
  solver_ =
      std::make_unique<StaticSolver>(tissue.mesh, model.material, problem_.supports, progress);
  const auto stage = progress.stage("response basis");
  surface_map_ = index_map(problem_.region, rest_face_);
  if (load_ == LoadModel::displacement) {
    basis_ = response_basis(*solver_, {anatomy.pivot});
    face_basis_ = {compose(surface_map_, basis_.columns(), moving_vertices_), {anatomy.pivot}};
  } else {
    const Points normals = vertex_normals(problem_.region.mesh)(problem_.forced, Eigen::all);
    force_basis_ = force_basis(*solver_, problem_.forced, normals);
    compose(surface_map_, force_basis_.columns(), moving_vertices_);
  }
}

void FaceModel::predict(const RigidMotion& motion, Points& face_points) const {
  face_points = rest_face_;
  if (load_ == LoadModel::force) {
    const Points u = tissue_displacements(motion).topRows(problem_.tissue.surface_count);
    face_points += surface_map_ * u;
    return;
  }
  Points u;
  face_basis_.displacements({&motion, 1}, u);
  for (std::size_t i = 0; i < moving_vertices_.size(); ++i) {
    face_points.row(moving_vertices_[i]) += u.row(static_cast<Eigen::Index>(i));
  }
}

Points FaceModel::tissue_displacements(const RigidMotion& motion) const {
  Points u;
  if (load_ == LoadModel::displacement) {
    basis_.displacements({&motion, 1}, u);
    return u;
  }
  require_translation(motion);
  return force_basis_.displacements(motion.translation).displacements;
}

StaticSolution FaceModel::solve(const RigidMotion& motion) const {
  const Points& x = problem_.tissue.mesh.vertices;
  Points forces = Points::Zero(x.rows(), 3);
  if (load_ == LoadModel::force) require_translation(motion);
  if (load_ == LoadModel::force && !motion.translation.isZero(0)) {
    const Eigen::Vector3d direction = motion.translation.normalized();
    const double force = force_basis_.displacements(motion.translation).force_N;
    const Points normals = vertex_normals(problem_.region.mesh);
    for (const int v : problem_.forced) {
      forces.row(v) = force * normals.row(v).dot(direction) * direction.transpose();
    }
  }
  return solver_->solve(moved(x, motion) - x, forces);
}

}  // namespace gnathion
