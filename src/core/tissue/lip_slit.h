#pragma once

#include <vector>

#include "geometry/bsp_tree.h"
#include "tissue/surface_map.h"

namespace gnathion {

/// A vertex of a region that was doubled where the lips part.
struct SlitVertex {
  int left = -1, right = -1;  ///< of the line as it was traced, seen from outside
  Eigen::Vector3d leftward = Eigen::Vector3d::Zero();  ///< unit, along the skin, across the line
};

/// A region cut open between the lips.
struct LipSlit {
  /// The vertices of the region before, which keep their numbers and lie to the left, then the
  /// copies to the right of the line. The slit is a free rim.
  IntermediateMesh region;
  SurfaceMap surface_map;            ///< |face| × |region.mesh.vertices|
  std::vector<SlitVertex> vertices;  ///< in the line's order, its ends, which stay joined, left out
};

/// The vertices of the region along a line on it, from its first point to its last, by edges: the
/// shortest way where an edge counts for more the farther it lies from the line.
/// line: mm, LPS.
/// Throws Error(anatomy) when the line has fewer than two points, leaves the region by more than
/// 3 mm, begins or ends on the region's rim, has to cross the rim (a mouth that is open already),
/// or spans fewer than four edges, which would leave fewer than three vertices to double.
std::vector<int> lip_path(const IntermediateMesh& region, const std::vector<Eigen::Vector3d>& line);

/// The region with the path's vertices moved along the surface onto the line, so that the slit has
/// the line's shape and not the triangles'; as far as no triangle turns over or becomes a sliver.
/// surface: what the region was made from; line: mm, LPS.
IntermediateMesh drawn_to_line(const IntermediateMesh& region, const BspTree& surface,
                               const std::vector<int>& path,
                               const std::vector<Eigen::Vector3d>& line);

/// Cuts a region open along a path of its edges. A row of the surface map that lies in a triangle
/// goes to that triangle's side. One that lies on the path itself, such as a face vertex that was
/// doubled, takes the mean of both sides: the face keeps its triangles.
/// path: distinct neighbouring vertices, at least three, none on the rim.
LipSlit slit_along(const IntermediateMesh& region, const SurfaceMap& surface_map,
                   const std::vector<int>& path);

/// The directions into the tissue, those of the slit's two sides turned apart where they would
/// cross or run into each other, to at least 3° from the plane between them. M×3, unit.
Points parted_directions(const std::vector<SlitVertex>& slit, const Points& directions);

}  // namespace gnathion
