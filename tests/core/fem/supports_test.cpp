#include "fem/supports.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fem/static_solver.h"
#include "support/fields.h"
#include "support/sliding_patch.h"
#include "support/tet_solids.h"

namespace gnathion {
namespace {

using namespace testing;

const Eigen::Vector3d kSize(12, 6, 3);

class SlidingOrders : public ::testing::TestWithParam<ElementOrder> {};
INSTANTIATE_TEST_SUITE_P(Both, SlidingOrders,
                         ::testing::Values(ElementOrder::linear, ElementOrder::quadratic),
                         [](const auto& order) {
                           return order.param == ElementOrder::linear ? "linear" : "quadratic";
                         });

/// A turned frame, so that no normal lies along an axis.
Eigen::Matrix3d turned() {
  return Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
}

/// A distorted plate in the turned frame.
ElementMesh plate(ElementOrder order) {
  const std::array<int, 3> n{4, 2, 2};
  TetMesh mesh = tet_box(kSize, n);
  distort_box(mesh, kSize, n, 0.25, 3);
  mesh.vertices = (mesh.vertices * turned().transpose()).eval();
  return {mesh, order};
}

/// The height of each node above the plate's lower face, mm.
Eigen::VectorXd height(const ElementMesh& mesh) {
  return mesh.nodes * turned().col(2);
}

TEST_P(SlidingOrders, APlateStretchedOverAPlaneThinsAsInClosedForm) {
  // Pulled at both ends: u = (εx, −νεy, −νεz). Its lower face slides over the skull.
  const ElementMesh mesh = plate(GetParam());
  const double poisson = 0.46, stretch = 0.1;
  const Eigen::Matrix3d gradient =
      turned() * Eigen::Vector3d(stretch, -poisson * stretch, -poisson * stretch).asDiagonal() *
      turned().transpose();
  const Points exact = mesh.nodes * gradient.transpose();
  const Eigen::VectorXd z = height(mesh), x = mesh.nodes * turned().col(0);
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  int sliding = 0;
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    if (z[i] < 1e-9) supports[i] = Support::slides(turned().col(2), Support::kUnmoved);
    if (x[i] < 1e-9 || x[i] > kSize[0] - 1e-9) supports[i] = Support::attached;
    sliding += supports[i] == Support::sliding;
  }
  ASSERT_GT(sliding, 8);
  Progress progress;
  const StaticSolver solver(mesh, ElasticMaterial{1, poisson}, supports, progress);
  Points prescribed = exact;
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    if (supports[i] == Support::sliding) prescribed.row(i).setZero();
  }
  const Points u = solver.solve(prescribed, Points::Zero(exact.rows(), 3)).displacements;
  EXPECT_LT((u - exact).cwiseAbs().maxCoeff(), 1e-12 * exact.cwiseAbs().maxCoeff());
}

TEST_P(SlidingOrders, APlatePressedBetweenTwoBonesSpreadsWhateverTheirMotionAlongIt) {
  // The upper bone comes nearer by d and slides 50 mm along: ε_z = −d/t, and as nothing holds the
  // sides ε_x = ε_y = −ν ε_z.
  const ElementMesh mesh = plate(GetParam());
  const double poisson = 0.4, pressed = 0.3, strain = -pressed / kSize[2];
  const Eigen::Matrix3d gradient =
      turned() * Eigen::Vector3d(-poisson * strain, -poisson * strain, strain).asDiagonal() *
      turned().transpose();
  const Points exact = mesh.nodes * gradient.transpose();
  const Eigen::VectorXd z = height(mesh);
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    if (z[i] < 1e-9) supports[i] = Support::slides(-turned().col(2), Support::kUnmoved);
    if (z[i] > kSize[2] - 1e-9) supports[i] = Support::slides(turned().col(2), 0);
  }
  // Two nodes held where they must come to anyway, so that the plate does not drift.
  const auto corner = [&](const Eigen::Vector3d& at) {
    Eigen::Index node = 0;
    (mesh.nodes.rowwise() - (turned() * at).transpose()).rowwise().norm().minCoeff(&node);
    return node;
  };
  const std::array<Eigen::Index, 2> held{corner({0, 0, 0}), corner({kSize[0], 0, 0})};
  for (const Eigen::Index node : held) supports[node] = Support::attached;
  RigidMotion motion;
  motion.translation = turned() * Eigen::Vector3d(50, -20, -pressed);
  Points prescribed = bone_displacements(mesh.nodes, supports, {&motion, 1});
  for (const Eigen::Index node : held) prescribed.row(node) = exact.row(node);
  Progress progress;
  const StaticSolver solver(mesh, ElasticMaterial{1, poisson}, supports, progress);
  const Points u = solver.solve(prescribed, Points::Zero(exact.rows(), 3)).displacements;
  EXPECT_LT((u - exact).cwiseAbs().maxCoeff(), 1e-11 * exact.cwiseAbs().maxCoeff());
  const Points forces = solver.stiffness() * u;
  for (const Eigen::Index node : held) {
    EXPECT_LT((forces.row(node) * turned().leftCols<2>()).norm(), 1e-11 * forces.norm());
  }
}

TEST_P(SlidingOrders, SlidingEqualsAttachedWhereNothingWouldSlide) {
  // At ν = 0 a column pressed along its axis does not widen.
  const ElementMesh mesh = plate(GetParam());
  const Eigen::VectorXd z = height(mesh);
  RigidMotion motion;
  motion.translation = -0.3 * turned().col(2);
  Progress progress;
  std::vector<Points> results;
  for (const bool slides : {false, true}) {
    Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
    for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
      if (z[i] < 1e-9) supports[i] = Support::fixed;
      if (z[i] > kSize[2] - 1e-9) {
        supports[i] = slides ? Support::slides(turned().col(2), 0) : Support(Support::attached, 0);
      }
    }
    const StaticSolver solver(mesh, ElasticMaterial{1, 0}, supports, progress);
    results.push_back(solver
                          .solve(bone_displacements(mesh.nodes, supports, {&motion, 1}),
                                 Points::Zero(mesh.nodes.rows(), 3))
                          .displacements);
  }
  EXPECT_LT((results[0] - results[1]).norm(), 1e-12 * results[0].norm());
}

TEST_P(SlidingOrders, ASlidingNodeFollowsAlongItsNormalAndFeelsNoTractionAlongTheBone) {
  const HeldPatch patch = sliding_patch();
  const ElementMesh mesh(patch.tissue.mesh, GetParam());
  const Supports supports = supports_of_nodes(mesh, patch.supports);
  std::array<RigidMotion, 2> motions;
  motions[0].translation << 1, -3, 2;
  motions[1].rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
  motions[1].translation << 0, 2, -1;
  Progress progress;
  const StaticSolver solver(mesh, {}, supports, progress);
  const Points bone = bone_displacements(mesh.nodes, supports, motions);
  const Points u = solver.solve(bone, Points::Zero(bone.rows(), 3)).displacements;
  const Points forces = solver.stiffness() * u;
  const double largest = forces.rowwise().norm().maxCoeff();
  int sliding = 0;
  double slip = 0;
  for (Eigen::Index i = 0; i < u.rows(); ++i) {
    if (!(supports[i] == Support::sliding)) continue;
    ++sliding;
    const Eigen::Vector3d normal = supports[i].normal;
    EXPECT_NEAR((u.row(i) - bone.row(i)).dot(normal), 0, 1e-13);
    const Eigen::Vector3d along = forces.row(i).transpose() - forces.row(i).dot(normal) * normal;
    EXPECT_LT(along.norm(), 1e-12 * largest);
    slip = std::max(slip, (u.row(i) - bone.row(i)).norm());
  }
  EXPECT_GT(sliding, 40);
  EXPECT_GT(slip, 0.5) << "nothing slides, so nothing is tested";
}

TEST(Supports, AMiddleIsHeldAsBothItsEndsAre) {
  const Support free, fixed(Support::fixed), on0(Support::attached, 0), on1(Support::attached, 1);
  const Eigen::Vector3d n = Eigen::Vector3d(1, 2, 3).normalized();
  const Eigen::Vector3d m = Eigen::Vector3d(1, -2, 3).normalized();
  const Support slides0 = Support::slides(n, 0), slides1 = Support::slides(n, 1),
                slides_skull = Support::slides(n, Support::kUnmoved);
  for (const Support& other : {free, fixed, on0, slides0}) {
    EXPECT_TRUE(between(free, other) == Support::free);
    EXPECT_TRUE(between(other, free) == Support::free);
  }
  EXPECT_TRUE(between(fixed, fixed) == Support::fixed);
  EXPECT_TRUE(between(on0, on0) == Support::attached);
  EXPECT_TRUE(between(on0, on1) == Support::free);
  EXPECT_TRUE(between(fixed, on0) == Support::free);
  EXPECT_TRUE(between(slides0, slides1) == Support::free);
  EXPECT_TRUE(between(fixed, slides0) == Support::free);
  EXPECT_TRUE(between(fixed, slides_skull) == Support::sliding);
  const Support half = between(on0, slides0);
  EXPECT_TRUE(half == Support::sliding);
  EXPECT_EQ(half.body, 0);
  EXPECT_EQ(half.normal, n);
  // The mean direction, however the normals point.
  for (const double sign : {1.0, -1.0}) {
    const Support mean = between(slides0, Support::slides(sign * m, 0));
    EXPECT_NEAR(std::abs(mean.normal.dot((n + m).normalized())), 1, 1e-15);
  }
}

TEST(FreePart, GatherAndAddAreTransposesAndItsColumnsAreOrthonormal) {
  const Eigen::Vector3d n = Eigen::Vector3d(1, 2, 3).normalized();
  const FreePart free(
      {Support{}, Support(Support::fixed), Support::slides(n, 0), Support(Support::attached, 0)});
  ASSERT_EQ(free.size(), 5);
  Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(12, 5);
  free.add(Eigen::MatrixXd::Identity(5, 5), Q);
  EXPECT_LT((Q.transpose() * Q - Eigen::MatrixXd::Identity(5, 5)).norm(), 1e-15);
  EXPECT_LT((Q.middleRows<3>(6).transpose() * n).norm(), 1e-15);
  EXPECT_EQ(free.gather(Eigen::MatrixXd(Eigen::MatrixXd::Identity(12, 12))), Q.transpose());
}

}  // namespace
}  // namespace gnathion
