#pragma once

#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// One triangle's run along an edge. Unlike edges_of(), these take any surface.
struct HalfEdge {
  int low = 0, high = 0;  ///< its vertices
  int triangle = 0;
  bool upward = true;  ///< the triangle runs from low to high
};

/// Three a triangle, sorted by vertices, then triangle. A side from a vertex to itself is left out.
std::vector<HalfEdge> half_edges(const TriangleMesh& surface);

/// Calls use(begin, end) for every edge: the range of its half edges.
template <typename Use>
void for_edges(const std::vector<HalfEdge>& edges, Use use) {
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].low == edges[begin].low &&
           edges[end].high == edges[begin].high) {
      ++end;
    }
    use(begin, end);
    begin = end;
  }
}

}  // namespace gnathion
