#pragma once

#include "geometry/rigid_motion.h"

namespace gnathion {

/// How a jaw segment is moved, in a surgeon's words. Translations in mm along the patient's axes,
/// rotations in degrees about axes through a stated pivot, in this order: pitch, roll, yaw (each
/// about the patient's axes, not the turned ones), then the translation.
struct JawMotion {
  double forward_mm = 0;  ///< towards anterior (−y in LPS)
  double up_mm = 0;       ///< towards superior (+z)
  double left_mm = 0;     ///< towards the patient's left (+x)
  double pitch_deg = 0;   ///< about left–right; positive lifts the chin
  double roll_deg = 0;    ///< about front–back; positive lifts the patient's left side
  double yaw_deg = 0;     ///< about the vertical; positive turns the chin to the patient's left

  bool operator==(const JawMotion&) const = default;
};

/// The same as a rigid motion in LPS mm. `pivot`: LPS, mm.
RigidMotion rigid_motion(const JawMotion& motion, const Eigen::Vector3d& pivot);

/// The motion in words that gives `rigid` about `pivot` (LPS, mm): the inverse of rigid_motion(),
/// exact to rounding for every rotation. Roll is within ±90°, pitch and yaw within ±180°; at a roll
/// of ±90°, where pitch and yaw turn about the same axis, all of it is pitch.
JawMotion jaw_motion(const RigidMotion& rigid, const Eigen::Vector3d& pivot);

/// The same motion of the bone told about another pivot (both LPS, mm).
JawMotion about_pivot(const JawMotion& motion, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to);

/// `motion`, then a turn by `degrees`, right-handed, about an axis through the pivot where it is by
/// now. axis: LPS, of unit length. The translation stays.
JawMotion turned(const JawMotion& motion, const Eigen::Vector3d& axis, double degrees);

}  // namespace gnathion
