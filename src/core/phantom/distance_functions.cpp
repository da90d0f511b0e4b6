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

}  // namespace gnathion::distance
