#include "phantom/head_model.h"

namespace gnathion {

using namespace distance;

namespace {

// Heights of the cutting edges. Their distance is the resting gap between the rows: wide enough
// that two voxels of 1.25 mm cannot bridge it.
constexpr double upper_edge = -42.0;
constexpr double lower_edge = upper_edge - HeadModel::joint_gap;

/// A dental arch: a half ellipse in the x,y plane, open to the back.
struct Arch {
  double front;  ///< y of the midline point
  double half_width;
  double depth;

  Eigen::Vector2d at(double angle) const {
    return {half_width * std::sin(angle), front + depth * (1 - std::cos(angle))};
  }
  Eigen::Vector2d outward(double angle) const {
    return Eigen::Vector2d(depth * std::sin(angle), -half_width * std::cos(angle)).normalized();
  }
};

constexpr Arch upper_arch{-97.5, 29.5, 50};
constexpr Arch lower_arch{-94.5, 28, 48};
// The bone lies behind the crowns, which lean forwards.
constexpr Arch upper_ridge{-92.5, 28.5, 46};
constexpr Arch lower_ridge{-88.8, 28, 44};

/// Widths, thicknesses at edge and neck and crown heights, central incisor to second molar, mm
/// (rounded means of adult teeth).
struct ToothSize {
  double width, edge_thickness, neck_thickness, crown, root;
};
constexpr ToothSize upper_sizes[] = {{8.6, 1.6, 6.5, 10.5, 13}, {6.6, 1.6, 6, 9.5, 13},
                                     {7.6, 2.6, 7.5, 10.5, 16}, {7.0, 7.0, 8.5, 8.5, 13},
                                     {6.8, 7.2, 8.5, 8.0, 13},  {10, 9.0, 10.5, 7.5, 12},
                                     {9.4, 8.8, 10.5, 7.0, 11}};
constexpr ToothSize lower_sizes[] = {{5.4, 1.5, 5.5, 9.0, 12},  {5.9, 1.5, 5.8, 9.2, 13},
                                     {6.9, 2.4, 7.2, 10.5, 15}, {7.0, 5.6, 7.5, 8.5, 13},
                                     {7.1, 6.6, 8.0, 8.0, 13},  {10.8, 8.4, 10, 7.5, 13},
                                     {10.3, 8.2, 9.8, 7.0, 12}};

/// Distance in the x,y plane from an arch of `samples` points.
double arch_distance(const Point& p, const Arch& arch) {
  double nearest = 1e9;
  Eigen::Vector2d a = arch.at(-0.08);
  const Eigen::Vector2d q = p.head<2>();
  for (int i = 1; i <= 12; ++i) {
    const Eigen::Vector2d b = arch.at(-0.08 + i * 0.134);
    const Eigen::Vector2d axis = b - a;
    const double t = std::clamp((q - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (q - a - t * axis).squaredNorm());
    a = b;
  }
  return std::sqrt(nearest);
}

/// The bone that holds a row of teeth, from height z_low to z_high.
double alveolar(const Point& p, const Arch& arch, double z_low, double z_high, double thickness) {
  const double beyond = std::max(std::abs(p.z() - (z_low + z_high) / 2) - 12, p.y() + 40);
  if (beyond > 12 || p.x() > 50) {
    return std::max(beyond, p.x() - 34);
  }
  const Eigen::Vector2d section(arch_distance(p, arch), p.z() - (z_low + z_high) / 2);
  return rounded_box(section, {thickness / 2, (z_high - z_low) / 2}, 2.5);
}

}  // namespace

std::vector<HeadModel::Tooth> HeadModel::make_row(bool upper) {
  const Arch arch = upper ? upper_arch : lower_arch;
  std::vector<Tooth> teeth;
  double angle = 0;
  for (const ToothSize& size : upper ? upper_sizes : lower_sizes) {
    const double start = angle;
    double middle = angle;
    double width = 0;
    while (width < size.width) {
      width += (arch.at(angle + 1e-3) - arch.at(angle)).norm();
      angle += 1e-3;
      middle = width < size.width / 2 ? angle : middle;
    }
    Tooth t;
    const Eigen::Vector2d at = arch.at(start + (middle - start));
    t.edge = {at.x(), at.y(), upper ? upper_edge : lower_edge};
    t.outward = arch.outward(middle);
    t.width = size.width;
    t.edge_thickness = size.edge_thickness;
    t.neck_thickness = size.neck_thickness;
    t.crown = size.crown;
    t.root = size.root;
    t.up = upper ? 1 : -1;
    teeth.push_back(t);
  }
  return teeth;
}

double HeadModel::tooth(const Point& p, const Tooth& t) {
  const Point q = p - t.edge;
  const double height = t.up * q.z();  // 0 at the edge, crown at the neck, then the root
  const double along = q.x() * t.outward.y() - q.y() * t.outward.x();
  const double outward = q.x() * t.outward.x() + q.y() * t.outward.y();
  const double rise = std::clamp(height / t.crown, 0.0, 1.0);
  const double thickness = t.edge_thickness + (t.neck_thickness - t.edge_thickness) *
                                                  std::sqrt(rise * (1.6 - 0.6 * rise));
  const double taper = 1 - 0.26 * std::max(0.0, rise - 0.2);
  const Point crown_point(along, outward + 0.35 * (thickness - t.edge_thickness),
                          height - t.crown / 2);
  const double rounding = std::min(1.9, 0.48 * std::min(thickness, t.width));
  const double crown =
      rounded_box(crown_point, {(t.width / 2 - 0.1) * taper, thickness / 2, t.crown / 2}, rounding);
  const Point root_point(along * t.neck_thickness / t.width, outward, height);
  const double root = tube(root_point, {{{0, -2.4, t.crown - 2}, 0.36 * t.neck_thickness},
                                        {{0, t.width < 8.7 ? -7.5 : -3.5, t.crown + t.root}, 1.3}});
  return 0.9 * smooth_union(crown, root, 2);
}

double HeadModel::row(const Point& p, const std::vector<Tooth>& teeth) const {
  const double up = teeth.front().up;
  const double middle = teeth.front().edge.z() + up * 12;
  const double far = rounded_box(Point(p.x(), p.y() + 74, p.z() - middle), {36, 29, 13.5}, 1);
  if (far > 3) {
    return far;
  }
  double nearest = 1e9;
  const Point q(std::abs(p.x()), p.y(), p.z());
  for (const Tooth& t : teeth) {
    if ((q - t.edge).head<2>().squaredNorm() < 20 * 20) {
      nearest = std::min(nearest, tooth(q, t));
    }
  }
  return std::min(nearest, 10.0);
}

double HeadModel::alveolar_process(const Point& p, bool upper) const {
  return upper ? alveolar(p, upper_ridge, upper_edge + 9.5, -18, 9)
               : alveolar(p, lower_ridge, -73, lower_edge - 9.5, 8.5);
}

double HeadModel::teeth(const Point& p) const {
  return std::min(row(p, upper_), row(p, lower_));
}

}  // namespace gnathion
