#pragma once

#include <Eigen/Core>
#include <vector>

#include "fem/material.h"
#include "geometry/mesh_types.h"

namespace gnathion {

/// The stiffness matrix K of a mesh of n nodes, N/mm: symmetric, 3n×3n, kept as one 3×3 block for
/// every pair of nodes that share an element. Row i's blocks stand in blocks[start[i] …
/// start[i+1]), columns ascending.
struct StiffnessMatrix {
  std::vector<int> start;   ///< n + 1
  std::vector<int> column;  ///< the column node of each block
  std::vector<Eigen::Matrix3d> blocks;

  int node_count() const { return static_cast<int>(start.size()) - 1; }
  /// K u. u: n×3, mm. Returns n×3 forces, N.
  Points operator*(const Points& u) const;
};

/// The four gradients of a linear tet's shape functions (rows, 1/mm) and its volume (mm³).
struct LinearTet {
  Eigen::Matrix<double, 4, 3> gradients;
  double volume = 0;
};
LinearTet linear_tet(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d);

/// K of linear (constant-strain) tetrahedra with Hooke's law and Cauchy strain:
///   K_ab = V (λ g_a g_bᵀ + μ g_b g_aᵀ + μ (g_a·g_b) I),
/// g the gradients of the shape functions. Every node of the mesh must belong to a tet.
/// Throws Error(numeric) naming the first tet whose volume is not positive: K would not be
/// positive definite, and a solver might not say so.
StiffnessMatrix stiffness_matrix(const TetMesh& mesh, const ElasticMaterial& material);

}  // namespace gnathion
