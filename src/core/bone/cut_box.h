#pragma once

#include "bone/osteotomy.h"
#include "geometry/rigid_motion.h"

namespace gnathion {

/// A cut as the box that it takes or saws away: of a plate the columns of `axes` are its width,
/// its height and its normal, and the third half extent is half the kerf.
/// Throws Error(anatomy) when something is not finite, the axes are not orthonormal (a plate's
/// directions are zero or parallel), or the box has no extent along one of them.
BoxCut box_of(const BoundedCut& cut);

/// The cut with its place, its directions and its seed moved along.
BoundedCut moved(const BoundedCut& cut, const RigidMotion& motion);

/// The motion that takes `from` to the place and directions of `to`, of the same kind.
RigidMotion motion_between(const BoundedCut& from, const BoundedCut& to);

/// The cut with other half extents, mm, in the order of box_of(); the centre and the seed stay.
BoundedCut with_half_extents(const BoundedCut& cut, const Eigen::Vector3d& half_extents);

}  // namespace gnathion
