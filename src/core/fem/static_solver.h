#pragma once

#include <vector>

#include "base/progress.h"
#include "fem/spd_factor.h"
#include "fem/stiffness.h"

namespace gnathion {

/// A solution and how well it satisfies the equations.
struct StaticSolution {
  Points displacements;          ///< n×3, mm
  double relative_residual = 0;  ///< ‖Qᵀ(f − K u)‖ / ‖Qᵀ(f − K u_d)‖; 0 for no load
};

/// Linear statics of one mesh under one set of supports: K u = f with u given at the fixed and
/// attached nodes and, along the bone's normal, at the sliding ones: u = u_d + Q q. The factor of
/// QᵀKQ is made once; each question costs a back-solve.
class StaticSolver {
 public:
  /// Largest relative residual that solve() lets pass.
  static constexpr double kResidualLimit = 1e-8;

  /// supports: one a node of `elements`.
  /// Throws Error(numeric) for an inverted tet, for a mesh that no support holds, and for a K that
  /// is not positive definite; Error(case_file) for a material out of range.
  StaticSolver(ElementMesh elements, TissueMaterials materials, Supports supports,
               Progress& progress, SpdBackend backend = default_spd_backend());

  /// `prescribed`: n×3, mm, read where a support prescribes (prescribed_part()). `forces`: n×3, N,
  /// read at nodes that are not held.
  /// Throws Error(numeric) when the relative residual exceeds kResidualLimit or the result is not
  /// finite.
  StaticSolution solve(const Points& prescribed, const Points& forces) const;

  /// The same for k loads at once: each of the k columns is one n×3 field, row-major (entry
  /// 3i+axis). Returns 3n×k.
  Eigen::MatrixXd solve_columns(const Eigen::MatrixXd& prescribed,
                                const Eigen::MatrixXd& forces) const;

  const ElementMesh& elements() const { return elements_; }
  const TissueMaterials& materials() const { return materials_; }
  const StiffnessMatrix& stiffness() const { return K_; }
  const Supports& supports() const { return supports_; }
  const FreePart& free_part() const { return free_; }
  const SpdFactor& factor() const { return *factor_; }      ///< of QᵀKQ
  const std::vector<int>& order() const { return order_; }  ///< its elimination order

 private:
  ElementMesh elements_;
  TissueMaterials materials_;
  StiffnessMatrix K_;
  Supports supports_;
  FreePart free_;
  std::vector<int> order_;
  std::unique_ptr<SpdFactor> factor_;
};

}  // namespace gnathion
