#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "geometry/rigid_motion.h"

namespace gnathion {

/// Where a moved segment runs into other bone.
struct Collision {
  int segment = 0;   ///< that moves
  int other = -1;    ///< another segment, always after this one; −1: the bone that stays
  double depth = 0;  ///< mm, the deepest
  Eigen::Vector3d deepest = Eigen::Vector3d::Zero();  ///< mm, LPS
  Points places;           ///< k×3, mm, LPS: vertices of either bone inside the other
  Eigen::VectorXd depths;  ///< k, mm, of the places: each from the other's surface
};

struct CollisionOptions {
  /// mm; less is no collision: the width of a saw's kerf, and what the halves of a cut that touch
  /// at rest lie inside each other by rounding.
  double tolerance = 0.3;
  /// Of a bone's vertices that are looked at, evenly spread; 0: all. Less is quicker: what is found
  /// is then too shallow by no more than the bone's shape between neighbours that are looked at.
  int most_vertices = 20000;
};

/// The bones of a case at rest, prepared for being asked at every motion whether segments run into
/// one another or into the bone that stays. A vertex of one bone inside the other counts with its
/// distance to that one's surface. Immutable; may be asked from several threads.
class CollisionModel {
 public:
  /// All surfaces closed, outward, LPS mm, where they are before any motion.
  CollisionModel(const std::vector<const TriangleMesh*>& segments, const TriangleMesh& remainder,
                 const CollisionOptions& options = {});
  ~CollisionModel();
  CollisionModel(CollisionModel&&) noexcept;

  /// poses: one a segment. Those that touch, the deepest first.
  std::vector<Collision> collisions(std::span<const RigidMotion> poses) const;

  /// The segment that a line of sight meets first, −1 where there is none or where the bone that
  /// stays is before it. direction: of unit length. Poses as above.
  int segment_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                 std::span<const RigidMotion> poses) const;

 private:
  struct Bone;
  std::vector<std::unique_ptr<const Bone>> bones_;  ///< the segments, last the bone that stays
  struct Pair;
  std::vector<Pair> pairs_;
  CollisionOptions options_;
};

}  // namespace gnathion
