#pragma once

#include "geometry/mesh_types.h"

namespace gnathion {

/// The centres of the heads of the mandible, LPS, mm.
struct Condyles {
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  Eigen::Vector3d left = Eigen::Vector3d::Zero();
};

/// Finds the condyles of the mandible: its upper rear ends on both sides of the jaw's own middle.
/// bone: closed, LPS mm, before any cut, its connected pieces apart. on_mandible: a point at or
/// near the mandible's surface, mm: that of the chin, say.
/// Throws Error(anatomy) when the jaw and the skull are one piece at this bone level, when the CT
/// ends below the condyles, and when the piece's ends do not lie as two condyles do; the remedy
/// says what to do.
Condyles find_condyles(const TriangleMesh& bone, const Eigen::Vector3d& on_mandible);

}  // namespace gnathion
