#pragma once

#include "support/face_patch.h"
#include "support/head_scene.h"

namespace gnathion::bench {

/// A lower face's patch as a whole case: its chin over a moving bone 5 mm below, its rim held. The
/// tissue is 5 to 11 mm thick over the bone and has the default depth elsewhere.
inline Anatomy patch_anatomy(const TriangleMesh& skin) {
  const Eigen::Vector3d middle = skin.vertices.colwise().mean();
  const Eigen::Vector2d chin(middle[0], middle[1] - 18);
  Eigen::Index nearest = 0;
  (skin.vertices.leftCols(2).rowwise() - chin.transpose()).rowwise().norm().minCoeff(&nearest);
  const Eigen::Vector3d half(22, 13, 6);
  const Eigen::Vector3d centre(chin[0], chin[1], skin.vertices(nearest, 2) - 5 - half[2]);
  TriangleMesh bone = test::sphere({0, 0, 0}, 1, 4);
  bone.vertices = (bone.vertices * half.asDiagonal()).rowwise() + centre.transpose();
  Anatomy anatomy;
  anatomy.face = test::face_of(skin);
  anatomy.segments = {{"chin", bone, 0, centre}};
  anatomy.remainder = test::sphere(centre - Eigen::Vector3d(0, 0, 60), 10, 3);
  anatomy.bone = test::joined(bone, anatomy.remainder);
  return anatomy;
}

/// All of a patch: its rim is held.
inline RegionChoice whole_patch(const Anatomy& anatomy) {
  RegionChoice region;
  for (int v = 0; v < anatomy.face.mesh.surface.vertices.rows(); ++v) region.vertices.push_back(v);
  return region;
}

}  // namespace gnathion::bench
