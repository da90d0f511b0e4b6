#include "plan/jaw_motion.h"

#include <Eigen/Geometry>
#include <numbers>

namespace gnathion {

RigidMotion rigid_motion(const JawMotion& motion, const Eigen::Vector3d& pivot) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  constexpr double kRadian = std::numbers::pi / 180;
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

}  // namespace gnathion
