#include "fem/quadratic_correction.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fem/response_basis.h"
#include "support/expect_error.h"
#include "support/held_patch.h"

namespace gnathion {
namespace {

using testing::held_patch;
using testing::HeldPatch;

/// A held patch on linear elements and on quadratic ones, factorised.
struct BothOrders {
  HeldPatch patch;
  Progress progress;
  StaticSolver linear, quadratic;

  explicit BothOrders(const HeldPatch& held, double poisson = 0.46)
      : patch(held),
        linear(patch.tissue.mesh, ElasticMaterial{1, poisson}, patch.supports, progress),
        quadratic(on_quadratic(patch, poisson, progress)) {}

  static StaticSolver on_quadratic(const HeldPatch& held, double poisson, Progress& progress) {
    const ElementMesh mesh(held.tissue.mesh, ElementOrder::quadratic);
    return {mesh, ElasticMaterial{1, poisson}, supports_of_nodes(mesh, held.supports), progress};
  }

  Eigen::MatrixXd linear_basis() const { return response_basis(linear, {kCentre}).columns(); }
  /// Of the vertices.
  Eigen::MatrixXd quadratic_basis() const {
    return response_basis(quadratic, {kCentre})
        .columns()
        .topRows(3 * patch.tissue.mesh.vertices.rows());
  }
  inline static const Eigen::Vector3d kCentre{20, 20, 0};
};

HeldPatch sliding_patch() {
  HeldPatch patch = held_patch();
  int every_third = 0;
  for (Support& support : patch.supports) {
    if (support == Support::attached && ++every_third % 3 == 0) {
      support = Support::slides(Eigen::Vector3d(0.1, -0.2, 1).normalized(), 0);
    }
  }
  return patch;
}

TEST(QuadraticCorrection, ConvergesToTheDirectSolutionOnQuadraticElements) {
  for (const HeldPatch& patch : {held_patch(), sliding_patch()}) {
    BothOrders both(patch);
    const Eigen::MatrixXd linear = both.linear_basis(), quadratic = both.quadratic_basis();
    const Eigen::MatrixXd corrected =
        linear +
        QuadraticCorrection(both.linear, both.progress).correct(linear, both.progress, 400, 1e-9);
    EXPECT_LT((corrected - quadratic).norm(), 1e-6 * (quadratic - linear).norm());
  }
}

TEST(QuadraticCorrection, ItsEstimateIsOfTheSizeOfTheTruth) {
  BothOrders both(held_patch());
  const Eigen::MatrixXd linear = both.linear_basis();
  const Eigen::MatrixXd truth = both.quadratic_basis() - linear;
  const Eigen::MatrixXd estimate =
      QuadraticCorrection(both.linear, both.progress).correct(linear, both.progress);
  for (Eigen::Index column = 9; column < 12; ++column) {  // the translations
    EXPECT_GT(estimate.col(column).norm(), 0.6 * truth.col(column).norm());
    EXPECT_LT(estimate.col(column).norm(), 1.2 * truth.col(column).norm());
  }
}

TEST(QuadraticCorrection, OfNoMotionIsNone) {
  BothOrders both(held_patch());
  const Eigen::MatrixXd still =
      Eigen::MatrixXd::Zero(3 * both.patch.tissue.mesh.vertices.rows(), 2);
  EXPECT_EQ(QuadraticCorrection(both.linear, both.progress).correct(still, both.progress), still);
}

TEST(QuadraticCorrection, CanBeCancelled) {
  BothOrders both(held_patch());
  const Eigen::MatrixXd linear = both.linear_basis();
  const QuadraticCorrection correction(both.linear, both.progress);
  both.progress.cancel();
  test::expect_error(ErrorKind::cancelled, {}, [&] { correction.correct(linear, both.progress); });
}

}  // namespace
}  // namespace gnathion
