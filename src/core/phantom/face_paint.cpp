#include "phantom/face_paint.h"

#include "phantom/repeatable_random.h"
#include "phantom/surface_search.h"

namespace gnathion {

using Eigen::Vector3d;

namespace {

/// 0 below `from`, 1 above `to`, smooth between (from > to: falling).
double step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

void lay_over(Vector3d& colour, const Vector3d& paint, double cover) {
  colour += cover * (paint - colour);
}

/// Height of a smooth curve through knots (x ascending) by piecewise cubic steps.
double curve(double x, std::initializer_list<Eigen::Vector2d> knots) {
  const Eigen::Vector2d* k = knots.begin();
  const std::size_t n = knots.size();
  if (x <= k[0].x()) {
    return k[0].y();
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    if (x > k[i + 1].x()) {
      continue;
    }
    const auto slope = [&](std::size_t j) {
      const std::size_t a = j == 0 ? 0 : j - 1;
      const std::size_t b = std::min(j + 1, n - 1);
      return (k[b].y() - k[a].y()) / (k[b].x() - k[a].x());
    };
    const double h = k[i + 1].x() - k[i].x();
    const double t = (x - k[i].x()) / h;
    const double t2 = t * t;
    const double t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * k[i].y() + (t3 - 2 * t2 + t) * h * slope(i) +
           (3 * t2 - 2 * t3) * k[i + 1].y() + (t3 - t2) * h * slope(i + 1);
  }
  return k[n - 1].y();
}

const Vector3d hair_colour(0.20, 0.13, 0.09);

}  // namespace

FacePaint::FacePaint(const HeadModel& head, unsigned seed)
    : seed_(seed),
      mole_(surface_point([&](const Vector3d& p) { return head.skin(p); }, {41, -180, -27},
                          {0, 1, 0})) {}

Vector3d FacePaint::skin_tone(const Vector3d& p) const {
  Vector3d c(0.855, 0.665, 0.565);
  const Vector3d q(std::abs(p.x()), p.y(), p.z());
  const double blotch = lattice_noise(p.x() / 9, p.y() / 9, p.z() / 9, seed_) - 0.5;
  const double pore = lattice_noise(p.x() / 0.9, p.y() / 0.9, p.z() / 0.9, seed_ + 1) - 0.5;
  c *= 1 + 0.05 * blotch + 0.05 * pore;
  const double red = 0.45 * distance::bump(q, {40, -80, -14}, {15, 25, 13}) +
                     0.5 * distance::bump(q, {0, -122, -14}, {12, 14, 9}) +
                     0.25 * distance::bump(q, {0, -100, -74}, {14, 14, 10});
  lay_over(c, {0.80, 0.49, 0.43}, red * (0.75 + 0.5 * blotch));
  const double lid = distance::bump(q, {31, -88, 17}, {13, 12, 8});
  lay_over(c, {0.72, 0.50, 0.43}, 0.38 * lid);
  // Beard shadow.
  const double beard = step(-27, -36, p.z()) * step(-38, -58, p.y() + 0.2 * p.z()) *
                       step(-108, -92, p.z()) * (0.7 + 0.6 * pore);
  lay_over(c, {0.55, 0.47, 0.44}, 0.22 * beard);
  const double nostril = distance::bump(q, {6.5, -109, -20.5}, {3.2, 7, 1.8});
  lay_over(c, {0.22, 0.10, 0.08}, std::min(1.0, 1.1 * nostril));
  return c;
}

void FacePaint::paint_lips(const Vector3d& p, Vector3d& colour) const {
  const double x = std::abs(p.x());
  if (p.y() > -84 || x > 27 || p.z() > -30 || p.z() < -55) {
    return;
  }
  const double top = curve(x, {{0, -34.2}, {5, -32.8}, {14, -36.4}, {25, -41.6}});
  const double bottom = curve(x, {{0, -51.6}, {9, -51.0}, {18, -47.2}, {25, -42.2}});
  const double line = curve(x, {{0, -41.9}, {5, -41.4}, {14, -41.2}, {25, -41.9}});
  const double inside = std::min(top - p.z(), p.z() - bottom);
  const double wrinkle = lattice_noise(p.x() * 1.1, 0, p.z() * 0.15, seed_ + 2) - 0.5;
  const Vector3d tint = p.z() > line ? Vector3d(0.66, 0.36, 0.34) : Vector3d(0.74, 0.42, 0.40);
  lay_over(colour, tint * (1 + 0.10 * wrinkle), 0.85 * step(-0.8, 0.9, inside));
  lay_over(colour, {0.30, 0.12, 0.11},
           0.85 * step(1.1, 0.2, std::abs(p.z() - line)) * step(26.5, 24, x));
}

void FacePaint::paint_eye(const Vector3d& p, Vector3d& colour) const {
  const double x = std::abs(p.x());
  if (p.y() > -60 || x < 12 || x > 52 || p.z() < 2 || p.z() > 30) {
    return;
  }
  const double upper = curve(x, {{16.2, 12.6}, {22, 17.4}, {30, 20.0}, {38, 19.0}, {46.5, 14.6}});
  const double lower = curve(x, {{16.2, 12.4}, {23, 10.6}, {31, 9.4}, {39, 10.3}, {46.5, 14.4}});
  const double within = step(15.2, 17.2, x) * step(47.2, 45.5, x);
  const double fold = curve(x, {{17, 17}, {24, 22.2}, {32, 24.2}, {40, 22.6}, {49, 16}});
  lay_over(colour, {0.42, 0.24, 0.20}, 0.6 * step(1.3, 0.2, std::abs(p.z() - fold)) * within);
  const double open = std::min(upper - p.z(), p.z() - lower);
  if (open > -2.2) {
    Vector3d eye(0.90, 0.88, 0.86);
    lay_over(eye, {0.78, 0.55, 0.52}, std::max(step(20.5, 17, x), 0.5 * step(43, 46, x)));
    const double r = std::hypot(x - 31.3, p.z() - 15.4);
    const double spokes =
        lattice_noise(9 + 6 * std::atan2(p.z() - 15.4, x - 31.3), r * 0.5, 3, seed_ + 3);
    const Vector3d iris = Vector3d(0.30, 0.42, 0.46) * (0.7 + 0.6 * spokes);
    lay_over(eye, iris, step(6.0, 5.5, r));
    lay_over(eye, {0.10, 0.14, 0.16}, step(4.9, 5.6, r) * step(6.3, 5.8, r));
    lay_over(eye, {0.02, 0.02, 0.02}, step(2.4, 2.0, r));
    lay_over(eye, {1, 1, 1},
             step(1.2, 0.8, std::hypot(p.x() - std::copysign(31.3, p.x()) + 2.0, p.z() - 17.6)));
    eye *= 1 - 0.35 * step(2.6, 0.4, upper - p.z());
    lay_over(colour, eye, within * step(-0.3, 0.3, open));
    lay_over(colour, {0.62, 0.38, 0.34}, within * 0.7 * step(1.1, 0.3, std::abs(p.z() - lower)));
  }
  const double lash = lattice_noise(p.x() * 1.7 + 0.7 * (p.z() - upper), 0, 0, seed_ + 4);
  const double above = p.z() - upper;
  lay_over(colour, {0.08, 0.05, 0.04}, within * step(1.2, 0.5, std::abs(above)));
  lay_over(colour, {0.08, 0.05, 0.04},
           within * 0.7 * lash * step(-0.2, 0.5, above) * step(2.8, 0.8, above));
}

void FacePaint::paint_hair(const Vector3d& p, Vector3d& colour) const {
  const double x = std::abs(p.x());
  // Brow: hairs slant outwards, more upright near the nose.
  const double middle = curve(x, {{9, 29.5}, {20, 32.5}, {34, 35.5}, {49, 30.5}});
  const double half = curve(x, {{8, 0.5}, {12, 4.0}, {24, 4.0}, {38, 3.0}, {50, 0.4}});
  if (x < 52 && p.y() < -58 && std::abs(p.z() - middle) < 8) {
    const double hair =
        lattice_noise(p.x() * 1.5 + (p.x() > 0 ? -0.9 : 0.9) * p.z(), 0, p.z() * 0.35, seed_ + 5);
    const double edge = half - std::abs(p.z() - middle) + 1.6 * (hair - 0.5);
    const double cover = step(-0.6, 2.2, edge) * step(7.5, 12, x) * step(51, 45, x);
    lay_over(colour, hair_colour, cover * (0.45 + 0.55 * hair));
  }
  const double ragged = 5 * (lattice_noise(p.x() / 2.2, p.y() / 5, p.z() / 6, seed_ + 6) - 0.5);
  const double line = curve(x, {{0, 79}, {25, 81}, {48, 72}, {60, 48}, {66, 20}, {74, 18}});
  const double nape = curve(p.y(), {{-44, 16},
                                    {-36, -6},
                                    {-22, -12},
                                    {-12, 14},
                                    {4, 30},
                                    {22, 22},
                                    {32, -18},
                                    {50, -36},
                                    {95, -38}});
  const double side =
      step(-46, -38, p.y() + 0.6 * ragged) * step(-3, 5, p.z() - nape + 0.6 * ragged);
  const double around = 70 * std::atan2(p.x(), -p.y());
  const double upright = lattice_noise(around * 0.9, 0, p.z() * 0.16, seed_ + 7);
  const double lengthwise = lattice_noise(p.x() * 0.9, 0, p.y() * 0.16, seed_ + 7);
  const double strand = upright + step(70, 100, p.z()) * (lengthwise - upright);
  const double top = step(-2, 5, p.z() - line + ragged) * step(-30, -42, p.y());
  const double ear = step(-1, 2, x - 67 - 0.2 * p.z()) * step(44, 36, p.z()) *
                     step(-20, -14, p.y()) * step(42, 34, p.y());
  const double cover = 0.95 * std::max(top, side) * (1 - ear);
  lay_over(colour, hair_colour * (0.75 + 0.9 * strand), cover);
}

Vector3d FacePaint::colour(const Vector3d& p) const {
  Vector3d c = skin_tone(p);
  paint_lips(p, c);
  paint_eye(p, c);
  paint_hair(p, c);
  const double r = (p - mole_).norm() + 0.5 * lattice_noise(p.x(), p.y(), p.z(), seed_ + 8);
  lay_over(c, {0.25, 0.13, 0.09}, 0.92 * step(3.6, 2.8, r));
  return c.cwiseMax(0.0).cwiseMin(1.0);
}

}  // namespace gnathion
