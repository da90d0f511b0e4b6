#include "phantom/distance_functions.h"

namespace gnathion::distance {

double polygon(const Eigen::Vector2d& p, std::span<const Eigen::Vector2d> corners) {
  double nearest = (p - corners[0]).squaredNorm();
  double sign = 1;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Eigen::Vector2d edge = corners[j] - corners[i];
    const Eigen::Vector2d w = p - corners[i];
    const double t = std::clamp(w.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (w - t * edge).squaredNorm());
    const bool crosses = (corners[i].y() <= p.y()) != (corners[j].y() <= p.y());
    if (crosses && (edge.x() * w.y() - edge.y() * w.x() > 0) == (edge.y() > 0)) {
      sign = -sign;
    }
  }
  return sign * std::sqrt(nearest);
}

std::vector<Knot> rounded(std::span<const Knot> knots, int pieces) {
  std::vector<Knot> curve;
  for (std::size_t i = 1; i + 2 < knots.size(); ++i) {
    const Knot& a = knots[i - 1];
    const Knot& b = knots[i];
    const Knot& c = knots[i + 1];
    const Knot& d = knots[i + 2];
    for (int k = i == 1 ? 0 : 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      const double wa = 0.5 * t * (-1 + t * (2 - t));
      const double wb = 0.5 * (2 + t * t * (-5 + 3 * t));
      const double wc = 0.5 * t * (1 + t * (4 - 3 * t));
      const double wd = 0.5 * t * t * (t - 1);
      curve.push_back({wa * a.centre + wb * b.centre + wc * c.centre + wd * d.centre,
                       wa * a.radius + wb * b.radius + wc * c.radius + wd * d.radius});
    }
  }
  return curve;
}

}  // namespace gnathion::distance
