#include "fem/neo_hookean.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "geometry/rigid_motion.h"
#include "support/tet_solids.h"

namespace gnathion {
namespace {

const Eigen::Vector3d kSize{4, 5, 3};
const TissueMaterials kOne = ElasticMaterial{2, 0.46};

/// A small block of unlike tets.
TetMesh block() {
  TetMesh mesh = testing::tet_box(kSize, {2, 2, 2});
  testing::distort_box(mesh, kSize, {2, 2, 2}, 0.2, 3);
  return mesh;
}

/// Of fat and muscle by turns.
TissueMaterials two_materials(const TetMesh& mesh) {
  std::vector<unsigned char> kinds;
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) kinds.push_back(t % 3 == 0);
  return {{{0.5, 0.3}, {7, 0.49}}, kinds};
}

Points random_field(Eigen::Index n, double size, unsigned seed) {
  std::mt19937 random(seed);
  Points u(n, 3);
  for (double& x : u.reshaped()) x = size * (static_cast<double>(random()) / 2147483648.0 - 1);
  return u;
}

/// A random state scaled until the smallest J is about `least`.
Points state_with(const NeoHookeanTissue& tissue, Eigen::Index n, double least, unsigned seed) {
  const Points whole = random_field(n, 5, seed);
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double part = (low + high) / 2;
    (tissue.most_compressed(part * whole).volume_ratio > least ? low : high) = part;
  }
  return low * whole;
}

Points force_at(const NeoHookeanTissue& tissue, const Points& u) {
  Points force;
  EXPECT_TRUE(tissue.internal_force(u, force));
  return force;
}

Eigen::MatrixXd dense(const StiffnessMatrix& K) {
  const Eigen::Index n = K.node_count();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * n, 3 * n);
  for (int i = 0; i < n; ++i) {
    for (int p = K.start[i]; p < K.start[i + 1]; ++p) {
      matrix.block<3, 3>(3 * i, 3 * K.column[p]) = K.blocks[p];
    }
  }
  return matrix;
}

class EitherOrder : public ::testing::TestWithParam<ElementOrder> {};
INSTANTIATE_TEST_SUITE_P(NeoHookean, EitherOrder,
                         ::testing::Values(ElementOrder::linear, ElementOrder::quadratic));

TEST_P(EitherOrder, ForceIsTheGradientOfTheEnergyAndTangentThatOfTheForce) {
  const TetMesh mesh = block();
  const ElementMesh elements(mesh, GetParam());
  const TissueMaterials materials = two_materials(mesh);
  const NeoHookeanTissue tissue(elements, materials);
  StiffnessMatrix K = empty_stiffness(elements);
  const Eigen::Index n = elements.nodes.rows();
  for (const double least : {0.9, 0.5, 0.1, 0.02}) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      const Points u = state_with(tissue, n, least, seed);
      const Points d = random_field(n, 1, 100 + seed);
      // Five points: the error is of fourth order in h over the way to the next inversion.
      const double h = 1e-3 * least;
      const auto along = [&](double s) { return Points(u + s * h * d); };
      const double slope = (8 * (tissue.energy(along(1)) - tissue.energy(along(-1))) -
                            (tissue.energy(along(2)) - tissue.energy(along(-2)))) /
                           (12 * h);
      const Points force = force_at(tissue, u);
      EXPECT_NEAR((force.array() * d.array()).sum(), slope, 1e-7 * force.norm() * d.norm())
          << least;
      const Points change = (8 * (force_at(tissue, along(1)) - force_at(tissue, along(-1))) -
                             (force_at(tissue, along(2)) - force_at(tissue, along(-2)))) /
                            (12 * h);
      tissue.tangent(u, false, K);
      EXPECT_LT((K * d - change).norm(), 1e-7 * change.norm()) << least;
    }
  }
}

TEST_P(EitherOrder, TangentAtRestIsTheLinearStiffness) {
  const TetMesh mesh = block();
  const ElementMesh elements(mesh, GetParam());
  const TissueMaterials materials = two_materials(mesh);
  const NeoHookeanTissue tissue(elements, materials);
  StiffnessMatrix K = empty_stiffness(elements);
  tissue.tangent(Points::Zero(elements.nodes.rows(), 3), false, K);
  const Eigen::MatrixXd linear = dense(stiffness_matrix(elements, materials));
  EXPECT_LT((dense(K) - linear).norm(), 1e-13 * linear.norm());
}

TEST_P(EitherOrder, ARigidMotionStoresNoEnergyAndNeedsNoForce) {
  const ElementMesh elements(block(), GetParam());
  const NeoHookeanTissue tissue(elements, kOne);
  for (const double degrees : {1e-6, 30.0, 90.0, 180.0}) {
    RigidMotion motion;
    motion.rotation =
        Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d(1, 2, -1).normalized())
            .toRotationMatrix();
    motion.translation << 10, -4, 7;
    const Points u = moved(elements.nodes, motion) - elements.nodes;
    EXPECT_LT(std::abs(tissue.energy(u)), 1e-12) << degrees;
    EXPECT_LT(force_at(tissue, u).cwiseAbs().maxCoeff(), 1e-12) << degrees;
    // And turning a deformed state turns its forces.
    const Points bent = random_field(elements.nodes.rows(), 0.1, 5);
    const Points turned = moved(elements.nodes + bent, motion) - elements.nodes;
    EXPECT_NEAR(tissue.energy(turned), tissue.energy(bent), 1e-12 * tissue.energy(bent));
    EXPECT_LT((force_at(tissue, turned) - force_at(tissue, bent) * motion.rotation.transpose())
                  .cwiseAbs()
                  .maxCoeff(),
              1e-12);
  }
}

TEST_P(EitherOrder, UniformDeformationHasTheLawsEnergyAndStress) {
  const TetMesh mesh = block();
  const ElementMesh elements(mesh, GetParam());
  const NeoHookeanTissue tissue(elements, kOne);
  Eigen::Matrix3d F;
  F << 1.3, 0.4, -0.1, 0.2, 0.7, 0.3, 0, -0.5, 1.1;
  const Points u = elements.nodes * F.transpose() - elements.nodes;
  const double mu = kOne[0].shear_modulus(), kappa = kOne[0].bulk_modulus();
  const double J = F.determinant(), trace = (F.transpose() * F).trace();
  const double W = mu / 2 * (std::pow(J, -2.0 / 3) * trace - 3) + kappa / 2 * (J - 1) * (J - 1);
  EXPECT_NEAR(tissue.energy(u), kSize.prod() * W, 1e-12 * kSize.prod() * W);
  const Eigen::Matrix3d inverse = F.inverse().transpose();
  const Eigen::Matrix3d P =
      mu * std::pow(J, -2.0 / 3) * (F - trace / 3 * inverse) + kappa * (J - 1) * J * inverse;
  const Points traction = testing::traction_forces(
      elements, [](const Eigen::Vector3d&) { return true; },
      [&](const Eigen::Vector3d&, const Eigen::Vector3d& normal) { return (P * normal).eval(); });
  EXPECT_LT((force_at(tissue, u) - traction).norm(), 1e-12 * traction.norm());
}

TEST_P(EitherOrder, SmallMotionsKeepTheirDigits) {
  const ElementMesh elements(block(), GetParam());
  const NeoHookeanTissue tissue(elements, kOne);
  const StiffnessMatrix K = stiffness_matrix(elements, kOne);
  const Points u = random_field(elements.nodes.rows(), 1e-9, 8);
  const Points linear = K * u;
  EXPECT_LT((force_at(tissue, u) - linear).norm(), 1e-8 * linear.norm());
  const double energy = (u.array() * linear.array()).sum() / 2;
  EXPECT_NEAR(tissue.energy(u), energy, 1e-5 * energy);
}

TEST_P(EitherOrder, ProjectedTangentHasNoNegativeEigenvalues) {
  const ElementMesh elements(block(), GetParam());
  const NeoHookeanTissue tissue(elements, kOne);
  const Points u = state_with(tissue, elements.nodes.rows(), 0.02, 4);
  StiffnessMatrix K = empty_stiffness(elements);
  const auto least = [&](bool projected) {
    tissue.tangent(u, projected, K);
    const Eigen::MatrixXd matrix = dense(K);
    EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-12 * matrix.norm());
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    return values[0] / values[values.size() - 1];
  };
  EXPECT_LT(least(false), -1e-6);
  EXPECT_GT(least(true), -1e-12);
}

TEST_P(EitherOrder, TurningTissueInsideOutIsInadmissibleAndNamed) {
  const TetMesh mesh = block();
  const ElementMesh elements(mesh, GetParam());
  const NeoHookeanTissue tissue(elements, kOne);
  // One vertex of tet 11 goes far beyond the opposite face.
  Points at_vertices = Points::Zero(mesh.vertices.rows(), 3);
  const Eigen::RowVector3d apex = mesh.vertices.row(mesh.tets(11, 0));
  const Eigen::RowVector3d base =
      (mesh.vertices.row(mesh.tets(11, 1)) + mesh.vertices.row(mesh.tets(11, 2)) +
       mesh.vertices.row(mesh.tets(11, 3))) /
      3;
  at_vertices.row(mesh.tets(11, 0)) = 1.5 * (base - apex);
  const Points u = elements.from_vertices(at_vertices);
  Points force;
  EXPECT_EQ(tissue.energy(u), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(tissue.internal_force(u, force));
  const Compression most = tissue.most_compressed(u);
  EXPECT_LT(most.volume_ratio, 0);
  const auto tet = mesh.tets.row(most.tet);
  EXPECT_TRUE((tet.array() == mesh.tets(11, 0)).any());
  EXPECT_LT((most.place - (mesh.vertices.row(tet[0]) + mesh.vertices.row(tet[1]) +
                           mesh.vertices.row(tet[2]) + mesh.vertices.row(tet[3])) /
                              4)
                .norm(),
            1e-12);
}

}  // namespace
}  // namespace gnathion
