#include "bone/cut_box.h"

#include <Eigen/Geometry>
#include <string>

#include "base/error.h"

namespace gnathion {
namespace {

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw Error(ErrorKind::anatomy, "segment", problem, remedy);
}

BoxCut as_box(const BoxCut& cut) {
  return cut;
}

BoxCut as_box(const PlateCut& cut) {
  const Eigen::Vector3d normal = cut.normal.normalized();
  const Eigen::Vector3d across = cut.in_plane - cut.in_plane.dot(normal) * normal;
  if (!(cut.normal.norm() > 1e-9) || !(across.norm() > 1e-6 * cut.in_plane.norm())) {
    refuse("the plate's normal or in-plane direction is zero, or both are parallel",
           "give two directions at right angles");
  }
  BoxCut box;
  box.centre = cut.centre;
  box.axes.col(0) = across.normalized();
  box.axes.col(1) = normal.cross(box.axes.col(0));
  box.axes.col(2) = normal;
  box.half_extents = Eigen::Vector3d(cut.half_width, cut.half_height, 0.5 * cut.kerf);
  return box;
}

}  // namespace

BoxCut box_of(const BoundedCut& cut) {
  BoxCut box = std::visit([](const auto& c) { return as_box(c); }, cut);
  const bool orthonormal =
      (box.axes.transpose() * box.axes - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-6;
  if (!box.centre.allFinite() || !box.axes.allFinite() || !orthonormal) {
    refuse("the cut's centre is not finite or its axes are not orthonormal",
           "give unit axes at right angles");
  }
  if (!(box.half_extents.minCoeff() > 0) || !box.half_extents.allFinite()) {
    refuse("the cut has no extent along one of its axes",
           "give a positive width, height and depth (for a plate: kerf)");
  }
  return box;
}

BoundedCut moved(const BoundedCut& cut, const RigidMotion& motion) {
  if (const auto* box = std::get_if<BoxCut>(&cut)) {
    return BoxCut{motion(box->centre), motion.rotation * box->axes, box->half_extents};
  }
  PlateCut plate = std::get<PlateCut>(cut);
  plate.centre = motion(plate.centre);
  plate.normal = motion.rotation * plate.normal;
  plate.in_plane = motion.rotation * plate.in_plane;
  plate.seed = motion(plate.seed);
  return plate;
}

RigidMotion motion_between(const BoundedCut& from, const BoundedCut& to) {
  const BoxCut a = box_of(from), b = box_of(to);
  RigidMotion motion;
  motion.rotation = b.axes * a.axes.transpose();
  motion.translation = b.centre - motion.rotation * a.centre;
  return motion;
}

BoundedCut with_half_extents(const BoundedCut& cut, const Eigen::Vector3d& half_extents) {
  if (const auto* box = std::get_if<BoxCut>(&cut)) {
    return BoxCut{box->centre, box->axes, half_extents};
  }
  PlateCut plate = std::get<PlateCut>(cut);
  plate.half_width = half_extents.x();
  plate.half_height = half_extents.y();
  plate.kerf = 2 * half_extents.z();
  return plate;
}

}  // namespace gnathion
