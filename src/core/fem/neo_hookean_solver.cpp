#include "fem/neo_hookean_solver.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "fem/anderson.h"

namespace gnathion {
namespace {

/// Load steps before the last are only stations on the way.
constexpr double kStationTolerance = 1e-3;

/// A prediction may squeeze the tissue to this part of what it was; beyond, two smaller steps are
/// sooner done (on p1, 20 to 60 mm and 30 to 60°, 0.4 took 0.5 to 0.9 of the time of 0.2).
constexpr double kSqueeze = 0.4;

/// Newton steps at one load step, before a smaller one is tried.
constexpr int kNewtonSteps = 8;

/// A state of displacement: u = given + Q q.
struct State {
  Points given;  ///< prescribed part
  Eigen::VectorXd q;
};

/// How far a state is from equilibrium.
struct Balance {
  Eigen::VectorXd force;  ///< −Qᵀ f_int, N
  double relative = std::numeric_limits<double>::infinity();
};

/// One walk along a path.
class Walk {
 public:
  Walk(const StaticSolver& linear, const NeoHookeanTissue& tissue, const NeoHookeanOptions& options,
       Progress& progress)
      : linear_(linear), tissue_(tissue), options_(options), progress_(progress) {
    for (int i = 0; i < linear.stiffness().node_count(); ++i) {
      const StiffnessMatrix& K = linear.stiffness();
      const auto row = K.column.begin() + K.start[i];
      const auto at = std::lower_bound(row, K.column.begin() + K.start[i + 1], i);
      node_stiffness_.push_back(K.blocks[at - K.column.begin()].norm());
    }
  }

  NeoHookeanSolution along(const MotionPath& path, const Points& start);

 private:
  Points field(const State& state) const {
    Points u = state.given;
    linear_.free_part().add(state.q, 1, u);
    return u;
  }
  std::optional<Balance> balance(const State& state) const;
  double force_scale(const Points& u) const;
  bool overdone(const State& state, const Points& prediction) const;
  State predicted(const State& from, const Points& given) const;
  bool settle(State& state, double tolerance);
  bool is_settled(const State& state, double tolerance);
  bool promising(const std::vector<double>& residuals, double tolerance) const;
  bool accelerate(State& state, double tolerance);
  bool newton_step(State& state);
  void factorise_tangent(const Points& u);
  bool line_search(State& state, const Eigen::VectorXd& step, double slope) const;
  [[noreturn]] void refuse(double t, const Points& blocked) const;
  const SpdFactor& factor() const { return tangent_factor_ ? *tangent_factor_ : linear_.factor(); }
  const StiffnessMatrix& stiffness() const {
    return tangent_factor_ ? tangent_ : linear_.stiffness();
  }

  const StaticSolver& linear_;
  const NeoHookeanTissue& tissue_;
  const NeoHookeanOptions& options_;
  Progress& progress_;
  std::vector<double> node_stiffness_;  ///< ‖K_ii‖
  StiffnessMatrix tangent_;
  std::optional<SpdFactor> tangent_factor_;
  NeoHookeanSolution result_;
};

double Walk::force_scale(const Points& u) const {
  double sum = 0;
  for (Eigen::Index i = 0; i < u.rows(); ++i) {
    sum += node_stiffness_[i] * node_stiffness_[i] * u.row(i).squaredNorm();
  }
  return std::sqrt(sum);
}

/// None for an inadmissible state.
std::optional<Balance> Walk::balance(const State& state) const {
  const Points u = field(state);
  Points force;
  if (!tissue_.internal_force(u, force)) return std::nullopt;
  Balance balance{-linear_.free_part().gather(force)};
  const double free = balance.force.squaredNorm();
  const double reaction = std::sqrt(std::max(force.squaredNorm() - free, 0.0));
  const double scale = std::max(reaction, 1e-4 * force_scale(u));
  balance.relative = scale > 0 ? std::sqrt(free) / scale : 0;
  return balance;
}

/// The state under other prescribed displacements, by the linear response to their change.
State Walk::predicted(const State& from, const Points& given) const {
  const Points pull = stiffness() * Points(given - from.given);
  return {given, from.q - factor().solve(linear_.free_part().gather(pull))};
}

/// Whether a prediction from `state` squeezes the tissue too much, or turns it inside out.
bool Walk::overdone(const State& state, const Points& prediction) const {
  const double before = tissue_.most_compressed(field(state)).volume_ratio;
  return !(tissue_.most_compressed(prediction).volume_ratio > kSqueeze * std::min(before, 1.0));
}

NeoHookeanSolution Walk::along(const MotionPath& path, const Points& start) {
  const Supports& supports = linear_.supports();
  State state{prescribed_part(supports, path(0)), linear_.free_part().gather(start)};
  double t = 0, step = 1;
  bool factor_is_of_state = start.isZero(0);  // the linear factor is that of rest
  while (t < 1) {
    const double next = std::min(1.0, t + step);
    const Points given = prescribed_part(supports, path(next));
    State trial = predicted(state, given);
    if (!factor_is_of_state && overdone(state, field(trial))) {
      ++result_.newton_iterations;
      factorise_tangent(field(state));
      factor_is_of_state = true;
      trial = predicted(state, given);
    }
    const Points prediction = field(trial);
    const bool attempted = !overdone(state, prediction);
    const bool settled =
        attempted && settle(trial, next < 1 ? kStationTolerance : options_.tolerance);
    if (attempted) factor_is_of_state = false;
    if (settled) {
      state = std::move(trial);
      t = next;
      step *= 2;
      ++result_.load_steps;
      continue;
    }
    step = (next - t) / 2;
    if (step < options_.smallest_step || result_.newton_iterations >= options_.newton_limit) {
      refuse(t, prediction);
    }
  }
  result_.displacements = field(state);
  result_.most_compressed = tissue_.most_compressed(result_.displacements);
  return result_;
}

/// Newton steps, each followed by as many cheap iterations with its factor as promise to be worth
/// it.
bool Walk::settle(State& state, double tolerance) {
  for (int k = 0; k < kNewtonSteps; ++k) {
    if (options_.frozen_factor ? accelerate(state, tolerance) : is_settled(state, tolerance)) {
      return true;
    }
    if (result_.newton_iterations >= options_.newton_limit || !newton_step(state)) return false;
  }
  return false;
}

bool Walk::is_settled(const State& state, double tolerance) {
  result_.relative_residual = balance(state)->relative;
  return result_.relative_residual <= tolerance;
}

/// Whether the residuals of the last iterations promise the tolerance soon.
bool Walk::promising(const std::vector<double>& residuals, double tolerance) const {
  constexpr std::size_t kWindow = 5, kPatience = 9;
  constexpr double kWorthAFactor = 25;  // more iterations to go than this take longer than a factor
  if (residuals.size() < kPatience) return true;
  const double now = residuals.back();
  const double rate = std::log(now / residuals[residuals.size() - 1 - kWindow]) / kWindow;
  return rate < 0 && std::log(tolerance / now) / rate < kWorthAFactor;
}

/// Iterates with the factor at hand. Where that does not converge, what it leaves has no more
/// energy than what it was given, so that Newton's steps, which lower the energy, do not go round
/// in circles with it.
bool Walk::accelerate(State& state, double tolerance) {
  AndersonAcceleration acceleration(state.q.size(), options_.anderson_depth);
  State trial = state, best = state;
  std::optional<Balance> now = balance(state);
  std::vector<double> residuals;
  while (now) {
    progress_.check();
    if (residuals.empty() || now->relative < *std::ranges::min_element(residuals)) best.q = trial.q;
    residuals.push_back(now->relative);
    result_.relative_residual = now->relative;
    if (now->relative <= tolerance) {
      state.q = trial.q;
      return true;
    }
    if (!promising(residuals, tolerance)) break;
    ++result_.anderson_iterations;
    const Eigen::VectorXd from = trial.q;
    const Eigen::VectorXd change = acceleration.next(from, factor().solve(now->force)) - from;
    now.reset();
    for (double part = 1; part > 0.05 && !now; part /= 2) {
      trial.q = from + part * change;
      now = balance(trial);
    }
  }
  if (tissue_.energy(field(best)) < tissue_.energy(field(state))) state.q = best.q;
  return false;
}

/// Leaves no tangent factor where even the projected tangent has none.
void Walk::factorise_tangent(const Points& u) {
  if (tangent_.start.empty()) tangent_ = linear_.stiffness();
  for (const bool projected : {false, true}) {
    tissue_.tangent(u, projected, tangent_);
    const auto lower = free_stiffness(tangent_, linear_.free_part());
    try {
      if (tangent_factor_) {
        tangent_factor_->refactor(lower);
      } else {
        tangent_factor_.emplace(lower, linear_.order());
      }
      return;
    } catch (const Error&) {
      if (projected) tangent_factor_.reset();
    }
  }
}

bool Walk::newton_step(State& state) {
  progress_.check();
  ++result_.newton_iterations;
  factorise_tangent(field(state));
  if (!tangent_factor_) return false;
  const Eigen::VectorXd force = balance(state)->force;
  const Eigen::VectorXd step = factor().solve(force);
  return line_search(state, step, -force.dot(step));
}

/// Takes as much of the step as lowers the energy enough (Armijo 1966) and admits the state.
bool Walk::line_search(State& state, const Eigen::VectorXd& step, double slope) const {
  const double before = tissue_.energy(field(state));
  const double rounding = 1e-12 * std::abs(before);
  for (double part = 1; part > 1e-4; part /= 2) {
    const State trial{state.given, state.q + part * step};
    if (tissue_.energy(field(trial)) > before + 1e-4 * part * slope + rounding) continue;
    state = trial;
    return true;
  }
  return false;
}

void Walk::refuse(double t, const Points& blocked) const {
  const Compression tissue = tissue_.most_compressed(blocked);
  std::ostringstream where;
  where.precision(3);
  where << "the tissue could follow only " << 100 * t << " % of the motion: beyond, tet "
        << tissue.tet << " near (" << tissue.place << ") mm ";
  if (tissue.volume_ratio > 0) {
    where << "is compressed to " << 100 * tissue.volume_ratio << " % of its volume";
  } else {
    where << "is turned inside out";
  }
  throw Error(ErrorKind::numeric, "large motion", where.str(),
              "move the bone less, or choose a region with more free tissue around the bone");
}

}  // namespace

NeoHookeanSolver::NeoHookeanSolver(const StaticSolver& linear)
    : linear_(linear), tissue_(linear.elements(), linear.materials()) {}

NeoHookeanSolution NeoHookeanSolver::solve(const MotionPath& path, const Points& start,
                                           Progress& progress,
                                           const NeoHookeanOptions& options) const {
  const auto stage = progress.stage("neo-Hookean");
  if (!path(0).allFinite() || !path(1).allFinite() || !start.allFinite()) {
    throw Error(ErrorKind::numeric, "large motion", "a displacement is not finite",
                "report this case: it is a fault of the program");
  }
  const Compression at_start = tissue_.most_compressed(start);
  if (!(at_start.volume_ratio > 0)) {
    throw Error(ErrorKind::numeric, "large motion",
                "tet " + std::to_string(at_start.tet) + " is turned inside out at the start",
                "start at rest, or at an earlier answer");
  }
  return Walk(linear_, tissue_, options, progress).along(path, start);
}

}  // namespace gnathion
