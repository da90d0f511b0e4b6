#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Where a ray meets a surface.
struct RayHit {
  int triangle = -1;
  double distance = 0;  ///< mm along the ray
  Eigen::Vector3d barycentric =
      Eigen::Vector3d::Zero();  ///< weights of the triangle's three vertices, sum 1
};

/// The point of a surface nearest to a given one.
struct NearestPoint {
  int triangle = -1;
  double distance = 0;  ///< mm
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

/// Binary space partition of a triangle surface: every node splits its triangles at the median of
/// their centres along the longest axis and keeps their bounding box. Built once, asked often,
/// from any number of threads. Of the trees compared in tests/bench (vtkModifiedBSPTree, CGAL's
/// AABB tree) it gives the same hits soonest; docs/evidence.md has the figures.
class BspTree {
 public:
  /// Keeps a copy of the triangles' corners; the mesh may go.
  explicit BspTree(const TriangleMesh& mesh);

  /// The first triangle that the ray from `origin` along the unit vector `direction` meets at a
  /// distance of at most `reach` mm. A ray aimed at a vertex or an edge is not lost between its
  /// triangles: a triangle is taken to reach 1e-9 of its size beyond its border.
  std::optional<RayHit> first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                  double reach) const;

  /// Nothing when no point of the surface is within `reach` mm.
  std::optional<NearestPoint> nearest(const Eigen::Vector3d& point, double reach) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int begin = 0, end = 0;  ///< triangles of a leaf, in corners_ and triangle_
    int right = -1;          ///< the second child; the first follows its parent; −1 for a leaf
  };
  struct Corners {
    Eigen::Vector3d a, b, c;
  };

  int build(int begin, int end, const std::vector<Corners>& all);

  std::vector<Node> nodes_;
  std::vector<Corners> corners_;  ///< in the order of the leaves
  std::vector<int> triangle_;     ///< the mesh's index of each
};

}  // namespace gnathion
