#pragma once

#include <Eigen/Core>

namespace gnathion {

/// Anderson acceleration of the fixed-point iteration x ← x + step(x): type II (the multisecant
/// form) with the last `depth` changes, after Walker and Ni, *Anderson acceleration for fixed-point
/// iterations*, SIAM J. Numer. Anal. 49 (2011).
class AndersonAcceleration {
 public:
  AndersonAcceleration(Eigen::Index size, int depth);

  /// The next x after `x`, where the iteration would make `step`; both of the size given to the
  /// constructor. x need not be what was returned last.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& step);

 private:
  void remember(const Eigen::VectorXd& x, const Eigen::VectorXd& step);

  Eigen::MatrixXd x_changes_, step_changes_;  ///< size×depth
  Eigen::MatrixXd gram_;                      ///< depth×depth: of step_changes_
  Eigen::VectorXd last_x_, last_step_;
  Eigen::Index seen_ = 0;
};

}  // namespace gnathion
