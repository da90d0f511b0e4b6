#pragma once

#include "fem/motion_path.h"
#include "fem/neo_hookean.h"
#include "fem/static_solver.h"

namespace gnathion {

struct NeoHookeanOptions {
  /// Of the relative residual; the error of the displacements, as a part of the largest, is below
  /// it. Rounding leaves about 1e-13.
  double tolerance = 1e-6;
  /// Iterate with the linear model's factor, and with that of every tangent, as long as that
  /// promises to converge. Without it every iteration is Newton's.
  bool frozen_factor = true;
  int anderson_depth = 10;           ///< changes that the acceleration remembers
  int newton_limit = 80;             ///< tangents factorised in all, before the motion is refused
  double smallest_step = 1.0 / 256;  ///< of the path, before the motion is refused
};

/// A state of equilibrium, and what it took to find it.
struct NeoHookeanSolution {
  Points displacements;          ///< n×3, mm
  double relative_residual = 0;  ///< see NeoHookeanSolver
  int load_steps = 0;            ///< states of equilibrium on the path, the last included
  int anderson_iterations = 0;   ///< each a force and a back-solve
  int newton_iterations = 0;     ///< each a tangent and a factorisation
  Compression most_compressed;   ///< J where the tissue is compressed most
};

/// Neo-Hookean statics of a linear model's mesh, materials and supports, for motions beyond what
/// small strain can answer: min over q of the energy of u = u_d + Q q.
///
/// Starting at a known equilibrium, the path's end is tried at once from the linear response to
/// it, with the linear factor as preconditioner and Anderson acceleration; where that turns tissue
/// inside out, or nearly, the path is walked in steps. Where Anderson's iteration promises nothing
/// soon, a Newton step with a line search on the energy is taken, whose factor then serves the
/// iteration and the next prediction. No state with J <= 0 is ever accepted.
///
/// The relative residual is ‖Qᵀ f_int‖ / max(‖f_int − QQᵀ f_int‖, 1e-4 s): the out-of-balance force
/// over the reactions of the supports; s, the norm of ‖K_ii‖ ‖u_i‖ over the nodes, stands in where
/// a motion causes no reactions (a rigid motion of everything).
///
/// A sliding node keeps to the plane normal to the bone at rest, moved along that normal.
class NeoHookeanSolver {
 public:
  /// `linear` must outlive this.
  explicit NeoHookeanSolver(const StaticSolver& linear);

  /// The equilibrium at path(1), followed from `start` (n×3, mm), an equilibrium at path(0): zero
  /// for a path from rest, or the last answer. Can be called from several threads.
  /// Throws Error(numeric) where the tissue cannot follow the motion, naming how far it could and
  /// the tet that stopped it, and for a path or start that is not finite; Error(cancelled).
  NeoHookeanSolution solve(const MotionPath& path, const Points& start, Progress& progress,
                           const NeoHookeanOptions& options = {}) const;

  const NeoHookeanTissue& tissue() const { return tissue_; }

 private:
  const StaticSolver& linear_;
  NeoHookeanTissue tissue_;
};

}  // namespace gnathion
