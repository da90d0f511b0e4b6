#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace gnathion {

enum class SpdBackend {
  cholmod,  ///< SuiteSparse CHOLMOD, supernodal, with the system's BLAS on one thread
  eigen,    ///< Eigen's SimplicialLLT: no other library needed, 2 to 10 times slower
};

/// CHOLMOD where the program was built with it, else Eigen.
SpdBackend default_spd_backend();

/// The Cholesky factor of a symmetric positive definite matrix: made once, asked often. One BLAS
/// thread, so that the same input gives the same bits. May be asked from several threads, one at a
/// time.
class SpdFactor {
 public:
  /// `lower`: the lower triangle of A, n×n. `order`: n, the elimination order (order[k] is
  /// eliminated k-th).
  /// Throws Error(numeric) when A is not positive definite or not finite.
  SpdFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order,
            SpdBackend backend = default_spd_backend());
  ~SpdFactor();
  SpdFactor(SpdFactor&&) noexcept;
  SpdFactor& operator=(SpdFactor&&) noexcept;

  /// Factorises another matrix with the same pattern: saves the analysis. Throws as the
  /// constructor; the factor must not be asked after that.
  void refactor(const Eigen::SparseMatrix<double>& lower);

  /// X with A X = B. B: n×k.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// An elimination order with little fill, by nested dissection (METIS) of a graph: neighbours of
/// node i in column[start[i] … start[i+1]); i itself may be among them.
std::vector<int> nested_dissection(const std::vector<int>& start, const std::vector<int>& column);

}  // namespace gnathion
