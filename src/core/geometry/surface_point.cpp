#include "geometry/surface_point.h"

#include <Eigen/LU>

namespace gnathion {

Eigen::Vector3d SurfacePoint::position(const Triangles& triangles, const Points& vertices) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int c = 0; c < 3; ++c) {
    sum += weight[c] * vertices.row(triangles(triangle, c)).transpose();
  }
  return sum;
}

double SurfacePoint::value(const Triangles& triangles, const Eigen::VectorXd& values) const {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += weight[c] * values[triangles(triangle, c)];
  return sum;
}

std::optional<SurfacePoint> point_in_sight(const BspTree& tree, const Eigen::Vector3d& eye,
                                           const Eigen::Vector3d& direction) {
  constexpr double beyond_any_picture = 1e5;  // mm
  const auto hit = tree.first_hit(eye, direction, beyond_any_picture);
  if (!hit) return {};
  return SurfacePoint{hit->triangle, hit->barycentric};
}

std::optional<SurfacePoint> nearest_surface_point(const BspTree& tree, const TriangleMesh& surface,
                                                  const Eigen::Vector3d& place, double reach) {
  const auto nearest = tree.nearest(place, reach);
  if (!nearest) return {};
  const auto corner = [&](int c) -> Eigen::Vector3d {
    return surface.vertices.row(surface.triangles(nearest->triangle, c));
  };
  // Least squares: the point lies in the triangle's plane but for rounding.
  Eigen::Matrix<double, 3, 2> sides;
  sides << corner(1) - corner(0), corner(2) - corner(0);
  const Eigen::Matrix2d gram = sides.transpose() * sides;
  Eigen::Vector2d w = Eigen::Vector2d::Zero();
  if (gram.determinant() > 0) {
    w = gram.inverse() * (sides.transpose() * (nearest->point - corner(0)));
  }
  return SurfacePoint{nearest->triangle, {1 - w.sum(), w[0], w[1]}};
}

}  // namespace gnathion
