#include "geometry/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {

Eigen::VectorXd signed_distances(const Points& points, const TriangleMesh& surface, double reach) {
  const BspTree tree(surface);
  const Points normals = vertex_normals(surface);
  Eigen::VectorXd distances(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = points.row(i);
    const auto nearest = tree.nearest(p, reach);
    if (!nearest) {
      distances[i] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    // Next to an edge a triangle's own normal can point the wrong way; the vertices' do not.
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();
    for (const int v : surface.triangles.row(nearest->triangle)) {
      const double gap = (surface.vertices.row(v).transpose() - nearest->point).norm();
      outward += normals.row(v).transpose() / (gap + 1e-6);
    }
    const bool outside = outward.dot(p - nearest->point) >= 0;
    distances[i] = outside ? nearest->distance : -nearest->distance;
  }
  return distances;
}

DistanceStatistics distance_statistics(const Eigen::VectorXd& values) {
  std::vector<double> sizes;
  for (const double value : values) {
    if (!std::isnan(value)) sizes.push_back(std::abs(value));
  }
  DistanceStatistics statistics;
  statistics.count = static_cast<Eigen::Index>(sizes.size());
  if (sizes.empty()) return statistics;
  std::sort(sizes.begin(), sizes.end());
  const auto quantile = [&](double q) {
    return sizes[static_cast<std::size_t>(q * static_cast<double>(sizes.size() - 1))];
  };
  for (const double size : sizes) statistics.mean += size / static_cast<double>(sizes.size());
  statistics.p90 = quantile(0.90);
  statistics.p95 = quantile(0.95);
  statistics.max = sizes.back();
  return statistics;
}

}  // namespace gnathion
