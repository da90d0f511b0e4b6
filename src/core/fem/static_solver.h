#pragma once

#include <vector>

#include "base/progress.h"
#include "fem/spd_factor.h"
#include "fem/stiffness.h"

namespace gnathion {

/// What holds or moves a node (paper, 4.3.2).
enum class Support : unsigned char {
  free,      ///< moves as the elastic forces say
  fixed,     ///< does not move
  attached,  ///< moves with the bone segment
};

/// How a mesh of n nodes is held: one Support a node.
using Supports = std::vector<Support>;

/// A solution and how well it satisfies the equations.
struct StaticSolution {
  Points displacements;  ///< n×3, mm
  double relative_residual = 0;  ///< ‖f − K u‖ / ‖K_fd u_d − f‖ over the free nodes; 0 for no load
};

/// Linear statics of one mesh under one set of supports: K u = f with u given at the fixed and
/// attached nodes. The factor of K's free part is made once; each question costs a back-solve.
class StaticSolver {
 public:
  /// Largest relative residual that solve() lets pass.
  static constexpr double kResidualLimit = 1e-8;

  /// Throws Error(numeric) for an inverted tet, for a mesh that no support holds, and for a K that
  /// is not positive definite; Error(case_file) for a material out of range.
  StaticSolver(const TetMesh& mesh, const ElasticMaterial& material, Supports supports,
               Progress& progress, SpdBackend backend = default_spd_backend());

  /// `prescribed`: n×3, mm, read at attached nodes only. `forces`: n×3, N, read at free nodes only.
  /// Throws Error(numeric) when the relative residual exceeds kResidualLimit or the result is not
  /// finite.
  StaticSolution solve(const Points& prescribed, const Points& forces) const;

  /// The same for k loads at once: each of the k columns is one n×3 field, row-major (entry
  /// 3i+axis). Returns 3n×k.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& prescribed,
                                const Eigen::MatrixXd& forces) const;

  const StiffnessMatrix& stiffness() const { return K_; }
  const Supports& supports() const { return supports_; }
  int free_count() const { return static_cast<int>(free_nodes_.size()); }
  /// The mesh's index of each free node, ascending.
  const std::vector<int>& free_nodes() const { return free_nodes_; }

  /// The lower triangle of K's rows and columns of the free nodes (component 3i+axis of the i-th),
  /// and an order to eliminate them in.
  Eigen::SparseMatrix<double> free_part(std::vector<int>& order) const;

 private:
  StiffnessMatrix K_;
  Supports supports_;
  std::vector<int> free_nodes_;
  std::vector<int> free_index_;  ///< n, place among the free nodes, −1 for the others
  std::unique_ptr<SpdFactor> factor_;
};

}  // namespace gnathion
