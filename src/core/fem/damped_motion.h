#pragma once

#include "fem/static_solver.h"

namespace gnathion {

enum class TimeScheme {
  implicit_euler,  ///< first order, damps every mode: settles soonest
  newmark,         ///< γ and β_N as given; second order only for γ = 1/2
};

/// Rayleigh damping (paper, eq. 2), inertia and time step.
struct DynamicsOptions {
  double density = 1e-9;  ///< t/mm³ (N·s²/mm⁴): water
  double alpha = 20;      ///< 1/s, of αM
  double beta = 0.01;     ///< s, of βK
  double step = 0.01;     ///< s
  TimeScheme scheme = TimeScheme::implicit_euler;
  /// Newmark's γ, at least 1/2. Above 1/2 high modes die out by themselves; at 1/2 they ring on
  /// where there is no other damping. β_N = (γ + 1/2)²/4, which is stable at every step.
  double gamma = 0.6;
};

/// Throws Error(case_file) naming the value that is not finite or out of range.
void validate(const DynamicsOptions& options);

/// The tissue's motion in time, M ü + (αM + βK) u̇ + K u = f (paper, eq. 1 and 2), with lumped
/// masses, from rest; the bone jumps to where it is set and the tissue follows. The matrix of a
/// step is factorised once. It settles to the static solution, which it does not need to be asked
/// for.
class DampedMotion {
 public:
  /// `statics` must outlive this. Throws Error(case_file) for options out of range, Error(numeric)
  /// as SpdFactor.
  DampedMotion(const StaticSolver& statics, const DynamicsOptions& options);

  /// Moves the nodes that bone moves at once to these displacements, as StaticSolver::solve reads
  /// them. prescribed: n×3, mm. Throws Error(numeric) when one is not finite.
  void set_prescribed(const Points& prescribed);

  /// Starts the free part of the motion from a given state. n×3, mm and mm/s.
  void set_state(const Points& displacements, const Points& velocities);

  void step();

  double time() const { return time_; }               ///< s
  const Points& displacements() const { return u_; }  ///< n×3, mm
  const Points& velocities() const { return v_; }     ///< n×3, mm/s
  /// ½ vᵀMv + ½ uᵀKu, N·mm.
  double energy() const;

 private:
  Eigen::VectorXd elastic_force() const;  ///< −Qᵀ K u
  Eigen::VectorXd free_stiffness_times(const Eigen::VectorXd& x) const;
  void start_acceleration();
  void step_euler();
  void step_newmark();

  const StaticSolver& statics_;
  DynamicsOptions options_;
  double newmark_beta_;
  Eigen::VectorXd mass_;  ///< lumped, one a free component, t
  std::unique_ptr<SpdFactor> factor_;
  Points u_, v_;
  Eigen::VectorXd a_;  ///< of the free components (Newmark), mm/s²
  double time_ = 0;
};

}  // namespace gnathion
