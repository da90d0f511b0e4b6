#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// A tetrahedral mesh by the ST Generator. Of M surface vertices and N triangles, nodes 0…M−1 are
/// the surface vertices P_i = J_i, M…2M−1 the inner vertices b', 2M…2M+N−1 the centre points c.
/// Where the tissue is thick the surface vertex and its inner vertex are the ends of a column of
/// more nodes, one between every two layers: these follow, vertex by vertex from the skin inward.
/// With one layer |tets| = N + 3 E_i, E_i the interior edges; those tets come first, in the paper's
/// order, and always are the deepest layer; the layers above it follow.
struct SoftTissueMesh {
  TetMesh mesh;
  int surface_count = 0;   ///< M
  int triangle_count = 0;  ///< N
  Eigen::VectorXd depth;   ///< M: distance from J_i to its inner vertex, mm
  /// M+1: column_start[v] is the number of nodes between layers in the columns before v's.
  std::vector<int> column_start;

  int inner(int vertex) const { return surface_count + vertex; }
  int centre(int triangle) const { return 2 * surface_count + triangle; }

  /// Number of layers below a surface vertex, at least 1.
  int layers(int vertex) const { return 1 + column_start[vertex + 1] - column_start[vertex]; }

  /// The node of a vertex's column below its `level` upper layers: 0 is the surface vertex itself,
  /// layers(vertex) the inner vertex.
  int column_node(int vertex, int level) const {
    if (level == 0) return vertex;
    if (level == layers(vertex)) return inner(vertex);
    return 2 * surface_count + triangle_count + column_start[vertex] + level - 1;
  }

  /// The top of the deepest layer at a vertex: the surface vertex where there is one layer.
  int above_deepest(int vertex) const { return column_node(vertex, layers(vertex) - 1); }
};

}  // namespace gnathion
