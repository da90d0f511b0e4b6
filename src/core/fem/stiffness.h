#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "fem/elements.h"
#include "fem/material.h"

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
  /// Adds one element's matrix: m nodes, 3m×3m, row-major blocks by node.
  template <int m>
  void add(const int* element, const Eigen::Matrix<double, 3 * m, 3 * m>& matrix);
};

/// K's pattern for a mesh, all blocks zero.
StiffnessMatrix empty_stiffness(const ElementMesh& mesh);

/// K of Hooke's law and Cauchy strain:
///   K_ab = Σ V_q (μ g_b g_aᵀ + μ (g_a·g_b) I) + λ/V d_a d_bᵀ,  d_a = Σ V_q g_a,  V = Σ V_q
/// over an element's integration points q, g the gradients of the shape functions. λ sees the
/// element's mean dilatation (after Nagtegaal, Parks and Rice 1974): in quadratic elements it would
/// else constrain four dilatations an element, which locks as ν nears 1/2 and is less accurate at
/// any ν of tissue (docs/evidence.md). Every node of the mesh must belong to an element.
/// Throws Error(numeric) naming the first tet whose volume is not positive: K would not be
/// positive definite, and a solver might not say so.
StiffnessMatrix stiffness_matrix(const ElementMesh& mesh, const TissueMaterials& materials);

/// The lower triangle of QᵀKQ, by compressed columns.
Eigen::SparseMatrix<double> free_stiffness(const StiffnessMatrix& K, const FreePart& free);

/// An order with little fill to eliminate the free part in, by nested dissection of the graph of
/// nodes: the components of a node share its neighbours, so that K's own graph is nine times the
/// work and no better.
std::vector<int> elimination_order(const StiffnessMatrix& K, const FreePart& free);

}  // namespace gnathion
