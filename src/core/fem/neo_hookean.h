#pragma once

#include <limits>

#include "fem/stiffness.h"

namespace gnathion {

/// Where the tissue is compressed most.
struct Compression {
  double volume_ratio = std::numeric_limits<double>::infinity();  ///< J = det F, deformed over rest
  Eigen::Index tet = -1;
  Eigen::RowVector3d place = {0, 0, 0};  ///< the middle of that tet at rest, mm, LPS
};

/// Tissue that may deform much: the compressible neo-Hookean law in the form that CalculiX and
/// Abaqus use,
///   W = μ/2 (J^(−2/3) tr FᵀF − 3) + κ/2 (J − 1)²,  F = I + ∂u/∂X,  J = det F,
/// with μ and κ of the same E and ν as Hooke's law, with which it agrees at small strain. Total
/// Lagrangian: all integrals are over the mesh at rest. A state with J <= 0 at an integration
/// point is inadmissible: the tissue would be turned inside out there.
///
/// κ = λ + 2μ/3. As in stiffness_matrix(), λ sees the element's mean dilatation, which changes
/// nothing in linear elements and keeps quadratic ones from locking:
///   W = μ/2 (J^(−2/3) tr FᵀF − 3) + μ/3 (J − 1)² + λ/2 (J̄ − 1)²,  J̄ = Σ V_q J_q / Σ V_q,
/// so that the tangent at rest is K.
///
/// Strains are formed from ∂u/∂X and not from F, so that a motion of 1e-9 mm keeps its digits.
class NeoHookeanTissue {
 public:
  /// Both must outlive this. Throws Error(case_file) for a material out of range.
  NeoHookeanTissue(const ElementMesh& mesh, const TissueMaterials& materials);

  /// The elastic energy, N·mm, of the displacements u (n×3, mm); infinite for an inadmissible u.
  double energy(const Points& u) const;
  /// The energy's gradient by u, n×3, N: the force that each node needs to stay where it is.
  /// Returns whether u is admissible; where it is not, `force` is of no use.
  [[nodiscard]] bool internal_force(const Points& u, Points& force) const;
  /// Writes the second derivative of the energy by u into K, which has the pattern of
  /// empty_stiffness(), N/mm. u: admissible. `projected`: with the negative eigenvalues of each
  /// integration point's ∂²W/∂F² set to zero, so that K has no negative ones.
  void tangent(const Points& u, bool projected, StiffnessMatrix& K) const;
  /// The integration point with the smallest J.
  Compression most_compressed(const Points& u) const;

 private:
  const ElementMesh& mesh_;
  const TissueMaterials& materials_;
};

}  // namespace gnathion
