#include <array>

#include "phantom/head_model.h"

namespace gnathion {

using namespace distance;

namespace {

/// The bone between the eyes, below them and behind the nose, before the holes are cut.
double maxilla(const Point& p) {
  double d = ellipsoid(p, {0, -58, -4}, {41, 33, 30});
  d = smooth_union(d, ellipsoid(p, {0, -68, -24}, {30, 27, 13}), 8);
  return smooth_difference(d, ellipsoid(p, {0, -58, -42}, {22, 33, 17}), 5);  // palate's vault
}

double nasal_bones(const Point& p) {
  const double bridge =
      tube(p, {{{0, -84, 31}, 6}, {{0, -91, 19}, 4.6}, {{0, -97.5, 7}, 4}, {{0, -99, 4}, 3}});
  const double side =
      tube(p, {{{6, -83, 28}, 5}, {{9, -86, 12}, 4.5}, {{14, -88, -4}, 4.5}, {{15, -88, -20}, 5}});
  return smooth_union(bridge, side, 7);
}

/// How far the nasal septum leans to the left at p, mm.
double septum_bend(const Point& p) {
  return 4 * bump(p, {0, -76, -6}, {1e3, 12, 10});
}

/// Piriform opening: a pear, narrow above.
double piriform(const Point& p) {
  const double low = ellipsoid(p, {5.0, -86, -14}, {7.5, 30, 8.5});
  const double high = tube(p, {{{0, -110, 2}, 4.5}, {{0, -60, 2}, 4.5}});
  return smooth_union(low, high, 12);
}

}  // namespace

double HeadModel::orbit(const Point& p) const {
  const Point q = turned(p - Point(30.8, -80, 16), 2, -20);
  const double depth = std::clamp((q.y() + 8) / 52, 0.0, 1.0);
  const double size = 1 - 0.8 * depth;
  const Eigen::Vector2d rim(std::abs(q.x()) / (18.5 * size), std::abs(q.z()) / (17.0 * size));
  const double round = std::pow(std::pow(rim.x(), 2.6) + std::pow(rim.y(), 2.6), 1 / 2.6);
  return smooth_intersection((round - 1) * 15 * size, q.y() - 39, 10);
}

double HeadModel::nasal_cavity(const Point& p) const {
  const double cavity = rounded_box(Point(p.x(), p.y() + 58, p.z() + 6), {13, 23, 15}, 8);
  return smooth_union(piriform(p), cavity, 4);
}

double HeadModel::cranium_outer(const Point& p) const {
  const double back = ellipsoid(p, {0, 14, 47}, {69, 73, 74});
  const double front = ellipsoid(p, {0, -30, 44}, {58, 62, 68});
  double d = smooth_union(back, front, 26);
  d += 4.5 * bump(p, {62, -46, 24}, {14, 18, 18});
  d -= 1.5 * bump(p, {26, -84, 62}, {16, 20, 14});
  return d;
}

double HeadModel::cranium(const Point& p) const {
  const double outer = cranium_outer(p);
  // The base rises from the occiput to the root of the nose.
  const double base = 22 - 0.34 * (std::min(p.y(), 0.0) + 95) - p.z() - 0.12 * std::max(p.y(), 0.0);
  double d = smooth_intersection(outer, base, 10);
  d = smooth_union(d, ellipsoid(p, {0, 22, -16}, {30, 30, 12}), 10);
  // Brow ridge with the upper rim of the orbit.
  static const std::vector<Knot> brow_path = rounded(std::array<Knot, 7>{{{{-16, -87, 35}, 4.5},
                                                                          {{0, -86, 36}, 6},
                                                                          {{16, -87, 35}, 4.5},
                                                                          {{31, -83, 35}, 4},
                                                                          {{43, -73, 30}, 3.8},
                                                                          {{47.5, -65, 22}, 3.6},
                                                                          {{49, -62, 10}, 3.6}}},
                                                     3);
  const double brow = tube(p, brow_path);
  d = smooth_union(d, brow, 10);
  d = smooth_union(d, ellipsoid(p, {50, 13, -14}, {8.5, 10, 16}), 12);  // mastoid
  d = smooth_union(d, ellipsoid(p, {54, -22, 0}, {11, 22, 7}), 7);    // floor of the temporal bone
  d = smooth_union(d, ellipsoid(p, {0, -28, -2}, {26, 26, 14}), 10);  // sphenoid
  return smooth_difference(d, tube(p, {{{60, -4, 0}, 3.2}, {{80, -2, 0}, 4}}), 2);  // ear canal
}

double HeadModel::cheekbone(const Point& p) const {
  const double body = ellipsoid(turned(p - Point(43, -67, -6), 2, 35), Point::Zero(), {13, 8, 11});
  const double buttress = tube(p, {{{41, -66, -11}, 7}, {{32, -67, -24}, 6}});
  const double rim = tube(p, {{{15, -82, 1}, 3.6}, {{29, -80, -3}, 4.2}, {{43, -71, 1}, 4.2}});
  const double frontal =
      tube(p, {{{46.5, -66, 0}, 4.6}, {{48.5, -63, 12}, 3.8}, {{48, -65, 23}, 3.6}});
  static const std::vector<Knot> path = rounded(std::array<Knot, 8>{{{{40, -72, -8}, 6},
                                                                     {{49, -62, -7}, 5.2},
                                                                     {{58, -50, -6}, 4.2},
                                                                     {{63, -36, -5}, 3.4},
                                                                     {{63.5, -24, -3.5}, 3.2},
                                                                     {{61, -10, 0}, 3.8},
                                                                     {{58, 6, 4}, 4},
                                                                     {{55, 20, 6}, 4}}},
                                                3);
  const double arch = tube(p, path);
  double d = smooth_union(body, buttress, 8);
  d = smooth_union(d, rim, 6);
  d = smooth_union(d, frontal, 6);
  return smooth_union(d, arch, 6);
}

double HeadModel::midface(const Point& p) const {
  double d = smooth_union(maxilla(p), cheekbone(p), 8);
  d = smooth_union(d, nasal_bones(p), 6);
  return smooth_difference(d, ellipsoid(p, {33, -93, -18}, {11, 10, 11}), 8);  // canine fossa
}

double HeadModel::brain(const Point& point) const {
  const Point p(std::abs(point.x()), point.y(), point.z());
  const double cerebrum = std::min(37.0, 34 - (p.y() + 40) * 0.3) - p.z();
  const double temporal_lobe = ellipsoid(p, {35, -12, 22}, {22, 29, 19});
  const double cerebellum = ellipsoid(p, {18, 42, 6}, {32, 36, 24});
  const double whole = smooth_union(smooth_union(cerebrum, temporal_lobe, 8), cerebellum, 8);
  return smooth_intersection(cranium_outer(p) + 6.5, whole, 8);
}

double HeadModel::airway(const Point& point) const {
  const Point p(std::abs(point.x() - septum_bend(point)), point.y(), point.z());
  const double nose = rounded_box(Point(p.x() - 6.5, p.y() + 62, p.z() + 6), {4.5, 24, 12}, 4);
  const double pharynx =
      tube(p, {{{0, -38, -6}, 7}, {{0, -26, -30}, 7}, {{0, -22, -70}, 7}, {{0, -12, -104}, 7}});
  const double sinus = ellipsoid(p, {28, -62, -10}, {9, 13, 11});
  return std::min(smooth_union(nose, pharynx, 6), sinus);
}

double HeadModel::eyeballs(const Point& p) const {
  return sphere({std::abs(p.x()), p.y(), p.z()}, {31.5, -77, 15}, 11.5);
}

double HeadModel::spine(const Point& p) const {
  if (p.z() > -25 || std::abs(p.x()) > 45) {
    return std::max({p.z() + 32, std::abs(p.x()) - 40, 4.0});
  }
  // Vertebrae every 17 mm along a line that leans back; the discs between them are the gaps.
  const double step = 17;
  const double level = std::min(0.0, std::round((p.z() + 44) / step));
  const double z = -44 + level * step;
  const double y = 16 - (z + 44) * 0.18;
  const Point q(std::abs(p.x()), p.y() - y, p.z() - z);
  const double waist = 0.9 * std::max(0.0, 1 - q.z() * q.z() / 49);
  const double body = rounded_box(q, {11.5, 9, 7.4}, 4.5) + waist;
  double arch =
      tube(q, {{{10, 4, 0}, 3}, {{18, 8, 0}, 4}, {{11, 22, -1}, 3.2}, {{0, 27, -2}, 3.4}});
  arch = smooth_union(arch, tube(q, {{{0, 27, -2}, 3}, {{0, 42, -7}, 3.4}}), 3);
  return smooth_union(body, arch, 3);
}

double HeadModel::skull(const Point& point) const {
  const Point p(soft_abs(point.x(), 1), point.y(), point.z());
  const double vault = cranium(p);
  double d = vault;
  if (p.z() < 50 && p.y() < 20) {
    d = smooth_union(vault, midface(p), 6);
    d = smooth_union(d, tube(p, {{{16, -44, -2}, 5}, {{17, -42, -28}, 3}}), 6);  // pterygoid
    d = smooth_difference(d, orbit(p), 3);
    d = smooth_difference(d, nasal_cavity(p), 2);
    const Point septum(point.x() - septum_bend(point), p.y() + 64, p.z() + 4);
    d = smooth_union(d, rounded_box(septum, {0.9, 28, 17}, 0.5), 1);
  }
  d = smooth_difference(d, brain(p), 3);
  d = smooth_difference(d, tube(p, {{{0, 24, 10}, 14}, {{0, 26, -60}, 14}}), 3);  // foramen magnum
  d = smooth_difference(d, airway(point) - 1.2, 1);
  if (p.z() < -10 && p.y() < -30) {
    d = smooth_union(d, alveolar_process(p, true), 6);
    d = smooth_union(d, row(point, upper_), 0.8);
  }
  // Joint space and resting gap: guaranteed here, whatever the parts above do.
  return d < 12 ? std::max(d, joint_gap - mandible(point)) : d;
}

double HeadModel::muscle(const Point& point) const {
  const Point p(std::abs(point.x()), point.y(), point.z());
  const double masseter = tube(p, {{{61, -44, -14}, 8}, {{53, -24, -56}, 9}});
  const double temporalis = ellipsoid(p, {60, -25, 28}, {12, 34, 36});
  const double tongue = ellipsoid(p, {0, -58, -48}, {24, 34, 20});
  const double lip = tube(p, {{{0, -101, -42}, 5}, {{14, -97, -42}, 5}, {{26, -85, -42}, 4}});
  return std::min({masseter, temporalis, tongue, lip});
}

double HeadModel::bone(const Point& p) const {
  return std::min({skull(p), mandible(p), spine(p)});
}

}  // namespace gnathion
