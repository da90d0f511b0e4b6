#include "fem/static_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <future>

#include "base/error.h"
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

}  // namespace
}  // namespace gnathion
