#include "fem/neo_hookean.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace gnathion {
namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;

/// The nodal rows of a field on one element.
template <int m>
Eigen::Matrix<double, m, 3> on_element(const Points& field, const int* element) {
  Eigen::Matrix<double, m, 3> values;
  for (int a = 0; a < m; ++a) values.row(a) = field.row(element[a]);
  return values;
}

/// cof A = ∂(det A)/∂A.
Eigen::Matrix3d cofactor(const Eigen::Matrix3d& A) {
  Eigen::Matrix3d result;
  result << A.col(1).cross(A.col(2)), A.col(2).cross(A.col(0)), A.col(0).cross(A.col(1));
  return result;
}

/// A deformation by what differs from rest, free of cancellation where that is little.
struct Deformation {
  Eigen::Matrix3d H;         ///< F − I = ∂u/∂X
  Eigen::Matrix3d cofactor;  ///< cof F − I
  double volume = 0;         ///< J − 1
  double stretch = 0;        ///< (tr FᵀF)/3 − 1

  Deformation() = default;
  explicit Deformation(const Eigen::Matrix3d& gradient) : H(gradient) {
    const Eigen::Matrix3d minors = gnathion::cofactor(H);
    const double trace = H.trace();
    // cof(I + H) = I + (tr H) I − Hᵀ + cof H and det(I + H) = 1 + tr H + tr cof H + det H.
    cofactor = minors - H.transpose();
    cofactor.diagonal().array() += trace;
    volume = trace + minors.trace() + H.col(0).dot(minors.col(0));
    stretch = (2 * trace + H.squaredNorm()) / 3;
  }
};

/// W but for the part of λ, MPa. J^(−2/3) tr FᵀF − 3 = 3 expm1(log(1 + stretch) − 2/3 log J).
double energy_density(double mu, const Deformation& d) {
  const double isochoric = std::expm1(std::log1p(d.stretch) - std::log1p(d.volume) * 2 / 3);
  return mu * (1.5 * isochoric + d.volume * d.volume / 3);
}

/// ∂W/∂J without the isochoric part, MPa.
double pressure_at(const ElasticMaterial& material, const Deformation& d, double mean_volume) {
  return material.shear_modulus() * 2 / 3 * d.volume + material.lame_lambda() * mean_volume;
}

/// P = ∂W/∂F = μ J^(−5/3) (J F − (tr FᵀF)/3 cof F) + p cof F, MPa.
Eigen::Matrix3d first_piola_stress(double mu, double pressure, const Deformation& d) {
  const double J = 1 + d.volume, root = std::cbrt(J);
  const double shear = mu / (J * root * root);
  Eigen::Matrix3d P = shear * J * d.H + (pressure - shear * (1 + d.stretch)) * d.cofactor;
  P.diagonal().array() += shear * (d.volume - d.stretch) + pressure;
  return P;
}

/// ∂²W/∂F² by the entries of F, column after column, MPa, but for what λ adds through the change of
/// its pressure.
Matrix9d moduli_at(double mu, double pressure, const Deformation& d) {
  const double J = 1 + d.volume, root = std::cbrt(J);
  const double shear = mu / (root * root), third = 1 + d.stretch;
  const Eigen::Matrix3d F = Eigen::Matrix3d::Identity() + d.H;
  const Eigen::Matrix3d C = Eigen::Matrix3d::Identity() + d.cofactor;
  const Vector9d f = F.reshaped(), c = C.reshaped();
  Matrix9d A = (5 * shear * third / (3 * J * J) + mu * 2 / 3) * c * c.transpose();
  A -= 2 * shear / (3 * J) * (f * c.transpose() + c * f.transpose());
  A.diagonal().array() += shear;
  // ∂(cof F)/∂F: column p of cof F is the product of the two columns of F after it.
  const double curvature = pressure - shear * third / J;
  for (int p = 0; p < 3; ++p) {
    const int q = (p + 1) % 3, r = (p + 2) % 3;
    Eigen::Matrix3d turn;  // turn x = F_r × x
    turn << 0, -F(2, r), F(1, r), F(2, r), 0, -F(0, r), -F(1, r), F(0, r), 0;
    A.block<3, 3>(3 * p, 3 * q) -= curvature * turn;
    A.block<3, 3>(3 * q, 3 * p) += curvature * turn;
  }
  return A;
}

Matrix9d without_negative_eigenvalues(const Matrix9d& A) {
  const Eigen::SelfAdjointEigenSolver<Matrix9d> eigen(A);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
         eigen.eigenvectors().transpose();
}

/// The deformation of one element.
template <int m>
struct DeformedElement {
  IntegrationPoints<m> points;
  std::array<Deformation, std::tuple_size_v<IntegrationPoints<m>>> at;
  double volume = 0;       ///< at rest, mm³
  double mean_change = 0;  ///< J̄ − 1
  bool admissible = true;  ///< J > 0 at all points

  DeformedElement(const ElementMesh& mesh, Eigen::Index t, const Points& u)
      : points(integration_points<m>(mesh.nodes, mesh.elements.row(t).data())) {
    const Eigen::Matrix<double, m, 3> U = on_element<m>(u, mesh.elements.row(t).data());
    for (std::size_t q = 0; q < points.size(); ++q) {
      at[q] = Deformation(U.transpose() * points[q].gradients);
      admissible = admissible && at[q].volume > -1;
      volume += points[q].volume;
      mean_change += points[q].volume * at[q].volume;
    }
    mean_change /= volume;
  }
};

template <int m>
double mesh_energy(const ElementMesh& mesh, const TissueMaterials& materials, const Points& u) {
  double energy = 0;
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    const DeformedElement<m> element(mesh, t, u);
    if (!element.admissible) return std::numeric_limits<double>::infinity();
    const double mu = materials[t].shear_modulus(), change = element.mean_change;
    for (std::size_t q = 0; q < element.points.size(); ++q) {
      energy += element.points[q].volume * energy_density(mu, element.at[q]);
    }
    energy += element.volume * materials[t].lame_lambda() / 2 * change * change;
  }
  return energy;
}

template <int m>
bool mesh_force(const ElementMesh& mesh, const TissueMaterials& materials, const Points& u,
                Points& force) {
  force.setZero(u.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    const DeformedElement<m> element(mesh, t, u);
    if (!element.admissible) return false;
    Eigen::Matrix<double, m, 3> at_nodes = Eigen::Matrix<double, m, 3>::Zero();
    for (std::size_t q = 0; q < element.points.size(); ++q) {
      const Deformation& d = element.at[q];
      const double pressure = pressure_at(materials[t], d, element.mean_change);
      const Eigen::Matrix3d P =
          element.points[q].volume * first_piola_stress(materials[t].shear_modulus(), pressure, d);
      at_nodes.noalias() += element.points[q].gradients * P.transpose();
    }
    for (int a = 0; a < m; ++a) force.row(mesh.elements(t, a)) += at_nodes.row(a);
  }
  return true;
}

/// K += Bᵀ A B at one integration point, where B takes displacements of the nodes to ∂u/∂X.
template <int m>
void add_point(const IntegrationPoint<m>& point, const Matrix9d& A,
               Eigen::Matrix<double, 3 * m, 3 * m>& K) {
  for (int b = 0; b < m; ++b) {
    const Eigen::RowVector3d g = point.volume * point.gradients.row(b);
    const Eigen::Matrix<double, 9, 3> AB =
        g[0] * A.leftCols<3>() + g[1] * A.middleCols<3>(3) + g[2] * A.rightCols<3>();
    for (int a = 0; a < m; ++a) {
      const auto h = point.gradients.row(a);
      K.template block<3, 3>(3 * a, 3 * b) +=
          h[0] * AB.topRows<3>() + h[1] * AB.middleRows<3>(3) + h[2] * AB.bottomRows<3>();
    }
  }
}

template <int m>
void add_tangents(const ElementMesh& mesh, const TissueMaterials& materials, const Points& u,
                  bool projected, StiffnessMatrix& K) {
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    const DeformedElement<m> element(mesh, t, u);
    Eigen::Matrix<double, 3 * m, 3 * m> matrix = Eigen::Matrix<double, 3 * m, 3 * m>::Zero();
    Eigen::Matrix<double, m, 3, Eigen::RowMajor> dilatation =
        Eigen::Matrix<double, m, 3, Eigen::RowMajor>::Zero();  // V ∂J̄/∂u
    for (std::size_t q = 0; q < element.points.size(); ++q) {
      const Deformation& d = element.at[q];
      const double pressure = pressure_at(materials[t], d, element.mean_change);
      const Matrix9d A = moduli_at(materials[t].shear_modulus(), pressure, d);
      add_point<m>(element.points[q], projected ? without_negative_eigenvalues(A) : A, matrix);
      const Eigen::Matrix3d cofactor = Eigen::Matrix3d::Identity() + d.cofactor;
      dilatation += element.points[q].volume * element.points[q].gradients * cofactor.transpose();
    }
    const Eigen::Map<const Eigen::Matrix<double, 3 * m, 1>> by_u(dilatation.data());
    matrix.noalias() += materials[t].lame_lambda() / element.volume * by_u * by_u.transpose();
    K.add<m>(mesh.elements.row(t).data(), matrix);
  }
}

template <int m>
Compression compression(const ElementMesh& mesh, const Points& u) {
  Compression most;
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    for (const Deformation& d : DeformedElement<m>(mesh, t, u).at) {
      if (1 + d.volume >= most.volume_ratio) continue;
      most.volume_ratio = 1 + d.volume;
      most.tet = t;
    }
  }
  if (most.tet < 0) return most;
  most.place = on_element<4>(mesh.nodes, mesh.elements.row(most.tet).data()).colwise().mean();
  return most;
}

}  // namespace

NeoHookeanTissue::NeoHookeanTissue(const ElementMesh& mesh, const TissueMaterials& materials)
    : mesh_(mesh), materials_(materials) {
  validate(materials, mesh.elements.rows());
}

double NeoHookeanTissue::energy(const Points& u) const {
  return mesh_.order() == ElementOrder::linear ? mesh_energy<4>(mesh_, materials_, u)
                                               : mesh_energy<10>(mesh_, materials_, u);
}

bool NeoHookeanTissue::internal_force(const Points& u, Points& force) const {
  return mesh_.order() == ElementOrder::linear ? mesh_force<4>(mesh_, materials_, u, force)
                                               : mesh_force<10>(mesh_, materials_, u, force);
}

void NeoHookeanTissue::tangent(const Points& u, bool projected, StiffnessMatrix& K) const {
  std::fill(K.blocks.begin(), K.blocks.end(), Eigen::Matrix3d::Zero());
  if (mesh_.order() == ElementOrder::linear) {
    add_tangents<4>(mesh_, materials_, u, projected, K);
  } else {
    add_tangents<10>(mesh_, materials_, u, projected, K);
  }
}

Compression NeoHookeanTissue::most_compressed(const Points& u) const {
  return mesh_.order() == ElementOrder::linear ? compression<4>(mesh_, u)
                                               : compression<10>(mesh_, u);
}

}  // namespace gnathion
