#pragma once

#include <vector>

#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {

/// The part of the face that may deform (paper, 4.1.2): one connected, oriented two-manifold piece
/// with a rim. It keeps, for each of its vertices, the index of that vertex in the face.
struct IntermediateMesh {
  TriangleMesh mesh;             ///< M vertices, N triangles, mm, LPS
  std::vector<int> face_vertex;  ///< M: index in the face
  std::vector<Edge> edges;       ///< edges_of(mesh)
  std::vector<bool> rim;         ///< M: whether the vertex is on the rim
  std::vector<bool> held;        ///< M: whether it is on a part of the rim that does not move
  std::vector<int> enclosed;  ///< vertices of the face within holes of the region, which go along
};

/// The region suggested for a segment: the vertices of the face at most `reach` mm from the bone
/// segment, without those hidden in a pocket (the inside of the mouth), the largest connected piece
/// of them, cleaned of triangles that hang on by a corner. With a reach well above the thickness of
/// the tissue the rim is away from the moving bone. The outer rim is held; holes, where a pocket
/// begins or the scan has nothing, are free.
/// `segment`: tree of the segment's surface. Throws Error(anatomy) when no part of the face is
/// within reach, or when what is within reach has no rim.
IntermediateMesh suggest_region(const TriangleMesh& face, const BspTree& segment, double reach);

/// The region of a given set of face vertices: the triangles with all three vertices in it. Its
/// outer rim is held, and so are holes with visible skin beyond. Holes where a pocket begins or the
/// scan has nothing are free, and what they enclose goes along.
/// Throws Error(anatomy) when an index is out of range, no triangle is left, the region is in
/// several pieces, has no rim or is not a manifold.
IntermediateMesh region_of_vertices(const TriangleMesh& face, const std::vector<int>& vertices);

}  // namespace gnathion
