#include "plan/jaw_motion.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gnathion {

namespace {

constexpr double kRadian = std::numbers::pi / 180;

/// R = Rz(yaw) Ry(−roll) Rx(−pitch). The last angle is read from what is left of R once the first
/// is undone: that stays exact where cos(roll) vanishes (Shoemake 1994, Euler angle conversion).
void set_turns(JawMotion& motion, const Eigen::Matrix3d& R) {
  const double cos_roll = std::hypot(R(0, 0), R(1, 0));
  const double yaw = cos_roll > 0 ? std::atan2(R(1, 0), R(0, 0)) : 0;
  const double s = std::sin(yaw), c = std::cos(yaw);
  const double about_x = std::atan2(s * R(0, 2) - c * R(1, 2), c * R(1, 1) - s * R(0, 1));
  motion.pitch_deg = -about_x / kRadian;
  motion.roll_deg = std::atan2(R(2, 0), cos_roll) / kRadian;
  motion.yaw_deg = yaw / kRadian;
}

}  // namespace

RigidMotion rigid_motion(const JawMotion& motion, const Eigen::Vector3d& pivot) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  // The chin lies anterior (−y) of the pivot: turning about +x by a positive angle would lower it,
  // and turning about +y by one would lower the left side.
  const AngleAxisd pitch(-motion.pitch_deg * kRadian, Vector3d::UnitX());
  const AngleAxisd roll(-motion.roll_deg * kRadian, Vector3d::UnitY());
  const AngleAxisd yaw(motion.yaw_deg * kRadian, Vector3d::UnitZ());
  RigidMotion rigid;
  rigid.rotation = (yaw * roll * pitch).toRotationMatrix();
  rigid.translation =
      pivot - rigid.rotation * pivot + Vector3d(motion.left_mm, -motion.forward_mm, motion.up_mm);
  return rigid;
}

JawMotion jaw_motion(const RigidMotion& rigid, const Eigen::Vector3d& pivot) {
  const Eigen::Vector3d shift = rigid(pivot) - pivot;
  JawMotion motion{.forward_mm = -shift.y(), .up_mm = shift.z(), .left_mm = shift.x()};
  set_turns(motion, rigid.rotation);
  return motion;
}

JawMotion about_pivot(const JawMotion& motion, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to) {
  if (from == to) return motion;
  JawMotion told = motion;  // its angles stay as they are, to the bit
  const Eigen::Vector3d shift = rigid_motion(motion, from)(to) - to;
  told.forward_mm = -shift.y();
  told.up_mm = shift.z();
  told.left_mm = shift.x();
  return told;
}

JawMotion turned(const JawMotion& motion, const Eigen::Vector3d& axis, double degrees) {
  JawMotion result = motion;
  if (degrees == 0) return result;
  const Eigen::Matrix3d before = rigid_motion(motion, Eigen::Vector3d::Zero()).rotation;
  set_turns(result, Eigen::AngleAxisd(degrees * kRadian, axis).toRotationMatrix() * before);
  return result;
}

}  // namespace gnathion
