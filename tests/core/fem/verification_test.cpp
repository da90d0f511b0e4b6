// Solutions in closed form, published ones, and the rates at which the elements reach them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "fem/static_solver.h"
#include "support/fields.h"
#include "support/tet_solids.h"
#include "support/thick_sphere.h"

namespace gnathion {
namespace {

using namespace testing;

constexpr ElementOrder kLinear = ElementOrder::linear, kQuadratic = ElementOrder::quadratic;
constexpr double kTiny = 1e-9;

/// The order with which an error falls when the mesh size is divided by `ratio`.
double rate(double coarse, double fine, double ratio = 2) {
  return std::log(coarse / fine) / std::log(ratio);
}

Points solved(const ElementMesh& mesh, const ElasticMaterial& material, const Supports& supports,
              const Points& prescribed, const Points& forces) {
  Progress progress;
  return StaticSolver(mesh, material, supports, progress).solve(prescribed, forces).displacements;
}

/// A manufactured solution on a cube of 10 mm: waves Σ p sin(k·x + c) and the body force that they
/// need, −(λ+μ) ∇ div u − μ Δu = Σ (μ |k|² p + (λ+μ) (k·p) k) sin(k·x + c). Two waves shear (p ⟂
/// k); the third compresses, the less the greater λ, as the pressures of tissue do.
struct Manufactured {
  struct Wave {
    Eigen::Vector3d k, p;
    double c;
  };
  std::array<Wave, 3> waves;
  ElasticMaterial material;

  explicit Manufactured(const ElasticMaterial& of) : material(of) {
    const Eigen::Vector3d k0(0.25, 0.1, -0.15), k1(-0.1, 0.2, 0.2), k2(0.15, -0.2, 0.1);
    const double part = of.shear_modulus() / (of.lame_lambda() + 2 * of.shear_modulus());
    waves = {{{k0, 0.3 * k0.cross(k1), 0.3},
              {k1, 0.3 * k1.cross(k2), 1.1},
              {k2, 0.1 * part * k2, -0.7}}};
  }
  Eigen::Vector3d field(const Eigen::Vector3d& x) const {
    Eigen::Vector3d u = Eigen::Vector3d::Zero();
    for (const Wave& w : waves) u += w.p * std::sin(w.k.dot(x) + w.c);
    return u;
  }
  Eigen::Matrix3d gradient(const Eigen::Vector3d& x) const {
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
    for (const Wave& w : waves) slope += w.p * w.k.transpose() * std::cos(w.k.dot(x) + w.c);
    return slope;
  }
  Eigen::Vector3d body_force(const Eigen::Vector3d& x) const {
    const double mu = material.shear_modulus(), lambda = material.lame_lambda();
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const Wave& w : waves) {
      force += (mu * w.k.squaredNorm() * w.p + (lambda + mu) * w.k.dot(w.p) * w.k) *
               std::sin(w.k.dot(x) + w.c);
    }
    return force;
  }
};

FieldError manufactured_error(ElementOrder order, double poisson, int n) {
  const Eigen::Vector3d size(10, 10, 10);
  const ElasticMaterial material{1, poisson};
  const Manufactured problem(material);
  const ElementMesh mesh(tet_box(size, {n, n, n}), order);
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (const auto& face : hull_faces(mesh)) {
    for (const int node : face) supports[node] = Support::attached;
  }
  const auto field = [&](const Eigen::Vector3d& x) { return problem.field(x); };
  const Points u =
      solved(mesh, material, supports, sampled(mesh.nodes, field),
             body_forces(mesh, [&](const Eigen::Vector3d& x) { return problem.body_force(x); }));
  return field_error(mesh, u, field, [&](const Eigen::Vector3d& x) { return problem.gradient(x); });
}

TEST(ManufacturedSolution, LinearElementsAreOfSecondOrderAndTheirGradientsOfFirst) {
  const FieldError coarse = manufactured_error(kLinear, 0.3, 6);
  const FieldError fine = manufactured_error(kLinear, 0.3, 12);
  RecordProperty("rate_L2", std::to_string(rate(coarse.field, fine.field)));
  EXPECT_NEAR(rate(coarse.field, fine.field), 2, 0.15);
  EXPECT_NEAR(rate(coarse.gradient, fine.gradient), 1, 0.1);
}

TEST(ManufacturedSolution, QuadraticElementsAreOfThirdOrderWhereTheVolumeMayChangeFreely) {
  const FieldError coarse = manufactured_error(kQuadratic, 0, 3);
  const FieldError fine = manufactured_error(kQuadratic, 0, 6);
  EXPECT_NEAR(rate(coarse.field, fine.field), 3, 0.2);
  EXPECT_NEAR(rate(coarse.gradient, fine.gradient), 2, 0.15);
}

TEST(ManufacturedSolution, QuadraticElementsAreOfSecondOrderAtEveryPoissonsRatio) {
  // The mean dilatation is constant over an element, which costs an order; the error is still far
  // below that of linear elements on the same nodes.
  for (const double poisson : {0.46, 0.499, 0.4999}) {
    const FieldError coarse = manufactured_error(kQuadratic, poisson, 3);
    const FieldError fine = manufactured_error(kQuadratic, poisson, 6);
    EXPECT_GT(rate(coarse.field, fine.field), 1.9) << poisson;
    EXPECT_GT(rate(coarse.gradient, fine.gradient), 1.15) << poisson;
    EXPECT_LT(fine.field, 0.3 * manufactured_error(kLinear, poisson, 12).field) << poisson;
  }
}

TEST(LameSphere, ConvergesAsTheFlatFacesOfElementsAllow) {
  for (const ElementOrder order : {kLinear, kQuadratic}) {
    const double coarse = lame_error(order, 0.3, 4), fine = lame_error(order, 0.3, 8);
    EXPECT_GT(rate(coarse, fine), 1.6);
  }
}

TEST(LameSphere, QuadraticElementsDoNotLock) {
  for (const double poisson : {0.46, 0.49, 0.499, 0.4999}) {
    const double error = lame_error(kQuadratic, poisson, 5);
    EXPECT_LT(error, 0.015) << poisson;
  }
  EXPECT_GT(lame_error(kLinear, 0.499, 5), 0.1) << "linear elements lock: the quick model's limit";
}

/// A beam of 50×10×10 mm clamped at x = 0, pulled up at its end by 0.01 N: mean displacement there.
double beam_tip(ElementOrder order, double poisson, const std::array<int, 3>& n) {
  const ElementMesh mesh(tet_box({50, 10, 10}, n), order);
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    if (mesh.nodes(i, 0) < kTiny) supports[i] = Support::fixed;
  }
  const Points forces = traction_forces(
      mesh, [](const Eigen::Vector3d& x) { return x[0] > 50 - kTiny; },
      [](const Eigen::Vector3d&, const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 1e-4); });
  const Points u = solved(mesh, {1, poisson}, supports, Points::Zero(mesh.nodes.rows(), 3), forces);
  // Work over force: the mean weighted as the load is.
  return (u.array() * forces.array()).sum() / 0.01;
}

TEST(Cantilever, BendsAndShearsAsTimoshenkosBeam) {
  // w = F L³/(3 E I) + F L/(κ G A), κ = 5/6 for a rectangle at ν = 0, where no clamping of the
  // width stiffens it.
  const double bending = 0.01 * 50 * 50 * 50 / (3 * (10 * 10 * 10 * 10 / 12.0));
  const double shear = 0.01 * 50 / (5.0 / 6 * 0.5 * 100);
  const double tip = beam_tip(kQuadratic, 0, {10, 2, 2});
  EXPECT_NEAR(tip / (bending + shear), 1, 3e-3);
  EXPECT_GT(tip / bending, 1.015) << "shear is missing";
  const double coarse = 1 - beam_tip(kLinear, 0, {10, 2, 2}) / tip;
  const double fine = 1 - beam_tip(kLinear, 0, {20, 4, 4}) / tip;
  EXPECT_GT(coarse, 0) << "linear elements can only be too stiff";
  EXPECT_GT(rate(coarse, fine), 1.2);
}

TEST(Cantilever, QuadraticElementsDoNotLockAndLinearOnesDo) {
  const double fine = beam_tip(kQuadratic, 0.499, {20, 4, 4});
  EXPECT_NEAR(beam_tip(kQuadratic, 0.499, {10, 2, 2}) / fine, 1, 0.02);
  EXPECT_LT(beam_tip(kLinear, 0.499, {10, 2, 2}) / fine, 0.2);
}

/// Cook's membrane, E = 1 MPa, its left end clamped, sheared by 1 N per mm of thickness at the
/// right. `strain`: plane strain (both faces slide), else a thin sheet of which one face slides,
/// the plane of symmetry. Displacement along y of the node at this height of the right end.
double cook_tip(ElementOrder order, double poisson, bool strain, double height,
                const std::array<int, 3>& n) {
  const double thickness = strain ? 4 : 0.5;
  const ElementMesh mesh(tet_cook(thickness, n), order);
  Supports supports(static_cast<std::size_t>(mesh.nodes.rows()));
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    const auto x = mesh.nodes.row(i);
    if (x[2] < kTiny || (strain && x[2] > thickness - kTiny)) {
      supports[i] = Support::slides(Eigen::Vector3d::UnitZ(), Support::kUnmoved);
    }
    if (x[0] < kTiny) supports[i] = Support::fixed;
  }
  const Points forces = traction_forces(
      mesh, [](const Eigen::Vector3d& x) { return x[0] > 48 - kTiny; },
      [](const Eigen::Vector3d&, const Eigen::Vector3d&) {
        return Eigen::Vector3d(0, 1.0 / 16, 0);
      });
  const Points u = solved(mesh, {1, poisson}, supports, Points::Zero(mesh.nodes.rows(), 3), forces);
  Eigen::Index tip = 0;
  (mesh.nodes.rowwise() - Eigen::RowVector3d(48, height, 0)).rowwise().norm().minCoeff(&tip);
  return u(tip, 1);
}

TEST(CookMembrane, AgreesWithThePublishedPlaneStress) {
  // 23.96 at the middle of the end, ν = 1/3, E = 1, F = 1 (Cook's problem as usually quoted).
  const double tip = cook_tip(kQuadratic, 1.0 / 3, false, 52, {16, 16, 1});
  EXPECT_NEAR(tip / 23.96, 1, 0.01);
}

TEST(CookMembrane, ConvergesAtTheRateOfItsCorner) {
  // The clamped obtuse corner is singular, which no polynomial follows: all orders share its rate.
  const double fine = cook_tip(kQuadratic, 0.3, true, 60, {48, 48, 1});
  for (const ElementOrder order : {kLinear, kQuadratic}) {
    const double e1 = std::abs(cook_tip(order, 0.3, true, 60, {8, 8, 1}) / fine - 1);
    const double e2 = std::abs(cook_tip(order, 0.3, true, 60, {16, 16, 1}) / fine - 1);
    EXPECT_GT(rate(e1, e2), 1.1);
  }
}

TEST(CookMembrane, QuadraticElementsDoNotLockAndLinearOnesDo) {
  for (const double poisson : {0.46, 0.499, 0.4999}) {
    const double fine = cook_tip(kQuadratic, poisson, true, 60, {32, 32, 1});
    EXPECT_NEAR(cook_tip(kQuadratic, poisson, true, 60, {8, 8, 2}) / fine, 1, 0.02) << poisson;
    if (poisson > 0.49) {
      EXPECT_LT(cook_tip(kLinear, poisson, true, 60, {8, 8, 2}) / fine, 0.35);
    }
  }
}

}  // namespace
}  // namespace gnathion
