#include "fem/quadratic_correction.h"

#include <Eigen/LU>

#include "base/error.h"

namespace gnathion {
namespace {

/// The projection Q Qᵀ onto the free part of a node.
Eigen::Matrix3d free_projection(const Support& support) {
  if (support == Support::free) return Eigen::Matrix3d::Identity();
  if (support != Support::sliding) return Eigen::Matrix3d::Zero();
  return Eigen::Matrix3d::Identity() - support.normal * support.normal.transpose();
}

TetMesh corners_of(const ElementMesh& elements) {
  return {elements.nodes.topRows(elements.vertex_count), elements.elements.leftCols<4>()};
}

}  // namespace

QuadraticCorrection::QuadraticCorrection(const StaticSolver& linear, Progress& progress)
    : linear_(linear),
      elements_(corners_of(linear.elements()), ElementOrder::quadratic),
      supports_(supports_of_nodes(elements_, linear.supports())) {
  const auto stage = progress.stage("quadratic elements for the error");
  K_ = stiffness_matrix(elements_, linear.materials());
  for (auto i = static_cast<int>(elements_.vertex_count); i < elements_.nodes.rows(); ++i) {
    const Eigen::Matrix3d P = free_projection(supports_[i]);
    int p = K_.start[i];
    while (K_.column[p] != i) ++p;
    // P K P made regular by the identity where nothing is free; the inverse is projected again.
    const Eigen::Matrix3d held = Eigen::Matrix3d::Identity() - P;
    middle_inverse_.emplace_back(P * (P * K_.blocks[p] * P + held).inverse() * P);
  }
}

QuadraticCorrection::Columns QuadraticCorrection::stiffness_times(const Columns& u) const {
  Columns f(u.rows(), u.cols());
  for (int i = 0; i < K_.node_count(); ++i) {
    auto sum = f.middleRows<3>(3 * i);
    sum.setZero();
    for (int p = K_.start[i]; p < K_.start[i + 1]; ++p) {
      sum.noalias() += K_.blocks[p].lazyProduct(u.middleRows<3>(3 * K_.column[p]));
    }
  }
  return f;
}

/// Pᵀ: forces at the nodes as forces on the vertices.
QuadraticCorrection::Columns QuadraticCorrection::restricted(const Columns& at_nodes) const {
  Columns at_vertices = at_nodes.topRows(3 * elements_.vertex_count);
  for (std::size_t e = 0; e < elements_.edges.size(); ++e) {
    const auto middle = 3 * (elements_.vertex_count + static_cast<Eigen::Index>(e));
    for (const int v : elements_.edges[e]) {
      at_vertices.middleRows<3>(3 * v) += at_nodes.middleRows<3>(middle) / 2;
    }
  }
  return at_vertices;
}

/// P: a field linear between the vertices, at all nodes.
QuadraticCorrection::Columns QuadraticCorrection::spread(const Columns& at_vertices) const {
  Columns at_nodes(3 * elements_.nodes.rows(), at_vertices.cols());
  at_nodes.topRows(at_vertices.rows()) = at_vertices;
  for (std::size_t e = 0; e < elements_.edges.size(); ++e) {
    const auto [a, b] = elements_.edges[e];
    at_nodes.middleRows<3>(3 * (elements_.vertex_count + static_cast<Eigen::Index>(e))) =
        (at_vertices.middleRows<3>(3 * a) + at_vertices.middleRows<3>(3 * b)) / 2;
  }
  return at_nodes;
}

/// The free part of a field alone.
void QuadraticCorrection::keep_free(Columns& field) const {
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    if (supports_[i] == Support::free) continue;
    auto rows = field.middleRows<3>(3 * static_cast<Eigen::Index>(i));
    rows = (free_projection(supports_[i]) * rows).eval();
  }
}

QuadraticCorrection::Columns QuadraticCorrection::preconditioned(const Columns& residual) const {
  const FreePart& free = linear_.free_part();
  const Eigen::MatrixXd on_vertices = restricted(residual);
  Eigen::MatrixXd v = Eigen::MatrixXd::Zero(on_vertices.rows(), on_vertices.cols());
  free.add(linear_.factor().solve(free.gather(on_vertices)), v);
  Columns z = spread(v);
  for (std::size_t e = 0; e < middle_inverse_.size(); ++e) {
    const auto row = 3 * (elements_.vertex_count + static_cast<Eigen::Index>(e));
    z.middleRows<3>(row).noalias() += middle_inverse_[e].lazyProduct(residual.middleRows<3>(row));
  }
  keep_free(z);
  return z;
}

Eigen::MatrixXd QuadraticCorrection::correct(const Eigen::MatrixXd& u, Progress& progress,
                                             int iterations, double tolerance) const {
  const Columns start = spread(u);
  Columns r = -stiffness_times(start);
  keep_free(r);
  Columns x = Columns::Zero(r.rows(), r.cols());
  Columns z = preconditioned(r);
  Columns direction = z;
  Eigen::ArrayXd rz = r.cwiseProduct(z).colwise().sum().transpose();
  const Eigen::ArrayXd first = rz;
  for (int k = 0; k < iterations && (rz > tolerance * tolerance * first).any(); ++k) {
    progress.check();
    Columns image = stiffness_times(direction);
    keep_free(image);
    const Eigen::ArrayXd curvature =
        direction.cwiseProduct(image).colwise().sum().transpose().array();
    const Eigen::ArrayXd step = (curvature > 0).select(rz / curvature, 0);
    x += direction * step.matrix().asDiagonal();
    r -= image * step.matrix().asDiagonal();
    z = preconditioned(r);
    const Eigen::ArrayXd next = r.cwiseProduct(z).colwise().sum().transpose();
    const Eigen::ArrayXd ratio = (rz > 0).select(next / rz, 0);
    direction = (z + direction * ratio.matrix().asDiagonal()).eval();
    rz = next;
  }
  if (!x.allFinite()) {
    throw Error(ErrorKind::numeric, "error estimate", "it is not finite",
                "report this case: it is a fault of the program");
  }
  return x.topRows(u.rows());
}

}  // namespace gnathion
