#pragma once

#include <span>

#include "fem/static_solver.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

/// Displacements as a linear function of the poses of one or several segments: with displacement
/// transfer, the bone moves a node tied to it by u = (R−I)(x−c) + (m(c)−c), linear in the nine
/// entries of R−I and the three of the translation of the centre c of its segment, and so is the
/// whole solution, sliding included. It equals the direct solve to rounding, at the cost of one
/// small matrix-vector product (method.md, 6).
class ResponseBasis {
 public:
  ResponseBasis() = default;
  /// `columns`: 3k×12s for k points and s segments (row 3i+axis; twelve columns a segment: R−I row
  /// by row, then the translation). centres: c of each segment.
  ResponseBasis(Eigen::MatrixXd columns, std::vector<Eigen::Vector3d> centres);

  /// k×3, mm, for one motion a segment. Writes into `out`, which is resized when it has another
  /// size.
  void displacements(std::span<const RigidMotion> motions, Points& out) const;

  const Eigen::MatrixXd& columns() const { return columns_; }
  const std::vector<Eigen::Vector3d>& centres() const { return centres_; }

 private:
  Eigen::MatrixXd columns_;
  std::vector<Eigen::Vector3d> centres_;
};

/// The basis of all nodes of the solver's mesh: twelve back-solves a segment. `centres`: c of each
/// segment, mm, LPS, best within it (small numbers cancel least).
ResponseBasis response_basis(const StaticSolver& solver,
                             const std::vector<Eigen::Vector3d>& centres);

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
