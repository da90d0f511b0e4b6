#include "phantom/surface_search.h"

#include <algorithm>
#include <stdexcept>

namespace gnathion {

using Eigen::Vector3d;

std::optional<Vector3d> first_hit(const DistanceFunction& f, const Vector3d& start,
                                  const Vector3d& direction) {
  const Vector3d u = direction.normalized();
  double outside = 0;
  double inside = -1;
  for (double t = 0; t < 600;) {
    const double d = f(start + t * u);
    if (d < 0) {
      inside = t;
      break;
    }
    outside = t;
    // Smooth unions and bumps make the distance up to a third too large.
    t += std::max(0.7 * d, 0.02);
  }
  if (inside < 0) {
    return std::nullopt;
  }
  for (int i = 0; i < 40 && inside - outside > 1e-7; ++i) {
    const double middle = (inside + outside) / 2;
    (f(start + middle * u) < 0 ? inside : outside) = middle;
  }
  return start + (inside + outside) / 2 * u;
}

Vector3d surface_point(const DistanceFunction& f, const Vector3d& start,
                       const Vector3d& direction) {
  const std::optional<Vector3d> p = first_hit(f, start, direction);
  if (!p) {
    throw std::logic_error("surface_point: the ray meets no surface");
  }
  return *p;
}

namespace {

/// The hit with the greatest sign·height.
Vector3d extreme(const DistanceFunction& f, const Vector3d& from, const Vector3d& to,
                 const Vector3d& outward, double sign) {
  constexpr int rays = 400;
  std::optional<Vector3d> best;
  for (int i = 0; i <= rays; ++i) {
    const Vector3d start = from + (to - from) * i / rays + 150 * outward;
    const std::optional<Vector3d> p = first_hit(f, start, -outward);
    if (p && (!best || sign * (*p - *best).dot(outward) > 0)) {
      best = p;
    }
  }
  if (!best) {
    throw std::logic_error("most_prominent, most_recessed: no ray meets the surface");
  }
  return *best;
}

}  // namespace

Vector3d most_prominent(const DistanceFunction& f, const Vector3d& from, const Vector3d& to,
                        const Vector3d& outward) {
  return extreme(f, from, to, outward, 1);
}

Vector3d most_recessed(const DistanceFunction& f, const Vector3d& from, const Vector3d& to,
                       const Vector3d& outward) {
  return extreme(f, from, to, outward, -1);
}

}  // namespace gnathion
