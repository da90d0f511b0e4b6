#include "fem/response_basis.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "support/sliding_patch.h"

namespace gnathion {
namespace {

using namespace testing;

RigidMotion random_pose(std::mt19937& random, const Eigen::Vector3d& about) {
  const auto uniform = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  RigidMotion motion;
  motion.rotation = Eigen::AngleAxisd(0.6 * uniform(),
                                      Eigen::Vector3d(uniform(), uniform(), uniform()).normalized())
                        .toRotationMatrix();
  const Eigen::Vector3d shift(10 * uniform(), 10 * uniform(), 10 * uniform());
  motion.translation = about - motion.rotation * about + shift;
  return motion;
}

class BasisOrders : public ::testing::TestWithParam<ElementOrder> {};
INSTANTIATE_TEST_SUITE_P(Both, BasisOrders,
                         ::testing::Values(ElementOrder::linear, ElementOrder::quadratic),
                         [](const auto& order) {
                           return order.param == ElementOrder::linear ? "linear" : "quadratic";
                         });

TEST_P(BasisOrders, EqualsTheDirectSolveForRandomPosesOfTwoSegmentsThatTissueSlidesOn) {
  const HeldPatch patch = sliding_patch();
  const ElementMesh mesh(patch.tissue.mesh, GetParam());
  const Supports supports = supports_of_nodes(mesh, patch.supports);
  const std::vector<Eigen::Vector3d> centres{{18, 25, -3}, {32, 26, -4}};
  Progress progress;
  const StaticSolver solver(mesh, {}, supports, progress);
  const ResponseBasis basis = response_basis(solver, centres);
  ASSERT_EQ(basis.columns().cols(), 24);
  std::mt19937 random(11);
  for (int k = 0; k < 10; ++k) {
    const std::array<RigidMotion, 2> motions{random_pose(random, centres[0]),
                                             random_pose(random, centres[1])};
    const Points direct = solver
                              .solve(bone_displacements(mesh.nodes, supports, motions),
                                     Points::Zero(mesh.nodes.rows(), 3))
                              .displacements;
    Points fast;
    basis.displacements(motions, fast);
    EXPECT_LT((fast - direct).norm(), 1e-12 * direct.norm());
  }
  Points still;
  basis.displacements(std::array<RigidMotion, 2>{}, still);
  EXPECT_EQ(still.cwiseAbs().maxCoeff(), 0);
}

TEST(ResponseBasis, OneSegmentMovesNothingOfTheOthersTissue) {
  const HeldPatch patch = sliding_patch();
  Progress progress;
  const StaticSolver solver(patch.tissue.mesh, {}, patch.supports, progress);
  const ResponseBasis basis = response_basis(solver, {{18, 25, -3}, {32, 26, -4}});
  std::array<RigidMotion, 2> motions;
  motions[0].translation << 3, -4, 5;
  Points u;
  basis.displacements(motions, u);
  for (std::size_t i = 0; i < patch.supports.size(); ++i) {
    const Support& support = patch.supports[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (support == Support::attached) {
      const Eigen::Vector3d expected =
          support.body == 0 ? motions[0].translation : Eigen::Vector3d(0, 0, 0);
      EXPECT_LT((u.row(row).transpose() - expected).norm(), 1e-13);
    } else if (support == Support::sliding && support.body == 1) {
      EXPECT_NEAR(u.row(row).dot(support.normal), 0, 1e-13);
    }
  }
}

TEST(ForceBasis, ForcedPointsFollowTheMotionOnAverageAndForcesFollowEquation4) {
  const HeldPatch patch = held_patch();
  const Points& x = patch.tissue.mesh.vertices;
  std::vector<int> forced;
  for (int v = 0; v < patch.tissue.surface_count; ++v) {
    if (patch.supports[patch.tissue.inner(v)] == Support::attached) forced.push_back(v);
  }
  Supports rim_only = patch.supports;
  for (Support& s : rim_only) s = s == Support::attached ? Support::free : s;
  Progress progress;
  const StaticSolver solver(patch.tissue.mesh, {}, rim_only, progress);
  Points normals(static_cast<Eigen::Index>(forced.size()), 3);
  for (std::size_t f = 0; f < forced.size(); ++f) {
    normals.row(static_cast<Eigen::Index>(f)) =
        Eigen::RowVector3d(0.1 * std::sin(double(f)), 0.2, 1).normalized();
  }
  const Eigen::Vector3d motion(1, -3, 6);
  const auto result = force_basis(solver, forced, normals).displacements(motion);
  double mean = 0;
  for (const int i : forced) mean += result.displacements.row(i).dot(motion.normalized());
  EXPECT_NEAR(mean / static_cast<double>(forced.size()), motion.norm(), 1e-10);
  // The same by eq. 4 directly: F_i = F cos θ_i.
  Points f = Points::Zero(x.rows(), 3);
  for (std::size_t k = 0; k < forced.size(); ++k) {
    const double cosine = normals.row(static_cast<Eigen::Index>(k)).dot(motion.normalized());
    f.row(forced[k]) = result.force_N * cosine * motion.normalized();
  }
  const Points direct = solver.solve(Points::Zero(x.rows(), 3), f).displacements;
  EXPECT_LT((direct - result.displacements).norm(), 1e-11 * direct.norm());
}

}  // namespace
}  // namespace gnathion
