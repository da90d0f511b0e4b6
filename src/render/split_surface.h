#pragma once

#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// The triangles of a textured face that share one material, as graphics hardware wants them: one
/// texture coordinate per vertex. A face vertex on a texture seam appears once for each coordinate.
struct SurfacePart {
  int material = -1;                ///< index into TexturedMesh::materials, −1 for none
  std::vector<int> face_vertex;     ///< for each vertex of the part, its row in the face's vertices
  std::vector<Eigen::Vector2d> uv;  ///< one a vertex, v up; empty: the part is shown untextured
  Triangles triangles;              ///< rows of face_vertex
};

/// Splits a face by material and by texture coordinate. Triangles of a textured material that lack
/// a coordinate go to an untextured part of their own. Every triangle lands in exactly one part.
/// \pre the mesh has passed check_face().
std::vector<SurfacePart> split_by_corner(const TexturedMesh& face);

/// The part with about `wanted` triangles, for frames while something moves, over those of its
/// vertices that they use. Its border stays: parts fit together as before, and so do the sides of a
/// seam. vertices: the face's.
SurfacePart coarse_part(const SurfacePart& part, const Points& vertices, int wanted);

/// Throws Error(input) with `name` as its subject unless the mesh can be shown: at least one
/// triangle, finite coordinates, all indices in range, arrays of matching length.
void check_face(const TexturedMesh& face, const std::string& name);

/// The same for a surface without texture.
void check_surface(const TriangleMesh& surface, const std::string& name);

}  // namespace gnathion
