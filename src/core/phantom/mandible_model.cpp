#include <array>

#include "phantom/head_model.h"

namespace gnathion {

using namespace distance;

namespace {

double ramus(const Point& p) {
  static const Eigen::Vector2d outline[] = {
      {-17, -14},   {-15, -24}, {-14.5, -34}, {-15, -44}, {-18, -53},   {-24, -59},   {-34, -63.5},
      {-52, -67},   {-54, -60}, {-48, -50},   {-44, -40}, {-42, -30},   {-41.5, -20}, {-40, -11},
      {-38.5, -13}, {-35, -19}, {-30, -22},   {-25, -21}, {-22, -17.5}, {-20, -13}};
  constexpr double rounding = 3.4;
  constexpr double half_thickness = 3.6;
  const double flare = 46 + 0.17 * (p.y() + 12) + 0.05 * (p.z() + 40);
  const Eigen::Vector2d section(polygon({p.y(), p.z()}, outline),
                                std::abs(p.x() - flare) - half_thickness + rounding);
  return section.cwiseMax(0.0).norm() + std::min(section.maxCoeff(), 0.0) - rounding;
}

double condyle(const Point& p) {
  const Point head = turned(p - Point(50, -16, -4), 2, -15);
  double d = ellipsoid(head, Point::Zero(), {9.5, 4.6, 5});
  return smooth_union(d, tube(p, {{{49, -17, -8}, 3.4}, {{47, -17, -26}, 3.2}}), 5);
}

/// The thick lower border from angle to chin.
double base(const Point& p) {
  static const std::vector<Knot> border = rounded(std::array<Knot, 8>{{{{45, -10, -56}, 3},
                                                                       {{43.5, -22, -61}, 3.8},
                                                                       {{38, -40, -66.5}, 4.6},
                                                                       {{29.5, -57, -71.5}, 5.2},
                                                                       {{19.5, -68.5, -75.5}, 5.6},
                                                                       {{10, -77, -77.3}, 6.0},
                                                                       {{0, -79.6, -77.5}, 6.2},
                                                                       {{-10, -77, -77.3}, 6.0}}},
                                                  3);
  double d = tube(p, border);
  d = smooth_union(d, ellipsoid(p, {0, -82, -74.5}, {10, 6.5, 8}), 6);
  return smooth_union(d, ellipsoid(p, {11.5, -80, -79}, {6, 5, 5}), 5);
}

}  // namespace

double HeadModel::mandible_bone(const Point& p) const {
  double d = smooth_union(base(p), alveolar_process(p, false), 15);
  const double r = smooth_union(ramus(p), condyle(p), 4);
  d = smooth_union(d, r, 7);
  return smooth_difference(d, ellipsoid(p, {0, -96, -64}, {20, 5, 5}), 5);
}

double HeadModel::mandible(const Point& point) const {
  const double far = rounded_box(Point(point.x(), point.y() + 53, point.z() + 44), {64, 48, 48}, 2);
  if (far > 8) {
    return far;
  }
  const Point p(soft_abs(point.x(), 1), point.y(), point.z());
  return smooth_union(mandible_bone(p), row(point, lower_), 0.8);
}

}  // namespace gnathion
