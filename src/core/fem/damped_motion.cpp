#include "fem/damped_motion.h"

#include <cmath>
#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

void require(bool good, const std::string& key, double value, const std::string& remedy) {
  if (good && std::isfinite(value)) return;
  throw Error(ErrorKind::case_file, "dynamics." + key, "it is " + std::to_string(value), remedy);
}

}  // namespace

void validate(const DynamicsOptions& options) {
  require(options.density > 0, "density", options.density, "give a number above 0 in t/mm3");
  require(options.alpha >= 0, "alpha", options.alpha, "give 0 or a positive number in 1/s");
  require(options.beta >= 0, "beta", options.beta, "give 0 or a positive number in s");
  require(options.step > 0, "step", options.step, "give a number above 0 in s");
  require(options.gamma >= 0.5, "gamma", options.gamma, "give at least 0.5: less is unstable");
}

DampedMotion::DampedMotion(const StaticSolver& statics, const DynamicsOptions& options)
    : statics_(statics), options_(options) {
  validate(options);
  newmark_beta_ = (options.gamma + 0.5) * (options.gamma + 0.5) / 4;
  const Eigen::VectorXd node_mass = lumped_mass(statics.elements(), options.density);
  const FreePart& free = statics.free_part();
  mass_.resize(free.size());
  for (std::size_t i = 0; i < free.nodes().size(); ++i) {
    const int first = free.first()[i];
    mass_.segment(first, free.first()[i + 1] - first).setConstant(node_mass[free.nodes()[i]]);
  }
  // Both schemes solve m M + k K, scaled so that K keeps its size for long steps and M for short.
  const double h = options.step;
  const bool euler = options.scheme == TimeScheme::implicit_euler;
  const double m = euler ? 1 + h * options.alpha : 1 + options.gamma * h * options.alpha;
  const double k =
      euler ? h * options.beta + h * h : options.gamma * h * options.beta + newmark_beta_ * h * h;
  Eigen::SparseMatrix<double> A = free_stiffness(statics.stiffness(), free);
  A *= k;
  A.diagonal() += m * mass_;
  factor_ = std::make_unique<SpdFactor>(A, statics.order());
  u_ = v_ = Points::Zero(node_mass.size(), 3);
  start_acceleration();
}

void DampedMotion::set_prescribed(const Points& prescribed) {
  const Points given = prescribed_part(statics_.supports(), prescribed);
  if (!given.allFinite()) {
    throw Error(ErrorKind::numeric, "dynamics", "a prescribed displacement is not finite",
                "report this case: it is a fault of the program");
  }
  const Eigen::VectorXd free = statics_.free_part().gather(u_);
  u_ = given;
  statics_.free_part().add(free, 1, u_);
  // The acceleration stays that of before: with the jump's, which falls within the next step,
  // Newmark's first steps would overshoot by its ratio to what a long step can follow.
}

void DampedMotion::set_state(const Points& displacements, const Points& velocities) {
  const FreePart& free = statics_.free_part();
  u_ = prescribed_part(statics_.supports(), u_);
  free.add(free.gather(displacements), 1, u_);
  v_.setZero();
  free.add(free.gather(velocities), 1, v_);
  start_acceleration();
}

/// M a = −C v − K u at the present state.
void DampedMotion::start_acceleration() {
  const Eigen::VectorXd v = statics_.free_part().gather(v_);
  const Eigen::VectorXd damping =
      options_.alpha * mass_.cwiseProduct(v) + options_.beta * free_stiffness_times(v);
  a_ = (elastic_force() - damping).cwiseQuotient(mass_);
}

void DampedMotion::step() {
  if (options_.scheme == TimeScheme::implicit_euler) {
    step_euler();
  } else {
    step_newmark();
  }
  time_ += options_.step;
}

/// (M + hC + h²K) v₁ = M v₀ − h K u₀, u₁ = u₀ + h v₁.
void DampedMotion::step_euler() {
  const double h = options_.step;
  const Eigen::VectorXd right =
      mass_.cwiseProduct(statics_.free_part().gather(v_)) + h * elastic_force();
  const Eigen::VectorXd v = factor_->solve(right);
  v_.setZero();
  statics_.free_part().add(v, 1, v_);
  statics_.free_part().add(v, h, u_);
}

/// Newmark 1959: predict, solve (M + γhC + β_N h²K) a₁ = −C v* − K u*, correct.
void DampedMotion::step_newmark() {
  const double h = options_.step, gamma = options_.gamma;
  statics_.free_part().add(statics_.free_part().gather(v_), h, u_);
  statics_.free_part().add(a_, h * h * (0.5 - newmark_beta_), u_);
  statics_.free_part().add(a_, h * (1 - gamma), v_);
  const Eigen::VectorXd v = statics_.free_part().gather(v_);
  const Eigen::VectorXd damping =
      options_.alpha * mass_.cwiseProduct(v) + options_.beta * free_stiffness_times(v);
  a_ = factor_->solve(elastic_force() - damping);
  statics_.free_part().add(a_, newmark_beta_ * h * h, u_);
  statics_.free_part().add(a_, gamma * h, v_);
}

double DampedMotion::energy() const {
  const Eigen::VectorXd v = statics_.free_part().gather(v_);
  const Points force = statics_.stiffness() * u_;
  return (v.dot(mass_.cwiseProduct(v)) + (u_.array() * force.array()).sum()) / 2;
}

Eigen::VectorXd DampedMotion::elastic_force() const {
  return -statics_.free_part().gather(Points(statics_.stiffness() * u_));
}

Eigen::VectorXd DampedMotion::free_stiffness_times(const Eigen::VectorXd& x) const {
  Points field = Points::Zero(u_.rows(), 3);
  statics_.free_part().add(x, 1, field);
  return statics_.free_part().gather(Points(statics_.stiffness() * field));
}

}  // namespace gnathion
