#include "fem/response_basis.h"

#include <cmath>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

/// The six independent entries of a symmetric 3×3 matrix, as the force basis orders them.
constexpr std::array<std::array<int, 2>, 6> kSymmetric{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

}  // namespace

ResponseBasis::ResponseBasis(Eigen::Matrix<double, Eigen::Dynamic, 12> columns,
                             const Eigen::Vector3d& centre)
    : columns_(std::move(columns)), centre_(centre) {}

void ResponseBasis::displacements(const RigidMotion& motion, Points& out) const {
  Eigen::Matrix<double, 12, 1> pose;
  const Eigen::Matrix3d turn = motion.rotation - Eigen::Matrix3d::Identity();
  for (int row = 0; row < 3; ++row) pose.segment<3>(3 * row) = turn.row(row);
  pose.tail<3>() = turn * centre_ + motion.translation;
  out.resize(point_count(), 3);
  Eigen::Map<Eigen::VectorXd>(out.data(), columns_.rows()).noalias() = columns_ * pose;
}

ResponseBasis response_basis(const StaticSolver& solver, const Points& nodes,
                             const Eigen::Vector3d& centre) {
  const Eigen::Index n = nodes.rows();
  Eigen::MatrixXd prescribed = Eigen::MatrixXd::Zero(3 * n, 12);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (solver.supports()[i] != Support::attached) continue;
    for (int axis = 0; axis < 3; ++axis) {
      prescribed.block<1, 3>(3 * i + axis, 3 * axis) = nodes.row(i) - centre.transpose();
      prescribed(3 * i + axis, 9 + axis) = 1;
    }
  }
  return {solver.solve_columns(prescribed, Eigen::MatrixXd::Zero(3 * n, 12)), centre};
}

ForceBasis::ForceBasis(Eigen::Matrix<double, Eigen::Dynamic, 6> columns, std::vector<int> forced)
    : columns_(std::move(columns)), forced_(std::move(forced)) {}

ForceBasis::Result ForceBasis::displacements(const Eigen::Vector3d& translation) const {
  Result result;
  result.displacements = Points::Zero(columns_.rows() / 3, 3);
  const double length = translation.norm();
  if (length == 0) return result;
  const Eigen::Vector3d direction = translation / length;
  Eigen::Matrix<double, 6, 1> unit;
  for (int k = 0; k < 6; ++k) unit[k] = direction[kSymmetric[k][0]] * direction[kSymmetric[k][1]];
  const Eigen::VectorXd u = columns_ * unit;
  double mean = 0;
  for (const int i : forced_) mean += u.segment<3>(3 * i).dot(direction);
  mean /= static_cast<double>(forced_.size());
  if (!(mean > 0)) {
    throw Error(ErrorKind::numeric, "tissue.load",
                "no force along this motion moves the forced points along it",
                "use displacement transfer (tissue.load: \"displacement\")");
  }
  result.force_N = length / mean;
  Eigen::Map<Eigen::VectorXd>(result.displacements.data(), u.size()) = result.force_N * u;
  return result;
}

ForceBasis force_basis(const StaticSolver& solver, const std::vector<int>& forced,
                       const Points& normals) {
  const auto n = static_cast<Eigen::Index>(solver.supports().size());
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(3 * n, 6);
  for (std::size_t f = 0; f < forced.size(); ++f) {
    const Eigen::Vector3d normal = normals.row(static_cast<Eigen::Index>(f));
    for (int k = 0; k < 6; ++k) {
      const auto [row, column] = kSymmetric[k];
      forces(3 * forced[f] + row, k) += normal[column];
      if (row != column) forces(3 * forced[f] + column, k) += normal[row];
    }
  }
  return {solver.solve_columns(Eigen::MatrixXd::Zero(3 * n, 6), forces), forced};
}

}  // namespace gnathion
