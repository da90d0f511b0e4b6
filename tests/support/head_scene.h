#pragma once

#include "prediction/anatomy.h"
#include "support/solids.h"

namespace gnathion::test {

/// A face that is in no file.
inline Face face_of(const TriangleMesh& surface) {
  Face face{{}, ObjDocument::of_surface(surface, "skin"), {}, false};
  face.mesh = face.document.mesh();
  return face;
}

inline const Eigen::Vector3d head_chin(0, -80, 0);         ///< on the skin, over the segment
inline const Eigen::Vector3d head_segment_at(0, -58, 0);   ///< the segment's centre
inline const Eigen::Vector3d head_cheek_bone(35, -50, 0);  ///< fixed bone, on the left

/// A head of balls in LPS mm: skin of 80 mm radius about the origin, a ball of moving bone 10 mm
/// below its front, one of fixed bone 7 mm below the skin to the left of it, and a deep skull.
inline Anatomy head_scene() {
  Anatomy head;
  head.face = face_of(sphere({0, 0, 0}, 80, 5));
  head.segments = {{"chin", sphere(head_segment_at, 12, 3), 0, head_segment_at}};
  head.remainder = joined(sphere({0, 0, 0}, 40, 3), sphere(head_cheek_bone, 12, 3));
  head.bone = joined(head.segments[0].mesh, head.remainder);
  return head;
}

}  // namespace gnathion::test
