#pragma once

#include "fem/static_solver.h"

namespace gnathion {

/// What quadratic elements on the same tets add to a solution on linear ones: the estimate, by
/// hierarchy, of the discretisation error of linear elements. The quadratic equations are not
/// factorised but iterated on by conjugate gradients from the linear solution, preconditioned by
/// the linear factor on the vertices and the diagonal blocks on the middles of edges (the two-level
/// splitting of Yserentant 1986, Bank 1996); a few iterations
/// estimate, many solve where ν is not near 1/2.
class QuadraticCorrection {
 public:
  /// Iterations that make an estimate; docs/evidence.md has its effectivity.
  static constexpr int kEstimate = 12;

  /// `linear`: a solver on linear elements; must outlive this.
  QuadraticCorrection(const StaticSolver& linear, Progress& progress);

  /// `u`: 3n×k, mm, k solutions of prescribed motions on the vertices (row 3i+axis). Returns 3n×k,
  /// mm, at the vertices: to be added to u; its size estimates the error of u. Stops after
  /// `iterations`, or when the residual is `tolerance` of the first.
  /// Throws Error(numeric) when the result is not finite, Error(cancelled).
  Eigen::MatrixXd correct(const Eigen::MatrixXd& u, Progress& progress, int iterations = kEstimate,
                          double tolerance = 1e-10) const;

 private:
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Columns stiffness_times(const Columns& u) const;
  Columns preconditioned(const Columns& residual) const;
  Columns spread(const Columns& at_vertices) const;
  Columns restricted(const Columns& at_nodes) const;
  void keep_free(Columns& field) const;

  const StaticSolver& linear_;
  ElementMesh elements_;  ///< quadratic
  Supports supports_;
  StiffnessMatrix K_;
  std::vector<Eigen::Matrix3d> middle_inverse_;  ///< of K's diagonal blocks on the free part
};

}  // namespace gnathion
