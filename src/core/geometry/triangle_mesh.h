#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// m×3 unit normals of the triangles, outward for counter-clockwise triangles. A triangle without
/// area gets the zero vector.
Points triangle_normals(const TriangleMesh& mesh);

/// n×3 unit normals of the vertices: mean of the adjacent triangles' normals, weighted by the
/// angle at the vertex (Thürmer and Wüthrich 1998). A vertex of no triangle gets the zero vector.
Points vertex_normals(const TriangleMesh& mesh);

/// An edge between two triangles, or on the rim.
struct Edge {
  int a = 0, b = 0;  ///< vertices, in the order in which triangle `left` runs through them
  int left = 0;      ///< the triangle that has a → b
  int right = -1;    ///< the triangle that has b → a, or −1 on the rim
};

/// The edges of an oriented two-manifold surface, in order of their first triangle and corner, so
/// that the result depends only on the mesh.
/// Throws Error(anatomy) where an edge has more than two triangles or two triangles run through it
/// the same way; `name` is the subject of the message.
std::vector<Edge> edges_of(const TriangleMesh& mesh, const std::string& name = "surface");

/// n flags: whether the vertex lies on the rim (an edge with one triangle).
std::vector<bool> rim_vertices(const TriangleMesh& mesh, const std::vector<Edge>& edges);

/// m numbers: the connected component of each triangle (connected through vertices), counted from
/// 0 in order of first appearance.
std::vector<int> triangle_components(const TriangleMesh& mesh);

/// Some triangles of a surface, with the vertices they use.
struct SubMesh {
  TriangleMesh mesh;
  std::vector<int> parent_vertex;  ///< for each vertex, its index in the surface it was taken from
  std::vector<int> parent_triangle;  ///< likewise for each triangle
};

/// The triangles for which keep[i] is true, their vertices in the parent's order.
SubMesh sub_mesh(const TriangleMesh& mesh, const std::vector<bool>& keep);

/// Neighbouring vertices of each vertex, through edges, ascending.
std::vector<std::vector<int>> vertex_neighbours(const TriangleMesh& mesh);

/// The flagged vertices and their neighbours. flags, neighbours: one a vertex, as
/// vertex_neighbours().
std::vector<bool> widened(const std::vector<bool>& flags,
                          const std::vector<std::vector<int>>& neighbours);

/// Enclosed volume in mm³ of a closed surface, positive when its normals point outward.
double signed_volume(const TriangleMesh& mesh);

/// Centre of the volume that a closed surface encloses, mm.
Eigen::Vector3d centre_of_volume(const TriangleMesh& mesh);

/// mm².
double surface_area(const TriangleMesh& mesh);

/// mm.
double mean_edge_length(const TriangleMesh& mesh);

}  // namespace gnathion
