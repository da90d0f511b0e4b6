#include "fem/response_basis.h"

#include <cmath>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

/// The six independent entries of a symmetric 3×3 matrix, as the force basis orders them.
constexpr std::array<std::array<int, 2>, 6> kSymmetric{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

/// Columns of the basis for one segment.
constexpr int kColumns = 12;

/// out += columns · pose, for twelve columns of n rows. The sums of four rows stay in registers
/// while the twelve columns are read side by side, each once: memory is then read nearly as fast as
/// it can be. Unrolled, which more rows at once or a loop of unknown length would prevent: then it
/// takes three times as long once the basis exceeds the cache.
void add_product(const double* columns, Eigen::Index n,
                 const Eigen::Matrix<double, kColumns, 1>& pose, double* out) {
  constexpr Eigen::Index kRows = 4;
  using Rows = Eigen::Array<double, kRows, 1>;
  const Eigen::Index in_fours = n - n % kRows;
  for (Eigen::Index i = 0; i < in_fours; i += kRows) {
    Rows sum = Eigen::Map<const Rows>(out + i);
    for (int k = 0; k < kColumns; ++k) sum += pose[k] * Eigen::Map<const Rows>(columns + k * n + i);
    Eigen::Map<Rows>(out + i) = sum;
  }
  for (Eigen::Index i = in_fours; i < n; ++i) {
    for (int k = 0; k < kColumns; ++k) out[i] += pose[k] * columns[k * n + i];
  }
}

}  // namespace

ResponseBasis::ResponseBasis(Eigen::MatrixXd columns, std::vector<Eigen::Vector3d> centres)
    : columns_(std::move(columns)), centres_(std::move(centres)) {}

void ResponseBasis::displacements(std::span<const RigidMotion> motions, Points& out) const {
  out.setZero(columns_.rows() / 3, 3);
  for (std::size_t s = 0; s < centres_.size(); ++s) {
    const Eigen::Matrix3d turn = motions[s].rotation - Eigen::Matrix3d::Identity();
    Eigen::Matrix<double, kColumns, 1> pose;
    for (int row = 0; row < 3; ++row) pose.segment<3>(3 * row) = turn.row(row);
    pose.tail<3>() = turn * centres_[s] + motions[s].translation;
    const auto first = static_cast<Eigen::Index>(kColumns * s);
    add_product(columns_.col(first).data(), columns_.rows(), pose, out.data());
  }
}

namespace {

/// What the columns of a basis prescribe: 3n×12s fields at the nodes that bone moves.
Eigen::MatrixXd basis_loads(const Points& nodes, const Supports& supports,
                            const std::vector<Eigen::Vector3d>& centres) {
  const Eigen::Index n = nodes.rows();
  Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(3 * n, static_cast<Eigen::Index>(12 * centres.size()));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Support& support = supports[i];
    const bool tied = support == Support::attached || support == Support::sliding;
    if (!tied || support.body == Support::kUnmoved) continue;
    const Eigen::Index first = 12 * support.body;
    for (int axis = 0; axis < 3; ++axis) {
      loads.block<1, 3>(3 * i + axis, first + 3 * axis) =
          nodes.row(i) - centres[support.body].transpose();
      loads(3 * i + axis, first + 9 + axis) = 1;
    }
  }
  return loads;
}

}  // namespace

ResponseBasis response_basis(const StaticSolver& solver,
                             const std::vector<Eigen::Vector3d>& centres) {
  const Eigen::MatrixXd loads = basis_loads(solver.elements().nodes, solver.supports(), centres);
  return {solver.solve_columns(loads, Eigen::MatrixXd::Zero(loads.rows(), loads.cols())), centres};
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
  const Eigen::Index n = solver.elements().nodes.rows();
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
