#include "fem/motion_path.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace gnathion {
namespace {

/// ∫₀ᵗ exp(s θ [a]) ds = t I + (1 − cos tθ)/θ [a] + (t − sin(tθ)/θ) [a]²: where the point at the
/// origin has got to when its screw's velocity at t = 0 was a unit vector.
Eigen::Matrix3d travelled(const Eigen::AngleAxisd& turn, double t) {
  const double angle = turn.angle();
  Eigen::Matrix3d cross;
  const Eigen::Vector3d& a = turn.axis();
  cross << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  const double half = std::sin(t * angle / 2);
  const double first = angle < 1e-8 ? t * t * angle / 2 : 2 * half * half / angle;
  const double second = angle < 1e-8 ? 0 : t - std::sin(t * angle) / angle;
  return t * Eigen::Matrix3d::Identity() + first * cross + second * cross * cross;
}

}  // namespace

RigidMotion on_screw(const RigidMotion& from, const RigidMotion& to, double t) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.rotation * from.rotation.transpose()));
  const Eigen::Vector3d shift = to.translation - turn * from.translation;
  const Eigen::Vector3d velocity = travelled(turn, 1).inverse() * shift;
  const Eigen::Matrix3d part = Eigen::AngleAxisd(t * turn.angle(), turn.axis()).toRotationMatrix();
  RigidMotion motion;
  motion.rotation = part * from.rotation;
  motion.translation = part * from.translation + travelled(turn, t) * velocity;
  return motion;
}

MotionPath bone_path(const Points& nodes, const Supports& supports, std::vector<RigidMotion> from,
                     std::vector<RigidMotion> to) {
  return [&nodes, &supports, from = std::move(from), to = std::move(to)](double t) {
    if (t == 1) return bone_displacements(nodes, supports, to);
    std::vector<RigidMotion> motions;
    for (std::size_t b = 0; b < to.size(); ++b) motions.push_back(on_screw(from[b], to[b], t));
    return bone_displacements(nodes, supports, motions);
  };
}

MotionPath bone_path(const Points& nodes, const Supports& supports, std::vector<RigidMotion> to) {
  std::vector<RigidMotion> rest(to.size());
  return bone_path(nodes, supports, std::move(rest), std::move(to));
}

}  // namespace gnathion
