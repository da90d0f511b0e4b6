#include "registration/registration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "registration/stable_region.h"
#include "registration/units.h"
#include "support/expect_error.h"
#include "support/scan_scene.h"
#include "support/solids.h"
#include "tissue/region_shape.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;
using test::expect_error;
using test::head_landmarks;
using test::KnownScan;
using test::misplaced;
using test::ScanFaults;

/// The analytic head's skin, coarse, and its photograph, in LPS; made once.
struct Head {
  TriangleMesh skin, photograph, dressed;
  SkinTarget target;

  static const Head& get() {
    static const Head head;
    return head;
  }

 private:
  Head()
      : skin(test::head_skin({.pixel_mm = 3, .slice_step_mm = 3, .noise_hu = 0})),
        photograph(test::head_photograph({.photograph_edge_mm = 3})),
        dressed(test::dressed_head(photograph, skin)),
        target(skin) {}
};

bool has(const Registration& r, RegistrationDoubt::Kind kind) {
  return std::any_of(r.doubts.begin(), r.doubts.end(),
                     [&](const RegistrationDoubt& doubt) { return doubt.kind == kind; });
}

double largest_residual(const Registration& r) {
  double largest = 0;
  for (const auto& [name, mm] : r.quality.landmark_mm) largest = std::max(largest, mm);
  return largest;
}

std::string doubts_of(const Registration& r) {
  std::string text;
  for (const RegistrationDoubt& doubt : r.doubts)
    text += doubt.problem + "; " + doubt.remedy + "\n";
  return text;
}

/// The truth, turned by `degrees` about a line through the face and moved by `mm`.
Similarity beside(const Similarity& truth, double degrees, double mm) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(degrees * M_PI / 180, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  const Vector3d face(0, -90, -20);
  Similarity s = truth;
  s.rotation = turn * truth.rotation;
  s.translation = turn * (truth.translation - face) + face + mm * Vector3d(1, -1, 1).normalized();
  return s;
}

TEST(Registration, FindsItsPlaceFromAnywhereInAnyUnit) {
  const double units[] = {1, 10, 1000};
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const KnownScan scan = misplaced(Head::get().dressed, {.mm_per_unit = units[seed % 3]}, seed);
    RegistrationOptions options;
    options.landmarks = head_landmarks(scan.lps_from_photograph);
    Progress progress;
    const Registration r = register_photograph(scan.mesh, Head::get().target, options, progress);
    EXPECT_TRUE(r.trusted()) << doubts_of(r);
    EXPECT_EQ(r.lps_from_photograph.scale, units[seed % 3]);
    EXPECT_LT(largest_residual(r), 0.5) << "seed " << seed;
    EXPECT_LT(r.quality.spread_mm, 0.8);
  }
}

TEST(Registration, RefinesARoughStart) {
  const KnownScan scan = misplaced(Head::get().photograph, {.outliers = 0}, 3);
  RegistrationOptions options;
  options.landmarks = head_landmarks(scan.lps_from_photograph);
  Progress progress;
  const Registration r = register_photograph(
      scan.mesh, Head::get().target, beside(scan.lps_from_photograph, 12, 10), options, progress);
  EXPECT_TRUE(r.trusted()) << doubts_of(r);
  EXPECT_LT(largest_residual(r), 0.4);
  EXPECT_GT(r.quality.near, 0.95);
  EXPECT_LE(r.quality.median_mm, r.quality.rms_mm);
  EXPECT_LE(r.quality.rms_mm, r.quality.p95_mm);
}

TEST(Registration, TellsThatAStartWasTooFar) {
  const KnownScan scan = misplaced(Head::get().dressed, {}, 4);
  RegistrationOptions options;
  Progress progress;
  const Registration r = register_photograph(
      scan.mesh, Head::get().target, beside(scan.lps_from_photograph, 110, 60), options, progress);
  EXPECT_FALSE(r.trusted());
}

TEST(Registration, FitsTheScaleWhereAsked) {
  const KnownScan scan = misplaced(Head::get().photograph, {.outliers = 0}, 5);
  Similarity start = beside(scan.lps_from_photograph, 4, 4);
  start.scale *= 1.04;
  RegistrationOptions options;
  options.fit_scale = true;
  Progress progress;
  // Onto the optical skin: the CT's lies a little below it, which a scale cannot be told from.
  const SkinTarget skin(Head::get().photograph);
  const Registration r = register_photograph(scan.mesh, skin, start, options, progress);
  EXPECT_NEAR(r.lps_from_photograph.scale, 1, 0.003);
}

/// The lower face goes down and forward, as an open mouth; what is above the nose stays.
TriangleMesh with_open_mouth(TriangleMesh face, double mm) {
  for (Eigen::Index v = 0; v < face.vertices.rows(); ++v) {
    const double share = std::clamp((-25 - face.vertices(v, 2)) / 30, 0.0, 1.0);
    face.vertices(v, 1) -= mm / 4 * share;
    face.vertices(v, 2) -= mm * share;
  }
  return face;
}

TEST(Registration, AStableRegionIsNotDrawnByTheMouth) {
  const KnownScan scan = misplaced(with_open_mouth(Head::get().photograph, 12), {.outliers = 0}, 6);
  const Points lps = moved(scan.mesh.vertices, scan.lps_from_photograph);
  RegistrationOptions options;
  for (Eigen::Index v = 0; v < lps.rows(); ++v) options.stable.push_back(lps(v, 2) > -5);
  for (const LandmarkPair& pair : head_landmarks(scan.lps_from_photograph)) {
    if (pair.name == "nasion_soft" || pair.name == "nose_tip") options.landmarks.push_back(pair);
  }
  Progress progress;
  const Similarity start = beside(scan.lps_from_photograph, 6, 5);
  const Registration stable =
      register_photograph(scan.mesh, Head::get().target, start, options, progress);
  EXPECT_TRUE(stable.trusted()) << doubts_of(stable);
  EXPECT_LT(largest_residual(stable), 0.6);
}

TEST(Registration, DoubtsAnotherExpressionAndKeepsToTheUpperFace) {
  const KnownScan scan = misplaced(with_open_mouth(Head::get().dressed, 7), {.outliers = 0}, 6);
  RegistrationOptions options;
  for (const LandmarkPair& pair : head_landmarks(scan.lps_from_photograph)) {
    if (pair.name == "nasion_soft" || pair.name == "nose_tip") options.landmarks.push_back(pair);
  }
  Progress progress;
  const Registration r = register_photograph(
      scan.mesh, Head::get().target, beside(scan.lps_from_photograph, 5, 4), options, progress);
  EXPECT_TRUE(has(r, RegistrationDoubt::Kind::parts_differ)) << doubts_of(r);
  EXPECT_LT(largest_residual(r), 1.5);
}

/// The jaw 7 mm farther forward than in the CT, and a tight cap, 5 mm thick, down to the brows.
TriangleMesh with_jaw_forward_and_cap(TriangleMesh face) {
  const Points normals = vertex_normals(face);
  for (Eigen::Index v = 0; v < face.vertices.rows(); ++v) {
    const double z = face.vertices(v, 2);
    face.vertices(v, 1) -= 7 * std::clamp((-25 - z) / 20, 0.0, 1.0);
    face.vertices.row(v) += 5 * std::clamp((z - 36) / 6, 0.0, 1.0) * normals.row(v);
  }
  return face;
}

/// What a user paints between cap and mouth on a face in LPS, with a brush of 22 mm.
std::vector<bool> painted(const TriangleMesh& face) {
  const SurfaceBrush brush(face);
  const BspTree tree(face);
  Selection region(static_cast<std::size_t>(face.vertices.rows()));
  for (const double z : {20.0, 0.0}) {
    for (double x = -60; x <= 60; x += 15) {
      const auto on = point_in_sight(tree, Vector3d(x, -400, z), Vector3d::UnitY());
      for (const ReachedVertex& reached : brush.disc(*on, 22)) {
        region[static_cast<std::size_t>(reached.vertex)] = true;
      }
    }
  }
  return region;
}

TEST(Registration, APaintedRegionHelpsWhereJawAndForeheadDiffer) {
  const KnownScan scan =
      misplaced(with_jaw_forward_and_cap(Head::get().photograph), {.outliers = 0}, 6);
  RegistrationOptions options;
  for (const LandmarkPair& pair : head_landmarks(scan.lps_from_photograph)) {
    if (pair.name == "nasion_soft" || pair.name == "nose_tip") options.landmarks.push_back(pair);
  }
  const Similarity start = beside(scan.lps_from_photograph, 5, 4);
  const auto fitted = [&](std::vector<bool> stable) {
    options.stable = std::move(stable);
    Progress progress;
    return register_photograph(scan.mesh, Head::get().target, start, options, progress);
  };
  const double whole = largest_residual(fitted({}));
  const double proposed =
      largest_residual(fitted(upper_face(scan.mesh.vertices, start, Head::get().target, {})));
  const Registration by_brush =
      fitted(painted({moved(scan.mesh.vertices, scan.lps_from_photograph), scan.mesh.triangles}));
  std::cout << "nose and nasion off: by the whole face " << whole << " mm, by the proposed region "
            << proposed << " mm, by a painted one " << largest_residual(by_brush) << " mm\n";
  EXPECT_LT(largest_residual(by_brush), 0.8);
  EXPECT_GT(std::min(whole, proposed), 2 * largest_residual(by_brush));
  EXPECT_TRUE(by_brush.trusted()) << doubts_of(by_brush);
}

TEST(Registration, DoubtsABall) {
  const SkinTarget ball(test::sphere({0, 0, 0}, 90, 5));
  TriangleMesh cap = test::sphere({0, 0, 0}, 90, 6);
  std::vector<bool> front;
  for (Eigen::Index f = 0; f < cap.triangles.rows(); ++f) {
    front.push_back(cap.vertices(cap.triangles(f, 0), 1) < -20);
  }
  cap = sub_mesh(cap, front).mesh;
  Progress progress;
  const Registration r = register_photograph(cap, ball, Similarity{}, {}, progress);
  EXPECT_TRUE(has(r, RegistrationDoubt::Kind::slides)) << r.quality.grip;
}

TEST(Registration, DoubtsTheWrongUnitAndTheWrongThing) {
  Progress progress;
  const KnownScan scan = misplaced(Head::get().dressed, {}, 7);
  RegistrationOptions options;
  options.mm_per_unit = 1.5;
  EXPECT_FALSE(register_photograph(scan.mesh, Head::get().target, options, progress).trusted());
  const TriangleMesh box = test::box({0, 0, 0}, {100, 80, 120}, 30);
  EXPECT_FALSE(register_photograph(box, Head::get().target, {}, progress).trusted());
}

TEST(Registration, DoubtsAnUnusualUnit) {
  Progress progress;
  const KnownScan scan = misplaced(Head::get().dressed, {.mm_per_unit = 55}, 8);
  EXPECT_EQ(proposed_units(scan.mesh.vertices).front().confidence, Confidence::low);
  RegistrationOptions options;
  const Registration r = register_photograph(scan.mesh, Head::get().target, options, progress);
  EXPECT_TRUE(has(r, RegistrationDoubt::Kind::unit_unknown));
  EXPECT_NEAR(r.lps_from_photograph.scale, 55, 1.5);
}

TEST(Registration, DoubtsLandmarksOfAnotherPlace) {
  const KnownScan scan = misplaced(Head::get().photograph, {.outliers = 0}, 9);
  RegistrationOptions options;
  options.landmarks = head_landmarks(scan.lps_from_photograph);
  for (LandmarkPair& pair : options.landmarks) pair.lps.z() += 9;
  Progress progress;
  const Registration r = register_photograph(scan.mesh, Head::get().target,
                                             scan.lps_from_photograph, options, progress);
  EXPECT_TRUE(has(r, RegistrationDoubt::Kind::landmarks_differ));
}

TEST(Registration, RefusesWhatCannotBeAPhotograph) {
  const SkinTarget& target = Head::get().target;
  Progress progress;
  const TriangleMesh box = test::box({0, 0, 0}, {90, 90, 90}, 8);
  Similarity mirrored;
  mirrored.rotation(0, 0) = -1;
  expect_error(ErrorKind::input, {"start", "mirrored"},
               [&] { register_photograph(box, target, mirrored, {}, progress); });
  Similarity flat;
  flat.scale = 0;
  expect_error(ErrorKind::input, {"start", "scale"},
               [&] { register_photograph(box, target, flat, {}, progress); });
  RegistrationOptions options;
  options.stable = {true, false};
  expect_error(ErrorKind::input, {"stable region", "another number"},
               [&] { register_photograph(box, target, options, progress); });
  options.stable.assign(static_cast<std::size_t>(box.vertices.rows()), false);
  expect_error(ErrorKind::input, {"stable region", "fewer than 50"},
               [&] { register_photograph(box, target, options, progress); });
  expect_error(ErrorKind::input, {"photograph", "no triangle"},
               [&] { register_photograph(TriangleMesh{}, target, {}, progress); });
  TriangleMesh broken = box;
  broken.vertices(3, 1) = std::numeric_limits<double>::infinity();
  expect_error(ErrorKind::input, {"photograph", "finite"},
               [&] { register_photograph(broken, target, {}, progress); });
  expect_error(ErrorKind::anatomy, {"skin"}, [] { SkinTarget{TriangleMesh{}}; });
}

TEST(Registration, CanBeCancelled) {
  const KnownScan scan = misplaced(Head::get().dressed, {}, 10);
  Progress progress;
  progress.cancel();
  expect_error(ErrorKind::cancelled, {},
               [&] { register_photograph(scan.mesh, Head::get().target, {}, progress); });
}

TEST(SurfaceSample, LeavesSpikesOut) {
  TriangleMesh ball = test::sphere({0, 0, 0}, 80, 5);
  for (Eigen::Index v = 0; v < ball.vertices.rows(); v += 9) ball.vertices.row(v) *= 1.3;
  const std::vector<bool> kept = without_spikes(ball);
  Eigen::Index wrong = 0;
  for (Eigen::Index v = 0; v < ball.vertices.rows(); ++v) {
    wrong += kept[static_cast<std::size_t>(v)] != (v % 9 != 0);
  }
  EXPECT_LT(static_cast<double>(wrong), 0.02 * static_cast<double>(ball.vertices.rows()));
}

}  // namespace
}  // namespace gnathion
