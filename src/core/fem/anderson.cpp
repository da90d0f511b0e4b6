#include "fem/anderson.h"

#include <Eigen/QR>
#include <algorithm>

namespace gnathion {

AndersonAcceleration::AndersonAcceleration(Eigen::Index size, int depth)
    : x_changes_(size, depth), step_changes_(size, depth), gram_(depth, depth) {}

void AndersonAcceleration::remember(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  const Eigen::Index depth = gram_.rows(), place = (seen_ - 1) % depth;
  x_changes_.col(place) = x - last_x_;
  step_changes_.col(place) = step - last_step_;
  const Eigen::Index kept = std::min(seen_, depth);
  gram_.row(place).head(kept) = step_changes_.col(place).transpose() * step_changes_.leftCols(kept);
  gram_.col(place).head(kept) = gram_.row(place).head(kept);
}

Eigen::VectorXd AndersonAcceleration::next(const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  if (seen_ > 0) remember(x, step);
  const Eigen::Index kept = std::min(seen_, gram_.rows());
  ++seen_;
  last_x_ = x;
  last_step_ = step;
  if (kept == 0) return x + step;
  // Scaled to a unit diagonal: the changes shrink by orders of magnitude as x converges.
  const Eigen::VectorXd scale =
      gram_.diagonal().head(kept).cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled =
      scale.asDiagonal() * gram_.topLeftCorner(kept, kept) * scale.asDiagonal();
  const Eigen::VectorXd right =
      scale.asDiagonal() * (step_changes_.leftCols(kept).transpose() * step);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(kept, kept);
  solver.setThreshold(1e-13);
  solver.compute(scaled);
  const Eigen::VectorXd weights = scale.asDiagonal() * solver.solve(right);
  return x + step - x_changes_.leftCols(kept) * weights - step_changes_.leftCols(kept) * weights;
}

}  // namespace gnathion
