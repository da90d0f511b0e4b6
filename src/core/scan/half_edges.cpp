#include "scan/half_edges.h"

#include <algorithm>
#include <tuple>

namespace gnathion {

std::vector<HalfEdge> half_edges(const TriangleMesh& surface) {
  std::vector<HalfEdge> edges;
  edges.reserve(static_cast<std::size_t>(surface.triangles.size()));
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = surface.triangles(f, k), b = surface.triangles(f, (k + 1) % 3);
      if (a != b) edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(f), a < b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return edges;
}

}  // namespace gnathion
