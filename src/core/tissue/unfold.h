#pragma once

#include "tissue/intermediate_mesh.h"

namespace gnathion {

/// What unfolding changed.
struct Unfolding {
  IntermediateMesh region;  ///< same vertices and triangles, some places moved
  int moved_count = 0;
  double largest_move = 0;  ///< mm
};

/// Smooths a region where the face is folded onto itself (the corners of a closed mouth in a scan,
/// a nostril's edge) until every vertex normal has all its triangles before it and no edge is
/// sharper than a right angle: a vertex with a triangle that faces away has no tissue below it in
/// any direction. Only such vertices and those around them move (more rings of them the longer a
/// fold lasts), never the held rim. The tissue is meshed below the smoothed surface; displacements
/// go back to the face by index, so the face itself is not smoothed. Folds that remain after
/// `rounds` are left to the generator to refuse.
Unfolding unfold(const IntermediateMesh& region, int rounds = 100);

}  // namespace gnathion
