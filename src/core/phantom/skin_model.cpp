#include <array>

#include "phantom/head_model.h"

namespace gnathion {

using namespace distance;

namespace {

double cranium_and_neck(const Point& p) {
  const double back = ellipsoid(p, {0, 14, 47}, {75, 79, 79});
  const double front = ellipsoid(p, {0, -30, 44}, {65, 68, 74});
  const double head = smooth_union(back, front, 26);
  const double neck = tube(p, {{{0, 14, -10}, 45}, {{0, 44, -190}, 58}});
  return smooth_union(head, neck, 22);
}

double face_mass(const Point& p) {
  double d = ellipsoid(p, {0, -36, -6}, {58, 58, 60});
  d = smooth_union(d, ellipsoid(p, {0, -63, -42}, {33, 36, 34}), 16);
  d = smooth_union(d, ellipsoid(p, {0, -76, -26}, {23, 29, 17}), 12);
  d = smooth_union(d, ellipsoid(p, {35, -54, -28}, {22, 29, 36}), 24);
  d = smooth_union(d, ellipsoid(p, {46, -62, 0}, {20, 20, 16}), 20);
  d = smooth_union(d, ellipsoid(p, {53, -28, -8}, {14, 42, 34}), 20);
  static const std::vector<Knot> jaw_line = rounded(std::array<Knot, 7>{{{{50, -6, 0}, 13},
                                                                         {{48, -10, -24}, 13},
                                                                         {{44, -16, -54}, 12},
                                                                         {{34, -40, -64}, 14},
                                                                         {{18, -66, -71}, 15},
                                                                         {{0, -76, -73}, 16},
                                                                         {{-18, -66, -71}, 15}}},
                                                    3);
  const double jaw = tube(p, jaw_line);
  d = smooth_union(d, jaw, 26);
  d = smooth_union(d, ellipsoid(p, {0, -36, -60}, {36, 44, 20}), 14);
  return d;
}

double chin(const Point& p) {
  const double boss = ellipsoid(p, {0, -84, -73}, {20, 19.5, 16});
  const double pads = ellipsoid(p, {8, -89, -74}, {12, 14, 12});
  return smooth_union(boss, pads, 8);
}

double nose(const Point& p) {
  double d = tube(p, {{{0, -90, 30}, 7.0}, {{0, -99.5, 14}, 6.5}, {{0, -108.5, 0}, 7.5}});
  d = smooth_union(d, tube(p, {{{0, -107, 0}, 7.5}, {{0, -115, -12}, 9}}), 6);
  d = smooth_union(d, ellipsoid(p, {3.5, -117, -13}, {7, 8, 7.5}), 5);
  const Point side = turned(p - Point(9, -95, -2), 2, 18);
  d = smooth_union(d, ellipsoid(side, Point::Zero(), {7, 13, 19}), 8);
  const Point ala = turned(p - Point(12.5, -104.5, -14.5), 2, 20);
  d = smooth_union(d, ellipsoid(ala, Point::Zero(), {5.2, 10, 7.5}), 5);
  d = smooth_union(d, tube(p, {{{0, -117, -18}, 3.8}, {{0, -105, -21}, 4.6}}), 4);
  return d;
}

double lips(const Point& p) {
  static const std::vector<Knot> upper = rounded(std::array<Knot, 6>{{{{-5, -104.2, -36.0}, 4.8},
                                                                      {{0, -104.6, -36.7}, 4.8},
                                                                      {{5, -104.2, -36.0}, 4.8},
                                                                      {{13, -100.4, -37.8}, 4.3},
                                                                      {{24.5, -88.5, -41.5}, 1.8},
                                                                      {{34, -76, -43}, 1}}},
                                                 4);
  static const std::vector<Knot> lower = rounded(std::array<Knot, 6>{{{{-8, -101.0, -46.4}, 5.4},
                                                                      {{0, -102.0, -46.6}, 5.6},
                                                                      {{8, -101.0, -46.4}, 5.4},
                                                                      {{16, -96.8, -44.8}, 4.3},
                                                                      {{24.5, -88.2, -42}, 1.8},
                                                                      {{33, -76, -40}, 1}}},
                                                 4);
  return smooth_union(tube(p, upper), tube(p, lower), 3.0);
}

/// Where the lips touch.
double lip_line(const Point& p) {
  static const std::vector<Knot> line = rounded(std::array<Knot, 7>{{{{-6, -110, -41.5}, 0},
                                                                     {{0, -112, -41.9}, 0},
                                                                     {{6, -110, -41.5}, 0},
                                                                     {{14, -103, -41.2}, 0},
                                                                     {{20, -98, -41.5}, 0},
                                                                     {{25, -94, -41.9}, 0},
                                                                     {{30, -90, -42}, 0}}},
                                                3);
  return 1.2 * (1 - 0.7 * std::min(1.0, p.x() / 25)) * ridge(p, line, 1.7);
}

/// How far the open eye lies behind the lids' edges.
double eye_opening(const Point& p) {
  const double along = (p.x() - 31.3) / 15.2;
  if (std::abs(along) >= 1 || p.y() > -60) {
    return 0;
  }
  const double arch = 1 - along * along;
  const double above = p.z() - 14.4 - along;
  const double half = (above > 0 ? 5.6 : 5.0) * std::pow(arch, 0.6);
  const double inside = std::clamp((half - std::abs(above)) / 1.6, 0.0, 1.0);
  return 0.9 * std::min(1.0, 3 * arch) * inside * inside * (3 - 2 * inside);
}

double ear(const Point& p) {
  const Point q = turned(turned(p - Point(71.5, 8, 3), 2, -20), 0, -12);
  const double plate = ellipsoid(q, {1, 3, 0}, {3.2, 17, 28});
  double d = plate;
  const double rim = std::sqrt(std::pow((q.y() - 3) / 17.5, 2) + std::pow((q.z() - 1) / 29, 2));
  const double helix = std::hypot((rim - 1) * 20, q.x() - 2.8) - 2.9;
  d = smooth_union(d, helix, 3);
  const double antihelix = tube(q, {{{3, 4, 18}, 2.2}, {{3.5, 9, 4}, 2.6}, {{3.5, 3, -12}, 2.8}});
  d = smooth_union(d, antihelix, 3);
  d = smooth_difference(d, ellipsoid(q, {5, -2, -2}, {5.5, 6.5, 9}), 3);
  d = smooth_union(d, ellipsoid(q, {2, -9, -3}, {4, 4, 6}), 4);
  d = smooth_union(d, ellipsoid(q, {1.5, -4, -25}, {4, 7.5, 8}), 4);
  return d;
}

/// Added to the union of the masses: where the surface is raised (positive) or pressed in.
double modelling(const Point& p) {
  double h = 0;
  h += 2.6 * ridge(p, {{{7, -98, 37}, 0}, {{28, -95, 40}, 0}, {{47, -80, 36}, 0}}, 7);
  h += 2.0 * bump(p, {0, -102, 42}, {14, 20, 9});
  h -= 9.5 * bump(p, {28, -93, 17}, {13, 14, 9});
  h -= 3.0 * bump(p, {15, -93, 19}, {5, 10, 8});
  h -= 3.0 * bump(p, {66, -50, 30}, {14, 18, 18});
  h -= 2.5 * bump(p, {40, -78, -42}, {10, 16, 16});
  h -= 1.5 * bump(p, {0, -102, -59}, {20, 9, 5});
  h -= 1.3 * ridge(p, {{{16, -104, -16}, 0}, {{24, -98, -30}, 0}, {{31, -92, -44}, 0}}, 3);
  h -= 1.2 * bump(p, {0, -108, -29}, {3, 8, 6});
  h += 0.8 * bump(p, {6.5, -107, -30}, {2.2, 8, 5});
  h -= 2.5 * bump(p, {0, -97, 27}, {9, 12, 6});
  return h;
}

}  // namespace

double HeadModel::skin(const Point& point) const {
  const Point p(soft_abs(point.x(), 1.5), point.y(), point.z());
  double d = smooth_union(cranium_and_neck(p), face_mass(p), 24);
  d = smooth_union(d, chin(p), 12);
  d -= modelling(p);
  d = smooth_union(d, ellipsoid(p, {31.5, -75.5, 15}, {14.5, 13, 13}), 5);
  d += eye_opening(p);
  d += 0.7 * ridge(p,
                   {{{18, -84, 18}, 0},
                    {{25, -88, 22.6}, 0},
                    {{33, -88, 24}, 0},
                    {{41, -84, 22}, 0},
                    {{48, -76, 16}, 0}},
                   1.1);
  d = smooth_union(d, nose(p), 7);
  d = smooth_union(d, lips(p), 8);
  d += lip_line(p);
  d = smooth_difference(d, ellipsoid(p, {6.4, -110.5, -22.5}, {3, 5, 3.4}), 3.5);
  if (p.x() > 50) {
    d = smooth_union(d, ear(p), 5);
  }
  // The mole is the one thing on the left only.
  return d - 1.3 * bump(point, {41, -83.5, -27}, {1.8, 3.0, 1.8});
}

Point HeadModel::skin_normal(const Point& p) const {
  const double h = 0.05;
  Point n;
  for (int a = 0; a < 3; ++a) {
    const Point e = h * Point::Unit(a);
    n[a] = skin(p + e) - skin(p - e);
  }
  return n.normalized();
}

double HeadModel::fat_depth(const Point& p) const {
  const double x = std::abs(p.x());
  const Point q(x, p.y(), p.z());
  return 2.5 + 6.0 * bump(q, {42, -70, -30}, {16, 22, 26}) +
         4.0 * bump(q, {0, -50, -92}, {30, 30, 12});
}

}  // namespace gnathion
