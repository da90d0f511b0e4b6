#include "fem/stiffness.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "fem/static_solver.h"
#include "support/fields.h"
#include "support/sliding_patch.h"
#include "support/tet_solids.h"

namespace gnathion {
namespace {

using namespace testing;

const Eigen::Vector3d kSize(10, 8, 6);

/// A box of tets of which no two are alike.
ElementMesh distorted_box(ElementOrder order, const std::array<int, 3>& n = {3, 3, 3}) {
  TetMesh mesh = tet_box(kSize, n);
  distort_box(mesh, kSize, n, 0.3, 7);
  return {mesh, order};
}

/// Nodes on the hull are attached, the others free.
Supports hull_attached(const ElementMesh& mesh) {
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (const auto& face : hull_faces(mesh)) {
    for (const int node : face) supports[node] = Support::attached;
  }
  return supports;
}

Points random_field(Eigen::Index n, unsigned seed) {
  std::mt19937 random(seed);
  Points u(n, 3);
  for (double& value : u.reshaped()) value = static_cast<double>(random()) / 2147483648.0 - 1;
  return u;
}

class Orders : public ::testing::TestWithParam<ElementOrder> {};
INSTANTIATE_TEST_SUITE_P(Both, Orders,
                         ::testing::Values(ElementOrder::linear, ElementOrder::quadratic),
                         [](const auto& order) {
                           return order.param == ElementOrder::linear ? "linear" : "quadratic";
                         });

TEST_P(Orders, StiffnessIsSymmetricWithExactlySixRigidModes) {
  const ElementMesh mesh = distorted_box(GetParam(), {2, 2, 2});
  for (const double poisson : {0.0, 0.46, 0.4999}) {
    const StiffnessMatrix K = stiffness_matrix(mesh, ElasticMaterial{1, poisson});
    const Eigen::Index n = mesh.nodes.rows();
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (int i = 0; i < n; ++i) {
      for (int p = K.start[i]; p < K.start[i + 1]; ++p) {
        dense.block<3, 3>(3 * i, 3 * K.column[p]) = K.blocks[p];
      }
    }
    EXPECT_LT((dense - dense.transpose()).norm(), 1e-14 * dense.norm());
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_LT(values.head<6>().cwiseAbs().maxCoeff(), 1e-12 * values[3 * n - 1]);
    // E times a length: a mode of no stiffness beyond the rigid ones would lie far below.
    EXPECT_GT(values[6], 0.02) << "Poisson's ratio " << poisson;
  }
}

TEST_P(Orders, ARigidMotionGivesNoForce) {
  const ElementMesh mesh = distorted_box(GetParam());
  const StiffnessMatrix K = stiffness_matrix(mesh, ElasticMaterial{1, 0.49});
  const Eigen::Vector3d turn(0.3, -0.2, 0.5), shift(1, -2, 3);
  const Points u = sampled(
      mesh.nodes, [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(turn.cross(x) + shift); });
  const double scale = (K * random_field(mesh.nodes.rows(), 1)).norm() * u.cwiseAbs().maxCoeff();
  EXPECT_LT((K * u).norm(), 1e-14 * scale);
}

TEST_P(Orders, PatchTestALinearFieldIsExactAndItsForcesAreTheStressesOnTheHull) {
  const ElementMesh mesh = distorted_box(GetParam());
  const ElasticMaterial material{2, 0.46};
  Eigen::Matrix3d gradient;
  gradient << 0.01, 0.02, -0.005, 0, -0.01, 0.03, 0.015, 0.002, 0.02;
  const Points exact =
      sampled(mesh.nodes, [&](const Eigen::Vector3d& x) { return Eigen::Vector3d(gradient * x); });
  Progress progress;
  const StaticSolver solver(mesh, material, hull_attached(mesh), progress);
  ASSERT_GT(solver.free_part().size(), 20);
  const Points u = solver.solve(exact, Points::Zero(exact.rows(), 3)).displacements;
  EXPECT_LT((u - exact).cwiseAbs().maxCoeff(), 1e-12 * exact.cwiseAbs().maxCoeff());

  const Eigen::Matrix3d strain = (gradient + gradient.transpose()) / 2;
  const Eigen::Matrix3d stress =
      2 * material.shear_modulus() * strain +
      material.lame_lambda() * strain.trace() * Eigen::Matrix3d::Identity();
  const Points tractions = traction_forces(
      mesh, [](const Eigen::Vector3d&) { return true; },
      [&](const Eigen::Vector3d&, const Eigen::Vector3d& normal) {
        return Eigen::Vector3d(stress * normal);
      });
  const Points forces = solver.stiffness() * u;
  for (Eigen::Index i = 0; i < u.rows(); ++i) {
    if (solver.supports()[i] == Support::free) {
      EXPECT_LT(forces.row(i).norm(), 1e-12 * tractions.norm());
    }
  }
  EXPECT_LT((forces - tractions).norm(), 1e-12 * tractions.norm());
}

TEST(Stiffness, QuadraticElementsReproduceAQuadraticFieldWhereTheVolumeMayChangeFreely) {
  // λ = 0: what is left is integrated in full. −μ (Δu + ∇ div u) = f.
  const ElementMesh mesh = distorted_box(ElementOrder::quadratic);
  const ElasticMaterial material{2, 0};
  const auto field = [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x[0] * x[0] - x[1] * x[2], 2 * x[0] * x[1] + x[2] * x[2],
                           x[0] * x[2] - 3 * x[1] * x[1]);
  };
  // Δu = (2, 2, −6), div u = 2x + 2x + x, so ∇ div u = (5, 0, 0).
  const Eigen::Vector3d body_force = -material.shear_modulus() * Eigen::Vector3d(7, 2, -6);
  const Points exact = sampled(mesh.nodes, field);
  Progress progress;
  const StaticSolver solver(mesh, material, hull_attached(mesh), progress);
  const Points u =
      solver.solve(exact, body_forces(mesh, [&](const Eigen::Vector3d&) { return body_force; }))
          .displacements;
  EXPECT_LT((u - exact).cwiseAbs().maxCoeff(), 1e-12 * exact.cwiseAbs().maxCoeff());
}

TEST_P(Orders, ForcesAreTheGradientOfTheEnergy) {
  const ElementMesh mesh = distorted_box(GetParam(), {2, 1, 2});
  std::vector<unsigned char> kinds(static_cast<std::size_t>(mesh.elements.rows()));
  for (std::size_t t = 0; t < kinds.size(); ++t) kinds[t] = t % 3 == 0;
  const TissueMaterials materials({{1, 0.3}, {5, 0.49}}, kinds);
  const StiffnessMatrix K = stiffness_matrix(mesh, materials);
  const Points u = random_field(mesh.nodes.rows(), 3);
  const Points forces = K * u;
  EXPECT_NEAR((u.array() * forces.array()).sum() / 2, strain_energy(mesh, materials, u),
              1e-12 * strain_energy(mesh, materials, u));
  // The energy is quadratic, so that central differences of any step are exact.
  for (Eigen::Index i = 0; i < u.rows(); i += 5) {
    for (int axis = 0; axis < 3; ++axis) {
      Points more = u, less = u;
      more(i, axis) += 0.5;
      less(i, axis) -= 0.5;
      EXPECT_NEAR(strain_energy(mesh, materials, more) - strain_energy(mesh, materials, less),
                  forces(i, axis), 1e-11 * forces.norm());
    }
  }
}

TEST_P(Orders, ReactionsBalanceAndTheWorkOfALoadIsTwiceTheEnergy) {
  const HeldPatch patch = sliding_patch();
  const ElementMesh mesh(patch.tissue.mesh, GetParam());
  const Supports supports = supports_of_nodes(mesh, patch.supports);
  const TissueMaterials materials(ElasticMaterial{0.5, 0.49});
  Progress progress;
  const StaticSolver solver(mesh, materials, supports, progress);
  const Points zero = Points::Zero(mesh.nodes.rows(), 3);
  std::array<RigidMotion, 2> motions;
  motions[0].translation << 1, -3, 2;
  motions[1].rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Points moved =
      solver.solve(bone_displacements(mesh.nodes, supports, motions), zero).displacements;
  const Points reactions = solver.stiffness() * moved;
  const double size = reactions.rowwise().norm().sum();
  EXPECT_LT(reactions.colwise().sum().norm(), 1e-12 * size);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < reactions.rows(); ++i) {
    moment += Eigen::Vector3d(mesh.nodes.row(i)).cross(Eigen::Vector3d(reactions.row(i)));
  }
  EXPECT_LT(moment.norm(), 1e-12 * size * mesh.nodes.cwiseAbs().maxCoeff());

  const Points load = body_forces(mesh, [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(1e-3 * x[1], 2e-3, -1e-3 * x[0]);
  });
  const Points u = solver.solve(zero, load).displacements;
  const double work = (u.array() * load.array()).sum();
  EXPECT_GT(work, 0);
  EXPECT_NEAR(work, 2 * strain_energy(mesh, materials, u), 1e-12 * work);
}

}  // namespace
}  // namespace gnathion
