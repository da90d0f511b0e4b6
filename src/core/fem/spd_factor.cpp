#include "fem/spd_factor.h"

#include <metis.h>

#include <Eigen/SparseCholesky>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <variant>

#include "base/error.h"
#ifdef GNATHION_HAS_CHOLMOD
#include <cholmod.h>
extern "C" void openblas_set_num_threads(int);
#endif

namespace gnathion {
namespace {

[[noreturn]] void refuse_matrix() {
  throw Error(ErrorKind::numeric, "stiffness matrix", "it is not positive definite",
              "check that the region has a fixed rim and that no tetrahedron is inverted");
}

void require_finite(const Eigen::SparseMatrix<double>& lower) {
  const Eigen::Map<const Eigen::VectorXd> values(lower.valuePtr(), lower.nonZeros());
  if (!values.allFinite()) refuse_matrix();
}

#ifdef GNATHION_HAS_CHOLMOD
/// CHOLMOD's workspace and factor, freed together.
class CholmodFactor {
 public:
  CholmodFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order) {
    static std::once_flag one_thread;  // never while another factor is at work
    std::call_once(one_thread, [] { openblas_set_num_threads(1); });
    cholmod_start(&common_);
    common_.supernodal = CHOLMOD_SUPERNODAL;
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
    common_.postorder = 1;
    common_.print = 0;
    cholmod_sparse A = view(lower);
    std::vector<int> permutation = order;
    factor_ = cholmod_analyze_p(&A, permutation.data(), nullptr, 0, &common_);
    if (factor_ != nullptr) cholmod_factorize(&A, factor_, &common_);
    const bool failed = factor_ == nullptr || common_.status != CHOLMOD_OK;
    if (failed) {
      free();
      refuse_matrix();
    }
  }
  void refactor(const Eigen::SparseMatrix<double>& lower) {
    cholmod_sparse A = view(lower);
    common_.status = CHOLMOD_OK;
    cholmod_factorize(&A, factor_, &common_);
    if (common_.status != CHOLMOD_OK) refuse_matrix();
  }
  ~CholmodFactor() { free(); }
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) {
    cholmod_dense b{};
    b.nrow = b.d = static_cast<std::size_t>(B.rows());
    b.ncol = static_cast<std::size_t>(B.cols());
    b.nzmax = b.nrow * b.ncol;
    b.x = const_cast<double*>(B.data());  // CHOLMOD's interface has no const; it only reads b
    b.xtype = CHOLMOD_REAL;
    // Solving writes into the workspace, and a model may be asked from several threads.
    const std::lock_guard lock(mutex_);
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor_, &b, &common_);
    if (x == nullptr) throw std::bad_alloc();
    Eigen::MatrixXd X = Eigen::Map<Eigen::MatrixXd>(static_cast<double*>(x->x), B.rows(), B.cols());
    cholmod_free_dense(&x, &common_);
    return X;
  }

 private:
  static cholmod_sparse view(const Eigen::SparseMatrix<double>& lower) {
    cholmod_sparse A{};
    A.nrow = A.ncol = static_cast<std::size_t>(lower.rows());
    A.nzmax = static_cast<std::size_t>(lower.nonZeros());
    A.p = const_cast<int*>(lower.outerIndexPtr());
    A.i = const_cast<int*>(lower.innerIndexPtr());
    A.x = const_cast<double*>(lower.valuePtr());
    A.stype = -1;
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_REAL;
    A.sorted = A.packed = 1;
    return A;
  }
  void free() {
    if (factor_ != nullptr) cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }

  std::mutex mutex_;
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};
#endif

/// Eigen's factor of the reordered matrix.
class EigenFactor {
 public:
  EigenFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order) {
    Eigen::VectorXi place(lower.rows());  // place[i]: when i is eliminated
    for (int k = 0; k < lower.rows(); ++k) place[order[k]] = k;
    permutation_ = Eigen::PermutationMatrix<Eigen::Dynamic>(place);
    refactor(lower);
  }
  void refactor(const Eigen::SparseMatrix<double>& lower) {
    Eigen::SparseMatrix<double> reordered(lower.rows(), lower.cols());
    reordered.selfadjointView<Eigen::Lower>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(permutation_);
    llt_.compute(reordered);
    if (llt_.info() != Eigen::Success) refuse_matrix();
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const {
    const Eigen::MatrixXd reordered = llt_.solve(permutation_ * B);
    return permutation_.transpose() * reordered;
  }

 private:
  Eigen::PermutationMatrix<Eigen::Dynamic> permutation_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> llt_;
};

}  // namespace

struct SpdFactor::Implementation {
#ifdef GNATHION_HAS_CHOLMOD
  std::unique_ptr<CholmodFactor> cholmod;
#endif
  std::unique_ptr<EigenFactor> eigen;
};

SpdBackend default_spd_backend() {
#ifdef GNATHION_HAS_CHOLMOD
  return SpdBackend::cholmod;
#else
  return SpdBackend::eigen;
#endif
}

SpdFactor::SpdFactor(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& order,
                     SpdBackend backend)
    : implementation_(std::make_unique<Implementation>()) {
  require_finite(lower);
  if (lower.rows() == 0) return;  // everything is prescribed; CHOLMOD calls that a failure
#ifdef GNATHION_HAS_CHOLMOD
  if (backend == SpdBackend::cholmod) {
    implementation_->cholmod = std::make_unique<CholmodFactor>(lower, order);
    return;
  }
#else
  if (backend == SpdBackend::cholmod) {
    throw Error(ErrorKind::numeric, "solver", "this program was built without CHOLMOD",
                "use the Eigen backend, or build with libsuitesparse-dev installed");
  }
#endif
  implementation_->eigen = std::make_unique<EigenFactor>(lower, order);
}

SpdFactor::~SpdFactor() = default;
SpdFactor::SpdFactor(SpdFactor&&) noexcept = default;
SpdFactor& SpdFactor::operator=(SpdFactor&&) noexcept = default;

void SpdFactor::refactor(const Eigen::SparseMatrix<double>& lower) {
  require_finite(lower);
  if (lower.rows() == 0) return;
#ifdef GNATHION_HAS_CHOLMOD
  if (implementation_->cholmod) {
    implementation_->cholmod->refactor(lower);
    return;
  }
#endif
  implementation_->eigen->refactor(lower);
}

Eigen::MatrixXd SpdFactor::solve(const Eigen::MatrixXd& B) const {
  if (B.size() == 0) return B;
#ifdef GNATHION_HAS_CHOLMOD
  if (implementation_->cholmod) return implementation_->cholmod->solve(B);
#endif
  return implementation_->eigen->solve(B);
}

std::vector<int> nested_dissection(const std::vector<int>& start, const std::vector<int>& column) {
  idx_t n = static_cast<idx_t>(start.size()) - 1;
  std::vector<idx_t> first(1, 0), neighbour;
  neighbour.reserve(column.size());
  for (idx_t i = 0; i < n; ++i) {
    for (int p = start[i]; p < start[i + 1]; ++p) {
      if (column[p] != i) neighbour.push_back(column[p]);
    }
    first.push_back(static_cast<idx_t>(neighbour.size()));
  }
  std::vector<idx_t> order(static_cast<std::size_t>(n)), place(static_cast<std::size_t>(n));
  if (n > 0) {
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = 1;
    if (METIS_NodeND(&n, first.data(), neighbour.data(), nullptr, options, order.data(),
                     place.data()) != METIS_OK) {
      throw Error(ErrorKind::numeric, "stiffness matrix", "METIS could not order its graph",
                  "report this case: it is a fault of the program");
    }
  }
  return {order.begin(), order.end()};
}

}  // namespace gnathion
