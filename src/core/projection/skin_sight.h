#pragma once

#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {

/// The CT's skin, ready to be looked at from anywhere. Made once (about a tenth of a second), asked
/// from any number of threads.
class SkinSight {
 public:
  /// skin: LPS mm, outward. Throws Error(anatomy) when it has no triangle.
  explicit SkinSight(TriangleMesh skin);

  const TriangleMesh& mesh() const { return mesh_; }
  const Points& normals() const { return normals_; }  ///< of the vertices, outward
  const BspTree& tree() const { return tree_; }

  /// Whether skin lies between the eye and a point, farther than `clear` mm before the point.
  bool hides(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, double clear) const;

 private:
  TriangleMesh mesh_;
  Points normals_;
  BspTree tree_;
};

}  // namespace gnathion
