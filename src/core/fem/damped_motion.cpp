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

DampedMotion::DampedMotion(const StaticSolver& statics, const TetMesh& mesh,
                           const DynamicsOptions& options)
    : statics_(statics), options_(options) {
  validate(options);
  newmark_beta_ = (options.gamma + 0.5) * (options.gamma + 0.5) / 4;
  const Eigen::Index n = mesh.vertices.rows();
  Eigen::VectorXd node_mass = Eigen::VectorXd::Zero(n);
  for (const auto& nodes : mesh.tets.rowwise()) {
    const LinearTet tet = linear_tet(mesh.vertices.row(nodes[0]), mesh.vertices.row(nodes[1]),
                                     mesh.vertices.row(nodes[2]), mesh.vertices.row(nodes[3]));
    for (const int node : nodes) node_mass[node] += options.density * tet.volume / 4;
  }
  const std::vector<int>& free_nodes = statics.free_nodes();
  mass_.resize(3 * static_cast<Eigen::Index>(free_nodes.size()));
  for (std::size_t i = 0; i < free_nodes.size(); ++i) {
    mass_.segment<3>(3 * static_cast<Eigen::Index>(i)).setConstant(node_mass[free_nodes[i]]);
  }
  // Both schemes solve m M + k K, scaled so that K keeps its size for long steps and M for short.
  const double h = options.step;
  const bool euler = options.scheme == TimeScheme::implicit_euler;
  const double m = euler ? 1 + h * options.alpha : 1 + options.gamma * h * options.alpha;
  const double k =
      euler ? h * options.beta + h * h : options.gamma * h * options.beta + newmark_beta_ * h * h;
  std::vector<int> order;
  Eigen::SparseMatrix<double> A = statics.free_part(order);
  A *= k;
  A.diagonal() += m * mass_;
  factor_ = std::make_unique<SpdFactor>(A, order);
  u_ = v_ = Points::Zero(n, 3);
  start_acceleration();
}

void DampedMotion::set_prescribed(const Points& prescribed) {
  for (std::size_t i = 0; i < statics_.supports().size(); ++i) {
    if (statics_.supports()[i] != Support::attached) continue;
    const auto row = static_cast<Eigen::Index>(i);
    if (!prescribed.row(row).allFinite()) {
      throw Error(ErrorKind::numeric, "dynamics", "a prescribed displacement is not finite",
                  "report this case: it is a fault of the program");
    }
    u_.row(row) = prescribed.row(row);
  }
  start_acceleration();
}

void DampedMotion::set_state(const Points& displacements, const Points& velocities) {
  for (const int node : statics_.free_nodes()) {
    u_.row(node) = displacements.row(node);
    v_.row(node) = velocities.row(node);
  }
  start_acceleration();
}

/// M a = −C v − K u at the present state.
void DampedMotion::start_acceleration() {
  const Eigen::VectorXd v = gathered(v_);
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
  const Eigen::VectorXd right = mass_.cwiseProduct(gathered(v_)) + h * elastic_force();
  const Eigen::VectorXd v = factor_->solve(right);
  for (const int node : statics_.free_nodes()) v_.row(node).setZero();
  add_to_free(v_, v, 1);
  add_to_free(u_, v, h);
}

/// Newmark 1959: predict, solve (M + γhC + β_N h²K) a₁ = −C v* − K u*, correct.
void DampedMotion::step_newmark() {
  const double h = options_.step, gamma = options_.gamma;
  add_to_free(u_, gathered(v_), h);
  add_to_free(u_, a_, h * h * (0.5 - newmark_beta_));
  add_to_free(v_, a_, h * (1 - gamma));
  const Eigen::VectorXd v = gathered(v_);
  const Eigen::VectorXd damping =
      options_.alpha * mass_.cwiseProduct(v) + options_.beta * free_stiffness_times(v);
  a_ = factor_->solve(elastic_force() - damping);
  add_to_free(u_, a_, newmark_beta_ * h * h);
  add_to_free(v_, a_, gamma * h);
}

double DampedMotion::energy() const {
  const Eigen::VectorXd v = gathered(v_);
  const Points force = statics_.stiffness() * u_;
  return (v.dot(mass_.cwiseProduct(v)) + (u_.array() * force.array()).sum()) / 2;
}

Eigen::VectorXd DampedMotion::elastic_force() const {
  return -gathered(statics_.stiffness() * u_);
}

Eigen::VectorXd DampedMotion::free_stiffness_times(const Eigen::VectorXd& x) const {
  Points field = Points::Zero(u_.rows(), 3);
  add_to_free(field, x, 1);
  return gathered(statics_.stiffness() * field);
}

Eigen::VectorXd DampedMotion::gathered(const Points& field) const {
  const std::vector<int>& free_nodes = statics_.free_nodes();
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(free_nodes.size()));
  for (std::size_t i = 0; i < free_nodes.size(); ++i) {
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) = field.row(free_nodes[i]);
  }
  return x;
}

void DampedMotion::add_to_free(Points& field, const Eigen::VectorXd& x, double factor) const {
  const std::vector<int>& free_nodes = statics_.free_nodes();
  for (std::size_t i = 0; i < free_nodes.size(); ++i) {
    field.row(free_nodes[i]) += factor * x.segment<3>(3 * static_cast<Eigen::Index>(i)).transpose();
  }
}

}  // namespace gnathion
