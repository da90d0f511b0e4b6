#pragma once

#include "geometry/mesh_types.h"

namespace gnathion {

/// Signed distance of points to a surface, mm: to the nearest point of it, positive on the side
/// that its normals point to (bulge), negative behind it (hollow). points: k×3, LPS mm. A point
/// farther than `reach` mm gets NaN: not measured.
Eigen::VectorXd signed_distances(const Points& points, const TriangleMesh& surface,
                                 double reach = 100);

/// What is said of a set of distances or displacements, mm.
struct DistanceStatistics {
  Eigen::Index count = 0;
  double mean = 0;  ///< of the absolute values
  double p90 = 0, p95 = 0;
  double max = 0;
};

/// Of the absolute values; NaN are left out.
DistanceStatistics distance_statistics(const Eigen::VectorXd& values);

}  // namespace gnathion
