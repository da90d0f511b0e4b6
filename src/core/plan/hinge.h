#pragma once

#include "plan/jaw_motion.h"

namespace gnathion {

/// The axis about which the lower jaw opens and closes: through the centres of both condyles.
/// Points: LPS, mm, not the same.
struct HingeAxis {
  Eigen::Vector3d right = Eigen::Vector3d::Zero();  ///< on the patient's right
  Eigen::Vector3d left = Eigen::Vector3d::Zero();

  Eigen::Vector3d middle() const { return (right + left) / 2; }
  bool operator==(const HingeAxis&) const = default;
};

/// Points nearer than this across the patient, mm, are no condyles.
inline constexpr double least_hinge_mm = 20;

/// How far a motion turns about the hinge's direction, in degrees; positive closes the mouth (the
/// chin rises), as pitch does. It is the twist of the rotation about that direction: for a turn
/// about the hinge alone its angle, for a translation 0.
double hinge_angle(const RigidMotion& motion, const HingeAxis& hinge);

/// `motion`, then the turn about the hinge (where it is without any motion) that makes its
/// hinge_angle() equal `degrees`: from rest exactly the opening or closing by that angle, after an
/// advancement the closing of the advanced jaw.
RigidMotion with_hinge_angle(const RigidMotion& motion, const HingeAxis& hinge, double degrees);

}  // namespace gnathion
