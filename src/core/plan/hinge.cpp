#include "plan/hinge.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gnathion {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

/// A right-handed turn about it closes the mouth: the chin lies before the axis, which the closing
/// turns from left to right.
Eigen::Vector3d closing_axis(const HingeAxis& hinge) {
  return (hinge.right - hinge.left).normalized();
}

}  // namespace

double hinge_angle(const RigidMotion& motion, const HingeAxis& hinge) {
  // The twist of the swing–twist decomposition; a turn about the axis put before the motion adds to
  // it exactly.
  const Eigen::Quaterniond q(motion.rotation);
  const double angle = 2 * std::atan2(q.vec().dot(closing_axis(hinge)), q.w());
  return std::remainder(angle, 2 * std::numbers::pi) / kRadian;
}

RigidMotion with_hinge_angle(const RigidMotion& motion, const HingeAxis& hinge, double degrees) {
  const double more = degrees - hinge_angle(motion, hinge);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(more * kRadian, closing_axis(hinge)).toRotationMatrix();
  const Eigen::Vector3d centre = hinge.middle();
  return {turn * motion.rotation, turn * (motion.translation - centre) + centre};
}

}  // namespace gnathion
