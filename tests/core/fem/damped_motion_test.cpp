#include "fem/damped_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "support/sliding_patch.h"

namespace gnathion {
namespace {

using testing::attached_displacements;
using testing::held_patch;
using testing::HeldPatch;

/// A held patch, its statics and where a motion of the bone brings it.
struct Scene {
  HeldPatch patch = held_patch();
  Progress progress;
  StaticSolver statics{patch.tissue.mesh, {}, patch.supports, progress};
  Points prescribed;
  Points settled;

  Scene() {
    RigidMotion motion;
    motion.translation << 1, -5, 2;
    prescribed = attached_displacements(patch, motion);
    settled = statics.solve(prescribed, Points::Zero(prescribed.rows(), 3)).displacements;
  }
  double distance(const DampedMotion& motion) const {
    return (motion.displacements() - settled).norm() / settled.norm();
  }
  /// Energy above that of the settled state.
  double excess(const DampedMotion& motion) const {
    const Points force = statics.stiffness() * settled;
    return motion.energy() - (settled.array() * force.array()).sum() / 2;
  }
};

/// The lowest free vibration of the scene: ω and its shape.
struct Mode {
  double omega = 0;
  Points shape;
};

Mode lowest_mode(const StaticSolver& statics, double density) {
  const FreePart& free = statics.free_part();
  const Eigen::MatrixXd lower = free_stiffness(statics.stiffness(), free);
  const Eigen::MatrixXd K = lower.selfadjointView<Eigen::Lower>();
  const ElementMesh& mesh = statics.elements();
  Points node_mass = Points::Zero(mesh.nodes.rows(), 3);
  for (const auto& t : mesh.elements.rowwise()) {
    const double volume = linear_tet(mesh.nodes.row(t[0]), mesh.nodes.row(t[1]),
                                     mesh.nodes.row(t[2]), mesh.nodes.row(t[3]))
                              .volume;
    for (const int node : t) node_mass.row(node).array() += density * volume / 4;
  }
  const Eigen::VectorXd root = free.gather(node_mass).cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(root.asDiagonal() * K *
                                                              root.asDiagonal());
  Mode mode{std::sqrt(solver.eigenvalues()[0]), Points::Zero(mesh.nodes.rows(), 3)};
  const Eigen::VectorXd shape = root.cwiseProduct(solver.eigenvectors().col(0));
  free.add(shape, 1 / shape.cwiseAbs().maxCoeff(), mode.shape);
  return mode;
}

class Schemes : public ::testing::TestWithParam<TimeScheme> {};

TEST_P(Schemes, SettleToTheStaticSolution) {
  const Scene scene;
  DynamicsOptions options;
  options.scheme = GetParam();
  options.step = 0.05;
  DampedMotion motion(scene.statics, options);
  motion.set_prescribed(scene.prescribed);
  EXPECT_GT(scene.distance(motion), 0.1) << "the tissue is still at rest";
  for (int k = 0; k < 200; ++k) motion.step();
  EXPECT_LT(scene.distance(motion), 1e-6);
  EXPECT_NEAR(motion.time(), 10, 1e-9);
  EXPECT_LT(motion.velocities().cwiseAbs().maxCoeff(), 1e-6);
}

TEST_P(Schemes, SettleWithSlidingAndQuadraticElementsToo) {
  TriangleMesh surface = testing::flat_disk(196, 52, 4);
  testing::raise(surface, [](double x, double y) { return testing::bump(x, y, 3, -2, 12, 9) * 5; });
  const HeldPatch patch = testing::sliding_patch(surface);
  const ElementMesh mesh(patch.tissue.mesh, ElementOrder::quadratic);
  const Supports supports = supports_of_nodes(mesh, patch.supports);
  Progress progress;
  const StaticSolver statics(mesh, {}, supports, progress);
  std::array<RigidMotion, 2> motions;
  motions[0].translation << 1, -5, 2;
  motions[1].translation << -1, 0, 3;
  const Points prescribed = bone_displacements(mesh.nodes, supports, motions);
  const Points settled =
      statics.solve(prescribed, Points::Zero(prescribed.rows(), 3)).displacements;
  DynamicsOptions options;
  options.scheme = GetParam();
  options.step = 0.05;
  DampedMotion motion(statics, options);
  motion.set_prescribed(prescribed);
  EXPECT_GT((motion.displacements() - settled).norm(), 0.1 * settled.norm());
  for (int k = 0; k < 60; ++k) motion.step();
  EXPECT_LT((motion.displacements() - settled).norm(), 1e-6 * settled.norm());
}

TEST_P(Schemes, AreStableAtEveryStepEvenWithoutDamping) {
  const Scene scene;
  for (const double step : {1e-6, 1e-4, 1e-2, 1.0, 1e3}) {
    for (const double damping : {0.0, 1.0, 1e4}) {
      DynamicsOptions options;
      options.scheme = GetParam();
      options.step = step;
      options.alpha = 20 * damping;
      options.beta = 0.01 * damping;
      DampedMotion motion(scene.statics, options);
      motion.set_prescribed(scene.prescribed);
      const double start = scene.excess(motion);
      ASSERT_GT(start, 0);
      // Newmark's first steps after a jump may hold more energy than the jump; none may grow.
      double early = start, late = 0;
      for (int k = 0; k < 100; ++k) {
        motion.step();
        ASSERT_TRUE(motion.displacements().allFinite()) << step << ' ' << damping;
        double& largest = k < 50 ? early : late;
        largest = std::max(largest, scene.excess(motion));
      }
      EXPECT_LT(late, 1.001 * early) << "step " << step << " s, damping " << damping;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Schemes,
                         ::testing::Values(TimeScheme::implicit_euler, TimeScheme::newmark));

TEST(DampedMotion, ImplicitEulerNeverGainsEnergy) {
  const Scene scene;
  DynamicsOptions options;
  options.alpha = options.beta = 0;
  options.step = 1e-3;
  DampedMotion motion(scene.statics, options);
  motion.set_prescribed(scene.prescribed);
  double last = scene.excess(motion);
  const double rounding = 1e-12 * last;
  for (int k = 0; k < 50; ++k) {
    motion.step();
    const double now = scene.excess(motion);
    EXPECT_LE(now, last + rounding);
    last = now;
  }
}

TEST(DampedMotion, AModeDecaysAsRayleighSaysAtTheSchemesOwnRate) {
  const HeldPatch patch = held_patch(testing::flat_disk(196, 52, 2.2), 6);
  Progress progress;
  const StaticSolver statics(patch.tissue.mesh, {}, patch.supports, progress);
  DynamicsOptions options;
  const Mode mode = lowest_mode(statics, options.density);
  // ü + 2ζω u̇ + ω²u = 0 with 2ζω = α + βω²: 10 % of critical damping, half from each term.
  options.alpha = 0.1 * mode.omega;
  options.beta = 0.1 / mode.omega;
  const double zeta = 0.1, damped = mode.omega * std::sqrt(1 - zeta * zeta);
  const double end = 2 / mode.omega;
  const double exact =
      std::exp(-zeta * mode.omega * end) *
      (std::cos(damped * end) + zeta * mode.omega / damped * std::sin(damped * end));
  const auto error = [&](TimeScheme scheme, int steps) {
    options.scheme = scheme;
    options.gamma = 0.5;
    options.step = end / steps;
    DampedMotion motion(statics, options);
    motion.set_state(mode.shape, Points::Zero(mode.shape.rows(), 3));
    for (int k = 0; k < steps; ++k) motion.step();
    return (motion.displacements() - exact * mode.shape).cwiseAbs().maxCoeff();
  };
  const double euler =
      error(TimeScheme::implicit_euler, 100) / error(TimeScheme::implicit_euler, 200);
  EXPECT_NEAR(euler, 2, 0.1);
  const double newmark = error(TimeScheme::newmark, 50) / error(TimeScheme::newmark, 100);
  EXPECT_NEAR(newmark, 4, 0.2);
}

TEST(DampedMotion, RefusesOptionsOutOfRange) {
  const Scene scene;
  const auto refused = [&](auto set) {
    DynamicsOptions options;
    set(options);
    try {
      const DampedMotion motion(scene.statics, options);
      return std::string("accepted");
    } catch (const Error& error) {
      return error.subject();
    }
  };
  EXPECT_EQ(refused([](auto& o) { o.step = 0; }), "dynamics.step");
  EXPECT_EQ(refused([](auto& o) { o.density = -1; }), "dynamics.density");
  EXPECT_EQ(refused([](auto& o) { o.alpha = std::nan(""); }), "dynamics.alpha");
  EXPECT_EQ(refused([](auto& o) { o.beta = -1e-9; }), "dynamics.beta");
  EXPECT_EQ(refused([](auto& o) { o.gamma = 0.49; }), "dynamics.gamma");
}

}  // namespace
}  // namespace gnathion
