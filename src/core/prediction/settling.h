#pragma once

#include <functional>
#include <span>

#include "fem/damped_motion.h"
#include "geometry/surface_distance.h"
#include "prediction/face_model.h"

namespace gnathion {

/// How the tissue moves, and when it counts as settled.
struct SettlingOptions {
  DynamicsOptions dynamics;
  /// mm: settled when no vertex of the face is farther from the static solution, nor would be if it
  /// went on at its present speed for as long as it took so far.
  double tolerance_mm = 0.01;
  int most_steps = 1000;
};

/// The tissue at one time on its way to the static solution.
struct SettlingFrame {
  int step = 0;                 ///< 0: the bone has jumped, the tissue has not followed yet
  double time_s = 0;            ///< s
  DistanceStatistics distance;  ///< of the face's moving vertices to the static solution, mm
  double energy_Nmm = 0;        ///< kinetic and elastic
  const Points& displacements;  ///< of the tissue's vertices, n×3, mm; FaceModel::face_with()
};

/// How a damped motion ended.
struct Settling {
  bool settled = false;  ///< false: it took more steps than allowed
  int steps = 0;
  double time_s = 0;
};

/// The damped motion (paper, eq. 1 and 2) of the model's tissue on linear elements, from rest,
/// after the segments have jumped to their `motions` (one a segment): `each` hears every time step,
/// the start included, on the calling thread, until the face has settled to the static solution of
/// the linear model. An exception that `each` throws ends it. Throws Error(case_file) for options
/// out of range and for force transfer, which has no bone that moves; Error(numeric) as
/// StaticSolver; Error(cancelled).
Settling settle(const FaceModel& model, std::span<const RigidMotion> motions,
                const SettlingOptions& options,
                const std::function<void(const SettlingFrame&)>& each, Progress& progress);

}  // namespace gnathion
