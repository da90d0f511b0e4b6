#pragma once

#include <optional>

#include "geometry/bsp_tree.h"
#include "geometry/rigid_motion.h"
#include "geometry/triangle_mesh.h"
#include "registration/prominence.h"

namespace gnathion {

/// The CT's skin, ready to be fitted to. Made once (about a tenth of a second), asked from any
/// number of threads.
class SkinTarget {
 public:
  /// skin: LPS mm, outward. Throws Error(anatomy) when it has no triangle.
  explicit SkinTarget(const TriangleMesh& skin);

  /// A point of the skin and how it faces.
  struct Place {
    Eigen::Vector3d point;   ///< LPS mm
    Eigen::Vector3d normal;  ///< outward
  };

  /// The nearest point of the skin within `reach` mm of an LPS point.
  std::optional<Place> nearest(const Eigen::Vector3d& lps, double reach) const;

  /// Evenly spread points, 5 mm apart.
  const SurfaceSample& sample() const { return sample_; }

  /// What stands out most of what faces forward (−y): the nose, and up to three others.
  const std::vector<Prominence>& forward() const { return forward_; }

  /// How much of the face is covered by a photograph's sample (own frame and unit) put in this
  /// place: of the skin that faces forward within 90 mm of those points, the share that it lies on
  /// and faces as, what is `kernel` mm away not counted and what is nearer in part.
  double covered_face(const SurfaceSample& photograph, const Similarity& lps_from_photograph,
                      double kernel) const;

 private:
  BspTree tree_;
  Points normals_;  ///< of the triangles
  SurfaceSample sample_;
  std::vector<Prominence> forward_;
  std::vector<Eigen::Index> face_;  ///< rows of sample_
};

}  // namespace gnathion
