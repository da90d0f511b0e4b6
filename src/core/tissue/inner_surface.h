#pragma once

#include <array>
#include <vector>

#include "tissue/intermediate_mesh.h"
#include "tissue/soft_tissue_mesh.h"

namespace gnathion {

/// The inner surface of the tissue: for every interior edge (b, c) between triangles f and g the
/// triangles (c_f, c_g, b') and (c_f, c', c_g), in the order of region.edges. 2 E_i × 3 nodes of
/// the mesh, counter-clockwise seen from within the head (outward for the tissue).
Triangles inner_surface(const IntermediateMesh& region, const SoftTissueMesh& tissue);

/// Where tissue would lie twice: pairs of triangles that meet elsewhere than in a node or edge that
/// both have.
struct InnerSurfaceCrossings {
  std::vector<std::array<int, 2>>
      with_itself;  ///< two triangles of the inner surface, first < second
  std::vector<std::array<int, 2>> with_skin;  ///< one of the inner surface, one of region.mesh
  bool none() const { return with_itself.empty() && with_skin.empty(); }
};

/// All of them, anywhere, by exact predicates; in ascending order. `inner`: as inner_surface().
InnerSurfaceCrossings inner_surface_crossings(const IntermediateMesh& region,
                                              const Triangles& inner, const SoftTissueMesh& tissue);

}  // namespace gnathion
