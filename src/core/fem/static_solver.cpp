#include "fem/static_solver.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

/// −Qᵀ K u for each column, plus Qᵀ f.
Eigen::MatrixXd out_of_balance(const StiffnessMatrix& K, const FreePart& free,
                               const Eigen::MatrixXd& forces, const Eigen::MatrixXd& u) {
  Eigen::MatrixXd r = forces;
  for (const int node : free.nodes()) {
    for (int p = K.start[node]; p < K.start[node + 1]; ++p) {
      r.middleRows<3>(3 * node).noalias() -= K.blocks[p] * u.middleRows<3>(3 * K.column[p]);
    }
  }
  return free.gather(r);
}

void require_solved(const Eigen::MatrixXd& residual, const Eigen::MatrixXd& right_side) {
  for (Eigen::Index column = 0; column < residual.cols(); ++column) {
    const double scale = right_side.col(column).norm();
    const double size = residual.col(column).norm();
    if (!std::isfinite(size)) {
      throw Error(ErrorKind::numeric, "solver", "the displacement is not finite",
                  "report this case: it is a fault of the program");
    }
    if (scale > 0 && size > StaticSolver::kResidualLimit * scale) {
      std::ostringstream text;
      text << size / scale;
      throw Error(ErrorKind::numeric, "solver",
                  "the relative residual is " + text.str() + ", above the limit of 1e-8",
                  "use a better shaped region or a smaller Poisson's ratio");
    }
  }
}

}  // namespace

StaticSolver::StaticSolver(ElementMesh elements, TissueMaterials materials, Supports supports,
                           Progress& progress, SpdBackend backend)
    : elements_(std::move(elements)),
      materials_(std::move(materials)),
      supports_(std::move(supports)),
      free_(supports_) {
  {
    const auto stage = progress.stage("assemble stiffness");
    K_ = stiffness_matrix(elements_, materials_);
  }
  if (free_.size() == elements_.nodes.size()) {
    throw Error(ErrorKind::numeric, "region", "no point of the tissue is fixed or attached",
                "choose a region with a rim, so that the face does not float");
  }
  const auto stage = progress.stage("factorise");
  order_ = elimination_order(K_, free_);
  factor_ = std::make_unique<SpdFactor>(free_stiffness(K_, free_), order_, backend);
}

Eigen::MatrixXd StaticSolver::solve_columns(const Eigen::MatrixXd& prescribed,
                                            const Eigen::MatrixXd& forces) const {
  Eigen::MatrixXd u(prescribed.rows(), prescribed.cols());
  for (Eigen::Index column = 0; column < u.cols(); ++column) {
    const Eigen::VectorXd given = prescribed.col(column);
    const Points part = prescribed_part(
        supports_, Eigen::Map<const Points>(given.data(), elements_.nodes.rows(), 3));
    u.col(column) = part.reshaped<Eigen::RowMajor>();
  }
  // QᵀKQ q = Qᵀ(f − K u_d); at this point u holds u_d.
  const Eigen::MatrixXd right_side = out_of_balance(K_, free_, forces, u);
  free_.add(factor_->solve(right_side), u);
  require_solved(out_of_balance(K_, free_, forces, u), right_side);
  return u;
}

StaticSolution StaticSolver::solve(const Points& prescribed, const Points& forces) const {
  const Eigen::Index n = prescribed.rows();
  const Eigen::Map<const Eigen::VectorXd> u_given(prescribed.data(), 3 * n);
  const Eigen::Map<const Eigen::VectorXd> f(forces.data(), 3 * n);
  const Eigen::VectorXd u = solve_columns(u_given, f);
  StaticSolution solution;
  solution.displacements = Eigen::Map<const Points>(u.data(), n, 3);
  const Points given = prescribed_part(supports_, prescribed);
  const double scale = free_.gather(Points(forces - K_ * given)).norm();
  const double residual = free_.gather(Points(forces - K_ * solution.displacements)).norm();
  solution.relative_residual = scale > 0 ? residual / scale : 0;
  return solution;
}

}  // namespace gnathion
