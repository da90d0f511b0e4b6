#pragma once

#include <functional>
#include <vector>

#include "fem/supports.h"

namespace gnathion {

/// How prescribed displacements are reached: t from 0 to 1 → n×3, mm, read where a support
/// prescribes (prescribed_part()). Must be continuous.
using MotionPath = std::function<Points(double t)>;

/// The screw that carries `from` into `to`, at t: a constant turn about and a constant shift along
/// one axis, the shortest such. t = 0 gives `from`, t = 1 `to`.
RigidMotion on_screw(const RigidMotion& from, const RigidMotion& to, double t);

/// The path of all nodes tied to bone, each bone on its screw: straight lines from start to end
/// would shrink a turned bone, and collapse it at 180°. from, to: one motion a body. `nodes` (n×3,
/// mm, LPS) and `supports` must outlive the path.
MotionPath bone_path(const Points& nodes, const Supports& supports, std::vector<RigidMotion> from,
                     std::vector<RigidMotion> to);
/// The same from rest.
MotionPath bone_path(const Points& nodes, const Supports& supports, std::vector<RigidMotion> to);

}  // namespace gnathion
