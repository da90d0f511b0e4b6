#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <vector>

/// Signed distance functions: negative inside, mm, about the Euclidean distance near the surface.
/// All take points in LPS mm unless the name of the parameter says otherwise.
namespace gnathion::distance {

using Point = Eigen::Vector3d;

/// |x| without the kink at 0, so that mirrored parts meet smoothly in the midline.
inline double soft_abs(double x, double softness) {
  return std::sqrt(x * x + softness * softness);
}

/// Union with a fillet `k` mm wide; it bulges k/4 where both distances are equal.
inline double smooth_union(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0);
  return std::min(a, b) - h * h / (4 * k);
}
inline double smooth_intersection(double a, double b, double k) {
  return -smooth_union(-a, -b, k);
}
/// `a` without `b`.
inline double smooth_difference(double a, double b, double k) {
  return smooth_intersection(a, -b, k);
}

inline double sphere(const Point& p, const Point& centre, double radius) {
  return (p - centre).norm() - radius;
}

/// First-order distance of an axis-parallel ellipsoid: exact on the surface in value and gradient.
inline double ellipsoid(const Point& p, const Point& centre, const Point& radii) {
  const Point q = p - centre;
  const double k0 = q.cwiseQuotient(radii).norm();
  const double k1 = q.cwiseQuotient(radii.cwiseProduct(radii)).norm();
  return k1 < 1e-12 ? -radii.minCoeff() : k0 * (k0 - 1) / k1;
}

/// Box with half sides `half` and edges rounded by `radius` (within the half sides); p is relative
/// to the box's centre.
inline double rounded_box(const Point& p, const Point& half, double radius) {
  const Point q = p.cwiseAbs() - half + Point::Constant(radius);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

/// The same in the plane.
inline double rounded_box(const Eigen::Vector2d& p, const Eigen::Vector2d& half, double radius) {
  const Eigen::Vector2d q = p.cwiseAbs() - half + Eigen::Vector2d::Constant(radius);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

/// A point of a tube's axis.
struct Knot {
  Point centre;
  double radius;
};

/// Tube with a round section along straight pieces, its radius linear between the knots.
inline double tube(const Point& p, std::span<const Knot> knots) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Point axis = knots[i + 1].centre - knots[i].centre;
    const double t = std::clamp((p - knots[i].centre).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    const double radius = knots[i].radius + t * (knots[i + 1].radius - knots[i].radius);
    nearest = std::min(nearest, (p - knots[i].centre - t * axis).norm() - radius);
  }
  return nearest;
}
inline double tube(const Point& p, std::initializer_list<Knot> knots) {
  return tube(p, std::span<const Knot>(knots.begin(), knots.size()));
}

/// The knots of a smooth curve (Catmull and Rom's) through the inner knots, `pieces` straight
/// pieces for each gap. The first and last knot are not reached: they only give the direction at
/// the ends.
std::vector<Knot> rounded(std::span<const Knot> knots, int pieces);

/// The height of a smooth bump (1 at the centre, standard deviations `sigma`); subtracting a
/// multiple of it from a distance raises the surface there, as a sculptor's thumb of clay.
inline double bump(const Point& p, const Point& centre, const Point& sigma) {
  const double e = (p - centre).cwiseQuotient(sigma).squaredNorm();
  return e > 40 ? 0.0 : std::exp(-0.5 * e);
}

/// A bump along a path of knots of radius 0.
inline double ridge(const Point& p, std::span<const Knot> knots, double sigma) {
  const double d = tube(p, knots) / sigma;
  return d > 6 ? 0.0 : std::exp(-0.5 * d * d);
}
inline double ridge(const Point& p, std::initializer_list<Knot> knots, double sigma) {
  return ridge(p, std::span<const Knot>(knots.begin(), knots.size()), sigma);
}

/// `p` turned about the axis (0 = x, 1 = y, 2 = z) by `degrees`, right-handed.
inline Point turned(const Point& p, int axis, double degrees) {
  const double a = degrees * M_PI / 180;
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Point q = p;
  q[i] = std::cos(a) * p[i] - std::sin(a) * p[j];
  q[j] = std::sin(a) * p[i] + std::cos(a) * p[j];
  return q;
}

/// Distance to a closed polygon in the plane (either orientation).
double polygon(const Eigen::Vector2d& p, std::span<const Eigen::Vector2d> corners);

}  // namespace gnathion::distance
