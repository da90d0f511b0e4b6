#include "prediction/settling.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

void validate(const SettlingOptions& options) {
  validate(options.dynamics);
  if (!(options.tolerance_mm > 0) || !std::isfinite(options.tolerance_mm)) {
    throw Error(ErrorKind::case_file, "dynamics.tolerance_mm",
                "it is " + std::to_string(options.tolerance_mm), "give a number above 0 in mm");
  }
  if (options.most_steps < 1) {
    throw Error(ErrorKind::case_file, "dynamics.most_steps",
                "it is " + std::to_string(options.most_steps), "give at least 1");
  }
}

/// Of the lengths of a field of the tissue on the face's moving vertices.
DistanceStatistics on_face(const FaceModel& model, const Points& field) {
  const TissueProblem& problem = model.problem();
  const Points mapped = problem.surface_map * field.topRows(problem.tissue.surface_count);
  return distance_statistics(mapped(model.moving_vertices(), Eigen::all).rowwise().norm());
}

}  // namespace

Settling settle(const FaceModel& model, std::span<const RigidMotion> motions,
                const SettlingOptions& options,
                const std::function<void(const SettlingFrame&)>& each, Progress& progress) {
  validate(options);
  if (model.load() == LoadModel::force) {
    throw Error(ErrorKind::case_file, "tissue.load",
                "force transfer has forces in place of a bone that moves, and its motion in time "
                "is not offered",
                "give \"displacement\"");
  }
  const auto stage = progress.stage("damped motion");
  const StaticSolver& statics = model.solver();
  const Points settled = model.solve(motions).displacements;
  progress.check();
  DampedMotion motion(statics, options.dynamics);
  motion.set_prescribed(
      bone_displacements(model.problem().tissue.mesh.vertices, statics.supports(), motions));
  for (int step = 0;; ++step) {
    progress.check();
    const DistanceStatistics distance = on_face(model, motion.displacements() - settled);
    each({step, motion.time(), distance, motion.energy(), motion.displacements()});
    // A swing passes through the static solution at speed, in no less time than it needs to leave
    // it: that speed times the time so far is more than its reach.
    const double reach = on_face(model, motion.velocities()).max * motion.time();
    const bool done = std::max(distance.max, reach) <= options.tolerance_mm;
    if (done || step == options.most_steps) return {done, step, motion.time()};
    motion.step();
  }
}

}  // namespace gnathion
