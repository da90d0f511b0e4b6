#include "fem/neo_hookean_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "bench/chin_problem.h"
#include "fem/anderson.h"
#include "fem/linearisation_error.h"
#include "support/expect_error.h"
#include "support/sliding_patch.h"
#include "support/tet_solids.h"

namespace gnathion {
namespace {

using testing::held_patch;
using testing::HeldPatch;
using testing::sliding_patch;

RigidMotion turned(double degrees, const Eigen::Vector3d& axis, const Eigen::Vector3d& about,
                   const Eigen::Vector3d& shift) {
  RigidMotion motion;
  motion.rotation = Eigen::AngleAxisd(degrees * M_PI / 180, axis.normalized()).toRotationMatrix();
  motion.translation = about - motion.rotation * about + shift;
  return motion;
}

/// A linear model and the large motion of it.
struct Scene {
  Progress progress;
  StaticSolver linear;
  NeoHookeanSolver solver;
  Points rest;

  explicit Scene(const HeldPatch& patch, ElementOrder order = ElementOrder::linear,
                 const TissueMaterials& materials = {})
      : Scene(ElementMesh(patch.tissue.mesh, order), patch.supports, materials) {}
  Scene(const ElementMesh& mesh, const Supports& of_vertices, const TissueMaterials& materials)
      : linear(mesh, materials, supports_of_nodes(mesh, of_vertices), progress),
        solver(linear),
        rest(Points::Zero(mesh.nodes.rows(), 3)) {}

  MotionPath path(const std::vector<RigidMotion>& to) const {
    return bone_path(linear.elements().nodes, linear.supports(), to);
  }
  NeoHookeanSolution solve(const std::vector<RigidMotion>& to,
                           const NeoHookeanOptions& options = {}) {
    return solver.solve(path(to), rest, progress, options);
  }
  Points linear_answer(const std::vector<RigidMotion>& to) const {
    return linear.solve(path(to)(1), rest).displacements;
  }
  /// ‖Qᵀ f_int‖ over the reactions, from the public parts.
  double residual(const Points& u) const {
    Points force;
    EXPECT_TRUE(solver.tissue().internal_force(u, force));
    const double free = linear.free_part().gather(force).norm();
    return free / std::sqrt(force.squaredNorm() - free * free);
  }
};

NeoHookeanOptions exact(bool frozen_factor = true) {
  NeoHookeanOptions options;
  options.tolerance = 1e-11;
  options.frozen_factor = frozen_factor;
  return options;
}

TEST(NeoHookeanSolver, LinearAnswerIsOffBySecondOrderAndCorrectedOneByThird) {
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
    Scene scene(held_patch(), order);
    std::vector<double> linear, corrected;
    for (const double mm : {0.4, 0.2, 0.1}) {
      RigidMotion motion;
      motion.translation << 0.3 * mm, -mm, 0.5 * mm;
      const Points u = scene.solve({motion}, exact()).displacements;
      const Points first = scene.linear_answer({motion});
      linear.push_back((u - first).norm());
      corrected.push_back((u - first - second_order_correction(scene.linear, first)).norm());
    }
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(std::log2(linear[k] / linear[k + 1]), 2, 0.1);
      EXPECT_NEAR(std::log2(corrected[k] / corrected[k + 1]), 3, 0.2);
    }
  }
}

TEST(NeoHookeanSolver, NewtonConvergesQuadratically) {
  Scene scene(held_patch());
  const Points answer =
      scene.solve({turned(8, {1, 0, 0}, {20, 20, 0}, {0, 1, 3})}, exact()).displacements;
  const FreePart& free = scene.linear.free_part();
  StiffnessMatrix K = scene.linear.stiffness();
  Points u = answer;
  free.add(Eigen::VectorXd(Eigen::VectorXd::LinSpaced(free.size(), -0.01, 0.01)), 1, u);
  std::vector<double> errors;
  for (int k = 0; k < 4; ++k) {
    errors.push_back((u - answer).norm());
    scene.solver.tissue().tangent(u, false, K);
    const SpdFactor factor(free_stiffness(K, free), scene.linear.order());
    Points force;
    ASSERT_TRUE(scene.solver.tissue().internal_force(u, force));
    free.add(Eigen::VectorXd(factor.solve(free.gather(force))), -1, u);
  }
  EXPECT_LT(errors[1], 0.5 * errors[0]);
  const double first = std::log(errors[2] / errors[1]) / std::log(errors[1] / errors[0]);
  EXPECT_GT(first, 1.7) << errors[0] << " " << errors[1] << " " << errors[2];
  EXPECT_LT(errors[3], 1e-7 * errors[0]);
}

TEST(NeoHookeanSolver, FrozenFactorAndNewtonAgree) {
  const HeldPatch patch = sliding_patch();
  std::vector<unsigned char> kinds;
  for (Eigen::Index t = 0; t < patch.tissue.mesh.tets.rows(); ++t) kinds.push_back(t % 2 == 0);
  const TissueMaterials several({{1, 0.46}, {4, 0.49}}, kinds);
  const std::vector<RigidMotion> motions{turned(4, {1, 1, 0}, {20, 20, 0}, {0, 0, 2}),
                                         turned(-3, {0, 1, 0}, {25, 20, 0}, {0, 0.5, 3})};
  for (const ElementOrder order : {ElementOrder::linear, ElementOrder::quadratic}) {
    Scene scene(patch, order, several);
    const NeoHookeanSolution a = scene.solve(motions, exact()),
                             b = scene.solve(motions, exact(false));
    EXPECT_GT(a.anderson_iterations, 0);
    EXPECT_EQ(b.anderson_iterations, 0);
    EXPECT_GT(b.newton_iterations, 1);
    EXPECT_LT((a.displacements - b.displacements).cwiseAbs().maxCoeff(),
              1e-8 * b.displacements.cwiseAbs().maxCoeff());
    EXPECT_LT(scene.residual(a.displacements), 2e-11);
    EXPECT_GT((a.displacements - scene.linear_answer(motions)).cwiseAbs().maxCoeff(), 0.05);
    // What is prescribed is met exactly, sliding nodes' normal component among it.
    const Supports& supports = scene.linear.supports();
    EXPECT_LT((prescribed_part(supports, a.displacements) -
               prescribed_part(supports, scene.path(motions)(1)))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
  }
}

TEST(NeoHookeanSolver, SoftAndStiffPartsMoveUnlikeOneMaterial) {
  const HeldPatch patch = held_patch();
  std::vector<unsigned char> kinds;
  const Points& x = patch.tissue.mesh.vertices;
  for (const auto tet : patch.tissue.mesh.tets.rowwise()) kinds.push_back(x(tet[0], 0) < 20);
  RigidMotion motion;
  motion.translation << 0, 2, 3;
  Scene one(patch),
      same(patch, ElementOrder::linear, TissueMaterials({{1, 0.46}, {1, 0.46}}, kinds)),
      other(patch, ElementOrder::linear, TissueMaterials({{1, 0.46}, {20, 0.46}}, kinds));
  const Points u = one.solve({motion}).displacements;
  EXPECT_EQ((u - same.solve({motion}).displacements).norm(), 0);
  EXPECT_GT((u - other.solve({motion}).displacements).cwiseAbs().maxCoeff(), 0.01);
}

TEST(NeoHookeanSolver, EverythingTurnedRigidlyStaysUnstrained) {
  HeldPatch patch = held_patch();
  for (Support& s : patch.supports) s = s == Support::fixed ? Support::attached : s;
  Scene scene(patch);
  const Points& x = scene.linear.elements().nodes;
  for (const double degrees : {0.0, 30.0, 90.0, 180.0}) {
    const RigidMotion motion = turned(degrees, {1, 2, 3}, {20, 20, 0}, {5, -3, 8});
    const NeoHookeanSolution solution = scene.solve({motion});
    EXPECT_LT((solution.displacements - (moved(x, motion) - x)).cwiseAbs().maxCoeff(), 1e-5)
        << degrees;
    EXPECT_NEAR(solution.most_compressed.volume_ratio, 1, 1e-6);
  }
}

TEST(NeoHookeanSolver, ContinuesFromAnEarlierPose) {
  const HeldPatch patch = sliding_patch();
  Scene scene(patch);
  const std::vector<RigidMotion> first{turned(5, {1, 0, 0}, {20, 20, 0}, {0, 0, 3}),
                                       turned(5, {1, 0, 0}, {20, 20, 0}, {0, 0, 3})};
  const std::vector<RigidMotion> second{turned(7, {1, 0.2, 0}, {20, 20, 0}, {0, 1, 4}),
                                        turned(6, {1, 0, 0}, {20, 20, 0}, {0, 1, 4})};
  const NeoHookeanSolution at_first = scene.solve(first, exact());
  const MotionPath onward =
      bone_path(scene.linear.elements().nodes, scene.linear.supports(), first, second);
  const NeoHookeanSolution continued =
      scene.solver.solve(onward, at_first.displacements, scene.progress, exact());
  const NeoHookeanSolution direct = scene.solve(second, exact());
  EXPECT_LT((continued.displacements - direct.displacements).cwiseAbs().maxCoeff(),
            1e-8 * direct.displacements.cwiseAbs().maxCoeff());
  // Staying where one is takes no iteration.
  const NeoHookeanSolution stays = scene.solver.solve(
      [&](double) { return scene.path(second)(1); }, direct.displacements, scene.progress, exact());
  EXPECT_EQ(stays.anderson_iterations + stays.newton_iterations, 0);
  EXPECT_LT((stays.displacements - direct.displacements).norm(), 1e-12);
}

TEST(NeoHookeanSolver, NoMotionIsAnsweredByNone) {
  Scene scene(held_patch());
  const NeoHookeanSolution solution = scene.solve({RigidMotion{}});
  EXPECT_EQ(solution.displacements.norm(), 0);
  EXPECT_EQ(solution.relative_residual, 0);
}

TEST(NeoHookeanSolver, TinyMotionsAreLinear) {
  Scene scene(held_patch());
  RigidMotion motion;
  motion.translation << 0, 1e-9, 5e-10;
  const Points linear = scene.linear_answer({motion});
  EXPECT_LT((scene.solve({motion}).displacements - linear).norm(), 1e-7 * linear.norm());
}

bench::ChinProblem p1() {
  return bench::chin_problem(testing::patch_p1());
}

TEST(NeoHookeanSolver, ReachesLargeMotionsFromRest) {
  const bench::ChinProblem chin = p1();
  Scene scene(ElementMesh(chin.tissue.mesh), chin.supports, {});
  for (const RigidMotion& motion : {turned(0, {1, 0, 0}, chin.centre, {0, 0, 20}),
                                    turned(0, {1, 0, 0}, chin.centre, {0, -10, 0}),
                                    turned(30, {1, 0, 0}, chin.centre, {0, 0, 0}),
                                    turned(30, {1, 0, 0}, chin.centre, {0, 0, 20})}) {
    const NeoHookeanSolution solution = scene.solve({motion});
    EXPECT_LT(scene.residual(solution.displacements), 1.01e-6);
    EXPECT_GT(solution.most_compressed.volume_ratio, 0.05);
    // An equilibrium that holds: its energy is below that of the linear answer.
    EXPECT_LT(scene.solver.tissue().energy(solution.displacements),
              scene.solver.tissue().energy(scene.linear_answer({motion})));
  }
}

TEST(NeoHookeanSolver, AnswersOrRefusesWhatNoFaceEverDid) {
  Scene scene(held_patch());
  for (const RigidMotion& motion : {turned(0, {1, 0, 0}, {20, 20, 0}, {0, 0, 60}),
                                    turned(90, {1, 0, 0}, {20, 20, 0}, {0, 0, 0}),
                                    turned(180, {1, 0, 0}, {20, 20, 0}, {0, 0, 0})}) {
    try {
      const NeoHookeanSolution solution = scene.solve({motion});
      EXPECT_LE(solution.newton_iterations, NeoHookeanOptions{}.newton_limit);
      EXPECT_LT(scene.residual(solution.displacements), 1.01e-6);
      EXPECT_GT(solution.most_compressed.volume_ratio, 0);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::numeric);
      EXPECT_NE(std::string(error.what()).find("the tissue could follow only"), std::string::npos);
    }
  }
}

/// A box on the floor with a bone on its top.
Scene pressed_box() {
  const TetMesh mesh = testing::tet_box({10, 10, 4}, {3, 3, 2});
  Supports supports(static_cast<std::size_t>(mesh.vertices.rows()), Support::free);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    if (mesh.vertices(i, 2) < 1e-9) supports[i] = Support::fixed;
    if (mesh.vertices(i, 2) > 4 - 1e-9) supports[i] = Support::attached;
  }
  return Scene(ElementMesh(mesh), supports, {});
}

TEST(NeoHookeanSolver, RefusesToPressABoneThroughAnother) {
  Scene scene = pressed_box();
  RigidMotion motion;
  motion.translation << 0, 0, -5;
  test::expect_error(ErrorKind::numeric,
                     {"large motion", "the tissue could follow only", "% of the motion", "tet ",
                      "near (", "move the bone less"},
                     [&] { scene.solve({motion}); });
}

TEST(NeoHookeanSolver, RefusesAStartThatIsInsideOutOrNotFinite) {
  Scene scene = pressed_box();
  RigidMotion motion;
  Points start = scene.rest;
  start.col(2) = -2 * scene.linear.elements().nodes.col(2);
  test::expect_error(ErrorKind::numeric, {"turned inside out at the start"},
                     [&] { scene.solver.solve(scene.path({motion}), start, scene.progress); });
  motion.translation << 0, std::nan(""), 0;
  test::expect_error(ErrorKind::numeric, {"not finite"}, [&] { scene.solve({motion}); });
}

TEST(NeoHookeanSolver, CanBeCancelledWhileItWorks) {
  Scene scene(held_patch());
  RigidMotion motion;
  motion.translation << 0, 0, 10;
  const MotionPath path = scene.path({motion});
  const MotionPath cancelling = [&](double t) {
    if (t > 0) scene.progress.cancel();
    return path(t);
  };
  test::expect_error(ErrorKind::cancelled, {},
                     [&] { scene.solver.solve(cancelling, scene.rest, scene.progress); });
}

TEST(LinearisationError, IsTheTrueOneToAQuarterWhereLinearIsOfferedAtAll) {
  const bench::ChinProblem chin = p1();
  Scene scene(ElementMesh(chin.tissue.mesh), chin.supports, {});
  for (const RigidMotion& motion :
       {turned(0, {1, 0, 0}, chin.centre, {0, 0, 1}), turned(0, {1, 0, 0}, chin.centre, {0, 0, 5}),
        turned(0, {1, 0, 0}, chin.centre, {0, 0, 10}),
        turned(0, {1, 0, 0}, chin.centre, {0, -5, 0}), turned(5, {1, 0, 0}, chin.centre, {0, 0, 0}),
        turned(10, {1, 0, 0}, chin.centre, {0, 0, 0})}) {
    const Points linear = scene.linear_answer({motion});
    const Eigen::Index n = chin.tissue.surface_count;
    const Eigen::VectorXd estimate = linearisation_error(scene.linear, linear).head(n);
    const Eigen::VectorXd truth =
        (scene.solve({motion}).displacements - linear).topRows(n).rowwise().norm();
    EXPECT_GT(estimate.mean() / truth.mean(), 0.9);
    EXPECT_LT(estimate.mean() / truth.mean(), 1.25);
  }
}

TEST(LinearisationError, IsExactlyQuadraticEvenWhereTheLinearAnswerIsInsideOut) {
  Scene scene(held_patch());
  RigidMotion motion;
  motion.translation << 0, -1, 0;
  const Points u = scene.linear_answer({motion});
  const Eigen::VectorXd one = linearisation_error(scene.linear, u);
  ASSERT_LT(scene.solver.tissue().most_compressed(60 * u).volume_ratio, 0);
  EXPECT_LT((linearisation_error(scene.linear, 60 * u) - 3600 * one).norm(),
            1e-6 * 3600 * one.norm());
  EXPECT_EQ(linearisation_error(scene.linear, scene.rest).norm(), 0);
  test::expect_error(ErrorKind::numeric, {"not finite"},
                     [&] { linearisation_error(scene.linear, u * std::nan("")); });
}

TEST(MotionPath, ScrewsTurnAboutOneAxisAtConstantSpeed) {
  const RigidMotion from = turned(20, {0, 1, 1}, {3, 2, 1}, {1, 0, 0});
  const Eigen::Vector3d x(5, -2, 3);
  for (const double degrees : {0.0, 1e-9, 40.0, 179.0, 180.0}) {
    const RigidMotion to = turned(degrees, {1, 2, 0}, {10, 5, -3}, {0.5, 1, 4});
    EXPECT_LT((on_screw(from, to, 0)(x) - from(x)).norm(), 1e-12);
    EXPECT_LT((on_screw(from, to, 1)(x) - to(x)).norm(), 1e-12);
    const double whole = (on_screw(from, to, 0.75)(x) - on_screw(from, to, 0.5)(x)).norm();
    for (const double t : {0.0, 0.25, 0.5}) {
      const RigidMotion motion = on_screw(from, to, t);
      EXPECT_LT(
          (motion.rotation.transpose() * motion.rotation - Eigen::Matrix3d::Identity()).norm(),
          1e-12);
      EXPECT_NEAR((on_screw(from, to, t + 0.25)(x) - motion(x)).norm(), whole, 1e-11);
    }
  }
  // A pure turn keeps the distance from its axis, where a straight line would cross it.
  const RigidMotion half = on_screw({}, turned(180, {0, 0, 1}, {4, 4, 0}, {0, 0, 0}), 0.5);
  EXPECT_NEAR((half(Eigen::Vector3d(7, 4, 0)) - Eigen::Vector3d(4, 4, 0)).norm(), 3, 1e-12);
}

TEST(AndersonAcceleration, SolvesALinearSystemInAsManyStepsAsItHasUnknowns) {
  constexpr int n = 6;
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(n, n) * 3;
  for (int i = 0; i + 1 < n; ++i) A(i, i + 1) = A(i + 1, i) = -1.2 - 0.1 * i;
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n, -1, 2);
  AndersonAcceleration acceleration(n, 10);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  for (int k = 0; k < n + 1; ++k) x = acceleration.next(x, b - A * x);
  EXPECT_LT((b - A * x).norm(), 1e-8 * b.norm());
  // The plain iteration diverges.
  x.setZero();
  for (int k = 0; k < n + 1; ++k) x += b - A * x;
  EXPECT_GT((b - A * x).norm(), 10 * b.norm());
}

}  // namespace
}  // namespace gnathion
