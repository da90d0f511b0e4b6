#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "fem/elements.h"
#include "fem/material.h"

namespace gnathion::testing {

using VectorField = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;
using GradientField = std::function<Eigen::Matrix3d(const Eigen::Vector3d&)>;

/// A point of an element with what is interpolated there; written apart from the program's own
/// shape functions, so as to check them.
struct ElementPoint {
  Eigen::Vector3d place;      ///< mm
  double volume = 0;          ///< weight, mm³
  Eigen::VectorXd shape;      ///< m values
  Eigen::MatrixX3d gradient;  ///< m×3, 1/mm
};

/// Shape functions and gradients at barycentric coordinates L: of degree 1 for 4 nodes, 2 for 10.
inline ElementPoint element_point(const ElementMesh& mesh, Eigen::Index element,
                                  const Eigen::Vector4d& L) {
  const auto nodes = mesh.elements.row(element);
  Eigen::Matrix4d corners;
  for (int k = 0; k < 4; ++k) corners.row(k) << 1, mesh.nodes.row(nodes[k]);
  // x = Σ L_k x_k and Σ L_k = 1: the columns of the inverse are the L_k as functions of (1, x).
  const Eigen::Matrix<double, 4, 3> dL = corners.inverse().bottomRows<3>().transpose();
  ElementPoint point;
  point.place = corners.rightCols<3>().transpose() * L;
  point.volume = corners.determinant() / 6;
  point.shape = L;
  point.gradient = dL;
  if (nodes.size() == 4) return point;
  point.shape.resize(10);
  point.gradient.resize(10, 3);
  for (int k = 0; k < 4; ++k) {
    point.shape[k] = 2 * L[k] * L[k] - L[k];
    point.gradient.row(k) = 4 * L[k] * dL.row(k) - dL.row(k);
  }
  constexpr std::array<std::array<int, 2>, 6> kEnds{
      {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  for (int k = 0; k < 6; ++k) {
    const auto [a, b] = kEnds[static_cast<std::size_t>(k)];
    point.shape[4 + k] = 4 * L[a] * L[b];
    point.gradient.row(4 + k) = 4 * L[a] * dL.row(b) + 4 * L[b] * dL.row(a);
  }
  return point;
}

/// Points of integration in one element, exact to degree 5: the conical product of four Gauss
/// points along each axis (Stroud 1971).
inline std::vector<ElementPoint> element_points(const ElementMesh& mesh, Eigen::Index element) {
  constexpr std::array<double, 4> x{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                    0.9305681557970263};
  constexpr std::array<double, 4> w{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                    0.1739274225687269};
  std::vector<ElementPoint> points;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double a = x[i], b = x[j] * (1 - a), c = x[k] * (1 - a - b);
        points.push_back(element_point(mesh, element, {1 - a - b - c, a, b, c}));
        points.back().volume *= 6 * w[i] * w[j] * w[k] * (1 - a) * (1 - a - b);
      }
    }
  }
  return points;
}

/// n×3: a field at points.
inline Points sampled(const Points& x, const VectorField& field) {
  Points values(x.rows(), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    values.row(i) = field(x.row(i).transpose()).transpose();
  }
  return values;
}

/// The nodal forces of a body force (N/mm³), n×3, N.
inline Points body_forces(const ElementMesh& mesh, const VectorField& body_force) {
  Points forces = Points::Zero(mesh.nodes.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    for (const ElementPoint& point : element_points(mesh, t)) {
      const Eigen::RowVector3d f = point.volume * body_force(point.place).transpose();
      for (Eigen::Index k = 0; k < mesh.elements.cols(); ++k) {
        forces.row(mesh.elements(t, k)) += point.shape[k] * f;
      }
    }
  }
  return forces;
}

/// Norms of a field's distance from another.
struct FieldError {
  double field = 0;     ///< L2
  double gradient = 0;  ///< L2 of the gradient
};
inline FieldError field_error(const ElementMesh& mesh, const Points& u, const VectorField& exact,
                              const GradientField& exact_gradient) {
  FieldError squares;
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    for (const ElementPoint& point : element_points(mesh, t)) {
      Eigen::Vector3d difference = -exact(point.place);
      Eigen::Matrix3d slope = -exact_gradient(point.place);
      for (Eigen::Index k = 0; k < mesh.elements.cols(); ++k) {
        const Eigen::Vector3d value = u.row(mesh.elements(t, k));
        difference += point.shape[k] * value;
        slope += value * point.gradient.row(k);
      }
      squares.field += point.volume * difference.squaredNorm();
      squares.gradient += point.volume * slope.squaredNorm();
    }
  }
  return {std::sqrt(squares.field), std::sqrt(squares.gradient)};
}

/// The elastic energy of a displacement, N·mm: ∫ μ ε:ε over each element plus λ/2 times the square
/// of its mean dilatation times its volume.
inline double strain_energy(const ElementMesh& mesh, const TissueMaterials& materials,
                            const Points& u) {
  double energy = 0;
  for (Eigen::Index t = 0; t < mesh.elements.rows(); ++t) {
    double volume = 0, dilatation = 0;
    for (const ElementPoint& point : element_points(mesh, t)) {
      Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
      for (Eigen::Index k = 0; k < mesh.elements.cols(); ++k) {
        slope += u.row(mesh.elements(t, k)).transpose() * point.gradient.row(k);
      }
      const Eigen::Matrix3d strain = (slope + slope.transpose()) / 2;
      energy += materials[t].shear_modulus() * point.volume * strain.squaredNorm();
      volume += point.volume;
      dilatation += point.volume * strain.trace();
    }
    energy += materials[t].lame_lambda() / 2 * dilatation * dilatation / volume;
  }
  return energy;
}

}  // namespace gnathion::testing
