#pragma once

#include "fem/static_solver.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

/// Displacements as a linear function of a segment's pose: with displacement transfer, attached
/// nodes move by u = (R−I)(x−c) + (m(c)−c), linear in the nine entries of R−I and the three of the
/// translation of the centre c, and so is the whole solution. It equals the direct solve to
/// rounding, at the cost of one small matrix-vector product (method.md, 6).
class ResponseBasis {
 public:
  ResponseBasis() = default;
  /// `columns`: 3k×12 for k points (row 3i+axis; columns: R−I row by row, then the translation).
  ResponseBasis(Eigen::Matrix<double, Eigen::Dynamic, 12> columns, const Eigen::Vector3d& centre);

  /// k×3, mm. Writes into `out`, which is resized when it has another size.
  void displacements(const RigidMotion& motion, Points& out) const;

  const Eigen::Matrix<double, Eigen::Dynamic, 12>& columns() const { return columns_; }
  const Eigen::Vector3d& centre() const { return centre_; }
  Eigen::Index point_count() const { return columns_.rows() / 3; }

 private:
  Eigen::Matrix<double, Eigen::Dynamic, 12> columns_;
  Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
};

/// The basis of all nodes of the solver's mesh: twelve back-solves. `nodes`: the rest positions,
/// n×3; `centre`: c, mm, LPS, best within the segment (small numbers cancel least).
ResponseBasis response_basis(const StaticSolver& solver, const Points& nodes,
                             const Eigen::Vector3d& centre);

/// Displacements under force transfer (paper, eq. 4): the force at a forced point with normal n is
/// F_i = F cos θ_i = |F| F̂ F̂ᵀ n, linear in the six entries of the symmetric |F| F̂F̂ᵀ. |F| is what
/// makes the forced points follow the bone on average: their mean displacement along the motion
/// equals the motion's length. (The paper does not say how |F| follows from the motion.)
class ForceBasis {
 public:
  ForceBasis() = default;
  /// `columns`: 3k×6 (xx, yy, zz, yz, xz, xy), `forced`: which of the k points are forced.
  ForceBasis(Eigen::Matrix<double, Eigen::Dynamic, 6> columns, std::vector<int> forced);

  struct Result {
    Points displacements;  ///< k×3, mm
    double force_N = 0;    ///< |F| at each forced point, in newtons
  };
  /// Throws Error(numeric) when no force along the motion moves the forced points along it.
  Result displacements(const Eigen::Vector3d& translation) const;

  const Eigen::Matrix<double, Eigen::Dynamic, 6>& columns() const { return columns_; }

 private:
  Eigen::Matrix<double, Eigen::Dynamic, 6> columns_;
  std::vector<int> forced_;
};

/// The force basis of all nodes. `forced`: node numbers; `normals`: one unit normal for each, rows.
ForceBasis force_basis(const StaticSolver& solver, const std::vector<int>& forced,
                       const Points& normals);

}  // namespace gnathion
