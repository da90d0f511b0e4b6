#include "fem/static_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <future>

#include "base/error.h"
#include "fem/response_basis.h"
#include "support/held_patch.h"

namespace gnathion {
namespace {

using testing::attached_displacements;
using testing::held_patch;
using testing::HeldPatch;

RigidMotion some_motion(const Eigen::Vector3d& about) {
  RigidMotion motion;
  motion.rotation =
      Eigen::AngleAxisd(0.15, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  motion.translation = about - motion.rotation * about + Eigen::Vector3d(1, -5, 2);
  return motion;
}

TEST(StaticSolver, PatchTestALinearFieldIsExact) {
  HeldPatch patch = held_patch();
  const Points& x = patch.tissue.mesh.vertices;
  // A linear displacement field given on the hull of the mesh must come out inside: the free nodes
  // are those whose tets surround them; here we hold all nodes but some surface ones would bear
  // traction, so the field's own traction is applied as K u.
  Eigen::Matrix3d gradient;
  gradient << 0.01, 0.02, -0.005, 0, -0.01, 0.03, 0.015, 0.002, 0.02;
  const Points exact = x * gradient.transpose();
  Progress progress;
  for (Support& s : patch.supports) s = s == Support::fixed ? Support::attached : s;
  const StaticSolver solver(patch.tissue.mesh, ElasticMaterial{1, 0.46}, patch.supports, progress);
  const StaticSolution solution = solver.solve(exact, solver.stiffness() * exact);
  EXPECT_LT((solution.displacements - exact).cwiseAbs().maxCoeff(),
            1e-12 * x.cwiseAbs().maxCoeff());
  EXPECT_LT(solution.relative_residual, 1e-12);
}

TEST(StaticSolver, ARigidMotionOfAllSupportsStrainsNothing) {
  HeldPatch patch = held_patch();
  for (Support& s : patch.supports) s = s == Support::fixed ? Support::attached : s;
  RigidMotion shift;
  shift.translation << 3, -2, 8;
  Progress progress;
  const StaticSolver solver(patch.tissue.mesh, {}, patch.supports, progress);
  const Points u = solver
                       .solve(attached_displacements(patch, shift),
                              Points::Zero(patch.tissue.mesh.vertices.rows(), 3))
                       .displacements;
  EXPECT_LT((u.rowwise() - shift.translation.transpose()).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(StaticSolver, YoungsModulusDropsOutUnderPrescribedMotion) {
  const HeldPatch patch = held_patch();
  const Points given = attached_displacements(patch, some_motion({20, 20, 0}));
  const Points none = Points::Zero(given.rows(), 3);
  Progress progress;
  const Points soft =
      StaticSolver(patch.tissue.mesh, ElasticMaterial{0.01, 0.46}, patch.supports, progress)
          .solve(given, none)
          .displacements;
  const Points stiff =
      StaticSolver(patch.tissue.mesh, ElasticMaterial{300, 0.46}, patch.supports, progress)
          .solve(given, none)
          .displacements;
  EXPECT_LT((soft - stiff).norm(), 1e-11 * soft.norm());
}

TEST(StaticSolver, CholmodAndEigenAgree) {
  if (default_spd_backend() != SpdBackend::cholmod) GTEST_SKIP() << "built without CHOLMOD";
  const HeldPatch patch = held_patch();
  const Points given = attached_displacements(patch, some_motion({20, 20, 0}));
  const Points none = Points::Zero(given.rows(), 3);
  Progress progress;
  const Points a =
      StaticSolver(patch.tissue.mesh, {}, patch.supports, progress, SpdBackend::cholmod)
          .solve(given, none)
          .displacements;
  const Points b = StaticSolver(patch.tissue.mesh, {}, patch.supports, progress, SpdBackend::eigen)
                       .solve(given, none)
                       .displacements;
  EXPECT_LT((a - b).norm(), 1e-11 * a.norm());
}

TEST(StaticSolver, RefusesAnInvertedTet) {
  HeldPatch patch = held_patch();
  std::swap(patch.tissue.mesh.tets(7, 0), patch.tissue.mesh.tets(7, 1));
  Progress progress;
  try {
    const StaticSolver solver(patch.tissue.mesh, {}, patch.supports, progress);
    FAIL() << "an inverted tet was accepted";
  } catch (const Error& error) {
    EXPECT_NE(error.problem().find("tet 7 is inverted"), std::string::npos);
  }
}

TEST(StaticSolver, RefusesAMeshThatNothingHolds) {
  HeldPatch patch = held_patch();
  patch.supports.assign(patch.supports.size(), Support::free);
  Progress progress;
  EXPECT_THROW(StaticSolver(patch.tissue.mesh, {}, patch.supports, progress), Error);
}

TEST(StaticSolver, RefusesMaterialsOutOfRange) {
  const HeldPatch patch = held_patch();
  Progress progress;
  for (const ElasticMaterial& bad :
       {ElasticMaterial{0, 0.46}, ElasticMaterial{-1, 0.46}, ElasticMaterial{1, 0.5},
        ElasticMaterial{1, -0.1}, ElasticMaterial{std::nan(""), 0.4}}) {
    EXPECT_THROW(StaticSolver(patch.tissue.mesh, bad, patch.supports, progress), Error);
  }
}

TEST(SpdFactor, EitherBackendRefusesAnIndefiniteOrBrokenMatrix) {
  Eigen::SparseMatrix<double> lower(2, 2);
  lower.insert(0, 0) = 1;
  lower.insert(1, 0) = 2;  // eigenvalues 3 and −1
  lower.insert(1, 1) = 1;
  lower.makeCompressed();
  Eigen::SparseMatrix<double> broken = lower;
  broken.coeffRef(1, 0) = std::nan("");
  for (const SpdBackend backend : {default_spd_backend(), SpdBackend::eigen}) {
    EXPECT_THROW(SpdFactor(lower, {0, 1}, backend), Error);
    EXPECT_THROW(SpdFactor(broken, {0, 1}, backend), Error);
  }
}

TEST(StaticSolver, AnswersSeveralThreadsAtOnce) {
  const HeldPatch patch = held_patch();
  const Points given = attached_displacements(patch, some_motion({20, 20, 0}));
  const Points none = Points::Zero(given.rows(), 3);
  Progress progress;
  const StaticSolver solver(patch.tissue.mesh, {}, patch.supports, progress);
  const Points alone = solver.solve(given, none).displacements;
  std::vector<std::future<bool>> threads;
  for (int t = 0; t < 4; ++t) {
    threads.push_back(std::async(std::launch::async, [&] {
      bool same = true;
      for (int k = 0; k < 20; ++k) same = same && solver.solve(given, none).displacements == alone;
      return same;
    }));
  }
  for (auto& thread : threads) EXPECT_TRUE(thread.get());
}

TEST(ResponseBasis, EqualsTheDirectSolve) {
  const HeldPatch patch = held_patch();
  const Points& x = patch.tissue.mesh.vertices;
  const Eigen::Vector3d centre(22, 25, -3);
  Progress progress;
  const StaticSolver solver(patch.tissue.mesh, {}, patch.supports, progress);
  const ResponseBasis basis = response_basis(solver, {centre});
  const RigidMotion motion = some_motion(centre);
  const Points direct =
      solver.solve(attached_displacements(patch, motion), Points::Zero(x.rows(), 3)).displacements;
  Points fast;
  basis.displacements({&motion, 1}, fast);
  EXPECT_LT((fast - direct).norm(), 1e-12 * direct.norm());
  basis.displacements(std::array{RigidMotion{}}, fast);
  EXPECT_EQ(fast.cwiseAbs().maxCoeff(), 0);
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
