#include "fem/static_solver.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "base/error.h"

namespace gnathion {

StaticSolver::StaticSolver(const TetMesh& mesh, const ElasticMaterial& material, Supports supports,
                           Progress& progress, SpdBackend backend)
    : supports_(std::move(supports)) {
  {
    const auto stage = progress.stage("assemble stiffness");
    K_ = stiffness_matrix(mesh, material);
  }
  free_index_.assign(supports_.size(), -1);
  for (int i = 0; i < static_cast<int>(supports_.size()); ++i) {
    if (supports_[i] != Support::free) continue;
    free_index_[i] = static_cast<int>(free_nodes_.size());
    free_nodes_.push_back(i);
  }
  if (free_nodes_.size() == supports_.size()) {
    throw Error(ErrorKind::numeric, "region", "no point of the tissue is fixed or attached",
                "choose a region with a rim, so that the face does not float");
  }
  const auto stage = progress.stage("factorise");
  std::vector<int> order;
  const Eigen::SparseMatrix<double> lower = free_part(order);
  factor_ = std::make_unique<SpdFactor>(lower, order, backend);
}

Eigen::SparseMatrix<double> StaticSolver::free_part(std::vector<int>& order) const {
  const auto n = static_cast<int>(free_nodes_.size());
  std::vector<int> start(1, 0), column;
  for (const int node : free_nodes_) {
    for (int p = K_.start[node]; p < K_.start[node + 1]; ++p) {
      const int j = free_index_[K_.column[p]];
      if (j != -1) column.push_back(j);
    }
    start.push_back(static_cast<int>(column.size()));
  }
  // The three components of a node share its neighbours: ordering the graph of nodes is nine times
  // less work than ordering K, and no worse.
  order.clear();
  for (const int node : nested_dissection(start, column)) {
    for (int axis = 0; axis < 3; ++axis) order.push_back(3 * node + axis);
  }
  Eigen::SparseMatrix<double> lower(3 * n, 3 * n);
  std::vector<int> entries(static_cast<std::size_t>(3 * n));
  for (int i = 0; i < n; ++i) {
    const auto below = std::count_if(column.begin() + start[i], column.begin() + start[i + 1],
                                     [i](int j) { return j > i; });
    for (int axis = 0; axis < 3; ++axis) {
      entries[3 * i + axis] = static_cast<int>(3 * below) + 3 - axis;
    }
  }
  lower.reserve(entries);
  for (int i = 0; i < n; ++i) {
    const int node = free_nodes_[i];
    for (int axis = 0; axis < 3; ++axis) {
      for (int p = K_.start[node]; p < K_.start[node + 1]; ++p) {
        const int j = free_index_[K_.column[p]];
        if (j < i) continue;
        // Column 3i+axis holds rows 3j+k: block (j, i) is the transpose of block (i, j).
        for (int k = j == i ? axis : 0; k < 3; ++k) {
          lower.insert(3 * j + k, 3 * i + axis) = K_.blocks[p](axis, k);
        }
      }
    }
  }
  lower.makeCompressed();
  return lower;
}

Eigen::MatrixXd StaticSolver::solve_columns(const Eigen::MatrixXd& prescribed,
                                            const Eigen::MatrixXd& forces) const {
  const auto n = static_cast<int>(supports_.size());
  const auto n_free = static_cast<int>(free_nodes_.size());
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(3 * n, prescribed.cols());
  for (int i = 0; i < n; ++i) {
    if (supports_[i] == Support::attached) u.middleRows<3>(3 * i) = prescribed.middleRows<3>(3 * i);
  }
  // K_ff u_f = f_f − K_fd u_d; at this point u holds u_d and zeros.
  const auto load = [&](const Eigen::MatrixXd& displacements) {
    Eigen::MatrixXd r(3 * n_free, displacements.cols());
    for (int i = 0; i < n_free; ++i) {
      const int node = free_nodes_[i];
      r.middleRows<3>(3 * i) = forces.middleRows<3>(3 * node);
      for (int p = K_.start[node]; p < K_.start[node + 1]; ++p) {
        r.middleRows<3>(3 * i).noalias() -=
            K_.blocks[p] * displacements.middleRows<3>(3 * K_.column[p]);
      }
    }
    return r;
  };
  const Eigen::MatrixXd right_side = load(u);
  const auto add_free = [&](const Eigen::MatrixXd& x) {
    for (int i = 0; i < n_free; ++i) {
      u.middleRows<3>(3 * free_nodes_[i]) += x.middleRows<3>(3 * i);
    }
  };
  add_free(factor_->solve(right_side));
  for (Eigen::Index column = 0; column < u.cols(); ++column) {
    if (!u.col(column).allFinite()) {
      throw Error(ErrorKind::numeric, "solver", "the displacement is not finite",
                  "report this case: it is a fault of the program");
    }
  }
  const Eigen::MatrixXd residual = load(u);
  for (Eigen::Index column = 0; column < u.cols(); ++column) {
    const double scale = right_side.col(column).norm();
    if (scale > 0 && residual.col(column).norm() > kResidualLimit * scale) {
      std::ostringstream size;
      size << residual.col(column).norm() / scale;
      throw Error(ErrorKind::numeric, "solver",
                  "the relative residual is " + size.str() + ", above the limit of 1e-8",
                  "use a better shaped region or a smaller Poisson's ratio");
    }
  }
  return u;
}

StaticSolution StaticSolver::solve(const Points& prescribed, const Points& forces) const {
  const Eigen::Index n = prescribed.rows();
  const Eigen::Map<const Eigen::VectorXd> u_given(prescribed.data(), 3 * n);
  const Eigen::Map<const Eigen::VectorXd> f(forces.data(), 3 * n);
  const Eigen::VectorXd u = solve_columns(u_given, f);
  StaticSolution solution;
  solution.displacements = Eigen::Map<const Points>(u.data(), n, 3);
  Points given = Points::Zero(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (supports_[i] == Support::attached) given.row(i) = prescribed.row(i);
  }
  const Points out_of_balance = forces - K_ * solution.displacements;
  const Points right_side = forces - K_ * given;
  double residual = 0, scale = 0;
  for (const int i : free_nodes_) {
    residual += out_of_balance.row(i).squaredNorm();
    scale += right_side.row(i).squaredNorm();
  }
  solution.relative_residual = scale > 0 ? std::sqrt(residual / scale) : 0;
  return solution;
}

}  // namespace gnathion
