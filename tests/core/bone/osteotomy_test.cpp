#include "bone/osteotomy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <string>

#include "geometry/triangle_mesh.h"
#include "imaging/ct_import.h"
#include "imaging/surfaces.h"
#include "support/expect_error.h"
#include "support/head_ct.h"

namespace gnathion::test {
namespace {

/// A closed block from min to max, each side divided into n×n squares, outward.
TriangleMesh block(const Eigen::Vector3d& min, const Eigen::Vector3d& max, int n = 6) {
  TriangleMesh mesh;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3i> triangles;
  const auto vertex = [&](const Eigen::Vector3d& p) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((points[i] - p).norm() < 1e-9) return static_cast<int>(i);
    }
    points.push_back(p);
    return static_cast<int>(points.size()) - 1;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const auto at = [&](int a, int b) {
        Eigen::Vector3d t;
        t[axis] = side;
        t[(axis + 1) % 3] = static_cast<double>(side ? a : b) / n;
        t[(axis + 2) % 3] = static_cast<double>(side ? b : a) / n;
        return vertex(min + t.cwiseProduct(max - min));
      };
      for (int a = 0; a < n; ++a) {
        for (int b = 0; b < n; ++b) {
          triangles.emplace_back(at(a, b), at(a + 1, b), at(a + 1, b + 1));
          triangles.emplace_back(at(a, b), at(a + 1, b + 1), at(a, b + 1));
        }
      }
    }
  }
  mesh.vertices.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    mesh.vertices.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    mesh.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i];
  }
  return mesh;
}

TriangleMesh both(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh;
  mesh.vertices.resize(a.vertices.rows() + b.vertices.rows(), 3);
  mesh.vertices << a.vertices, b.vertices;
  mesh.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  mesh.triangles << a.triangles, b.triangles.array() + static_cast<int>(a.vertices.rows());
  return mesh;
}

/// A bar along x, 60 × 10 × 10 mm.
TriangleMesh bar() {
  return block({-30, -5, -5}, {30, 5, 5});
}

SegmentResult cut(const TriangleMesh& bone, const BoundedCut& how) {
  Progress progress;
  return cut_segment(bone, how, {}, progress);
}

void expect_closed(const TriangleMesh& mesh) {
  for (const Edge& edge : edges_of(mesh)) ASSERT_GE(edge.right, 0);
}

void expect_sound(const SegmentResult& result, const TriangleMesh& bone) {
  expect_closed(result.segment);
  expect_closed(result.remainder);
  EXPECT_NEAR(signed_volume(result.segment), result.volume_mm3, 1e-9 * result.volume_mm3);
  EXPECT_NEAR(signed_volume(result.remainder), result.remainder_mm3, 1e-9 * result.remainder_mm3);
  const double all = signed_volume(bone);
  EXPECT_NEAR(result.volume_mm3 + result.remainder_mm3 + result.kerf_mm3, all, 1e-5 * all);
  for (const int component : triangle_components(result.segment)) ASSERT_EQ(component, 0);
}

void expect_refusal(const TriangleMesh& bone, const BoundedCut& how,
                    const std::vector<std::string>& parts) {
  expect_error(ErrorKind::anatomy, parts, [&] { cut(bone, how); });
}

PlateCut plate_across(double x) {
  PlateCut plate;
  plate.centre = {x, 0, 0};
  plate.normal = {2, 0, 0};
  plate.in_plane = {1, 1, 0};  // made orthogonal
  plate.half_width = 8;
  plate.half_height = 9;
  plate.kerf = 0.8;
  plate.seed = {25, 0, 0};
  return plate;
}

TEST(BoxCut, TakesWhatIsInside) {
  const SegmentResult result = cut(bar(), box_between({11, -20, -20}, {50, 20, 20}));
  expect_sound(result, bar());
  EXPECT_NEAR(result.volume_mm3, 1900, 1e-6);
  EXPECT_NEAR(result.remainder_mm3, 4100, 1e-6);
  EXPECT_EQ(result.kerf_mm3, 0);
  EXPECT_NEAR(result.segment.vertices.col(0).minCoeff(), 11, 1e-12);
  EXPECT_NEAR(result.remainder.vertices.col(0).maxCoeff(), 11, 1e-12);
}

TEST(BoxCut, IsBoundedOnEverySide) {
  const SegmentResult result = cut(bar(), box_between({-4, -2, -3}, {5, 20, 2}));
  expect_sound(result, bar());
  EXPECT_NEAR(result.volume_mm3, 9 * 7 * 5, 1e-6);
}

TEST(BoxCut, MayBeTurnedAndMirrored) {
  for (const double sign : {1.0, -1.0}) {
    BoxCut box;
    box.centre = {20, 0, 0};
    box.axes = Eigen::AngleAxisd(std::numbers::pi / 4, Eigen::Vector3d::UnitY()).toRotationMatrix();
    box.axes.col(1) *= sign;
    box.half_extents = {std::sqrt(8.0), 20, std::sqrt(8.0)};  // a lozenge of ±4 mm in x and z
    const SegmentResult result = cut(bar(), box);
    expect_sound(result, bar());
    EXPECT_NEAR(result.volume_mm3, 32 * 10, 1e-6);
  }
}

TEST(BoxCut, TakesTheLargestPieceAndLeavesTheOthers) {
  const TriangleMesh bone = both(bar(), block({-3, 10, -5}, {3, 16, 5}));
  const SegmentResult result = cut(bone, box_between({-10, -20, -20}, {10, 20, 20}));
  expect_sound(result, bone);
  EXPECT_NEAR(result.volume_mm3, 2000, 1e-6);
  EXPECT_NEAR(result.remainder_mm3, 4000 + 360, 1e-6);
  EXPECT_LT(result.segment.vertices.col(1).maxCoeff(), 6);
}

TEST(BoxCut, ThroughTheBonesOwnSidesAddsUp) {
  const SegmentResult result = cut(bar(), box_between({0, -5, -5}, {30, 5, 5}));
  expect_sound(result, bar());
  EXPECT_NEAR(result.volume_mm3, 3000, 1e-6);
}

TEST(BoxCut, HoldsSheetsThatTouchInAPoint) {
  // Two blocks that share one vertex, as a two-manifold surface with a pinched vertex.
  TriangleMesh bone = both(block({0, 0, 0}, {10, 10, 10}, 2), block({10, 10, 10}, {20, 20, 20}, 2));
  const Eigen::RowVector3d shared(10, 10, 10);
  int first = -1;
  for (int v = 0; v < bone.vertices.rows(); ++v) {
    if (bone.vertices.row(v) != shared) continue;
    if (first < 0) first = v;
    for (int& index : bone.triangles.reshaped()) index = index == v ? first : index;
  }
  const SegmentResult result = cut(bone, box_between({2, -1, -1}, {8, 11, 11}));
  EXPECT_NEAR(result.volume_mm3, 600, 1e-6);
  EXPECT_NEAR(result.remainder_mm3, 1400, 1e-6);
}

TEST(BoxCut, SaysWhenNothingIsLeft) {
  const BoxCut beside = box_between({100, 100, 100}, {120, 120, 120});
  expect_refusal(bar(), beside,
                 {"segment empty after the cut", "0 mm3", "move or enlarge the box"});
  const BoxCut hollow = box_between({29, -20, -20}, {50, 20, 20});
  Progress progress;
  EXPECT_EQ(std::lround(cut_segment(bar(), hollow, {.minimum_volume = 99}, progress).volume_mm3),
            100);
  expect_error(ErrorKind::anatomy, {"segment empty after the cut", "100 mm3"},
               [&] { cut_segment(bar(), hollow, {.minimum_volume = 101}, progress); });
}

TEST(BoxCut, RefusesABoxWithoutExtentOrWithSkewAxes) {
  expect_refusal(bar(), box_between({5, -5, -5}, {5, 5, 5}), {"no extent"});
  expect_refusal(bar(), box_between({9, -5, -5}, {5, 5, 5}), {"no extent"});
  BoxCut skew;
  skew.axes(0, 1) = 0.3;
  expect_refusal(bar(), skew, {"not orthonormal"});
  BoxCut nowhere = box_between({0, 0, 0}, {1, 1, 1});
  nowhere.centre.x() = std::numeric_limits<double>::quiet_NaN();
  expect_refusal(bar(), nowhere, {"not finite"});
}

TEST(PlateCut, SawsThePieceAtTheSeedOff) {
  const SegmentResult result = cut(bar(), plate_across(10));
  expect_sound(result, bar());
  EXPECT_NEAR(result.volume_mm3, 1960, 1e-6);
  EXPECT_NEAR(result.kerf_mm3, 80, 1e-6);
  EXPECT_NEAR(result.remainder_mm3, 3960, 1e-6);
  PlateCut other = plate_across(10);
  other.seed = {-40, 0, 0};  // near the other piece, not in it
  EXPECT_NEAR(cut(bar(), other).volume_mm3, 3960, 1e-6);
  other.seed = {9.5, 0, 0};  // in it, just before the kerf
  EXPECT_NEAR(cut(bar(), other).volume_mm3, 3960, 1e-6);
}

TEST(PlateCut, LeavesBonesBeyondThePlateWhole) {
  const TriangleMesh bone = both(bar(), block({-30, 15, -5}, {30, 25, 5}));
  const SegmentResult result = cut(bone, plate_across(10));
  expect_sound(result, bone);
  EXPECT_NEAR(result.volume_mm3, 1960, 1e-6);
  EXPECT_NEAR(result.remainder_mm3, 3960 + 6000, 1e-6);
}

TEST(PlateCut, SaysWhenItSeparatesNothing) {
  PlateCut small = plate_across(10);
  small.half_width = 3;
  expect_refusal(bar(), small, {"too small to separate anything", "enlarge the plate"});
  PlateCut beside = plate_across(50);
  expect_refusal(bar(), beside, {"does not touch the bone"});
  PlateCut at_the_end = plate_across(29.9);  // shaves the end off: there is no piece behind it
  expect_refusal(bar(), at_the_end, {"too small to separate anything"});
  // Another bone beside the plate does not count as separated.
  const TriangleMesh two = both(bar(), block({-30, 15, -5}, {30, 25, 5}));
  expect_refusal(two, small, {"too small to separate anything"});
}

TEST(PlateCut, RefusesParallelDirectionsAndNoKerf) {
  PlateCut plate = plate_across(10);
  plate.in_plane = plate.normal;
  expect_refusal(bar(), plate, {"parallel"});
  plate = plate_across(10);
  plate.normal.setZero();
  expect_refusal(bar(), plate, {"zero"});
  plate = plate_across(10);
  plate.kerf = 0;
  expect_refusal(bar(), plate, {"no extent"});
}

TEST(Osteotomy, RefusesSurfacesThatAreNoSolid) {
  const BoxCut box = box_between({11, -20, -20}, {50, 20, 20});
  TriangleMesh open = bar();
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  expect_refusal(open, box, {"open", "3 edges"});
  TriangleMesh inside_out = bar();
  inside_out.triangles.col(1).swap(inside_out.triangles.col(2));
  expect_refusal(inside_out, box, {"inside out"});
  expect_refusal(TriangleMesh{Points(0, 3), Triangles(0, 3)}, box, {"no bone surface"});
  TriangleMesh doubled = bar();
  doubled.triangles.conservativeResize(doubled.triangles.rows() + 1, 3);
  doubled.triangles.bottomRows(1) = doubled.triangles.topRows(1);
  expect_error(ErrorKind::anatomy, {"bone surface"}, [&] { cut(doubled, box); });
}

TEST(Osteotomy, RefusesABoneThatCutsItselfWhereTheBladeGoes) {
  const TriangleMesh bone = both(bar(), block({5, -3, -3}, {20, 8, 8}));
  expect_refusal(bone, box_between({11, -20, -20}, {50, 20, 20}), {"cuts itself"});
}

TEST(Osteotomy, LeavesTheInputAsItWas) {
  const TriangleMesh bone = bar();
  cut(bone, plate_across(10));
  EXPECT_EQ(bone.vertices, bar().vertices);
  EXPECT_EQ(bone.triangles, bar().triangles);
}

TEST(Osteotomy, StopsOnRequest) {
  Progress progress;
  progress.cancel();
  expect_error(ErrorKind::cancelled, {},
               [&] { cut_segment(bar(), plate_across(10), {}, progress); });
}

TEST(RealCt, BoxBelowTheTeethIsTheMandibleAndAPlateTheChin) {
  const auto folder = head_ct_folder();
  if (folder.empty()) GTEST_SKIP() << "no real CT at " << GNATHION_SHARED_DATA;
  Progress progress;
  BoneSurfaceOptions options;
  options.hu = 300;
  const TriangleMesh bone =
      bone_surface(read_ct(folder, std::nullopt, progress), options, progress);
  const auto start = std::chrono::steady_clock::now();
  const SegmentResult jaw = cut(bone, box_between({-60, -305, 320}, {65, -215, 369}));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cout << "real CT: mandible body " << jaw.volume_mm3 / 1000 << " ml in " << elapsed.count()
            << " s\n";
  expect_sound(jaw, bone);
  // 31 250 voxels at 300 HU below z = 369 are 59.6 ml; the surface runs through the outer voxels.
  EXPECT_NEAR(jaw.volume_mm3, 59.6e3, 0.04 * 59.6e3);
  EXPECT_NEAR(jaw.segment.vertices.col(0).minCoeff(), -49.3, 1.5);
  EXPECT_NEAR(jaw.segment.vertices.col(0).maxCoeff(), 54.2, 1.5);
  EXPECT_NEAR(jaw.segment.vertices.col(1).minCoeff(), -300.2, 1.5);
  EXPECT_NEAR(jaw.segment.vertices.col(2).maxCoeff(), 369, 1e-9);

  PlateCut genioplasty;
  genioplasty.centre = {2.5, -285, 349};
  genioplasty.half_width = 60;
  genioplasty.half_height = 25;
  genioplasty.seed = {2.5, -296, 340};
  // The plate ends at y = -260, within the bone on both sides: like a saw that stops too early.
  expect_refusal(bone, genioplasty, {"too small to separate anything"});
  genioplasty.centre.y() = -255;
  genioplasty.half_height = 60;
  const SegmentResult chin = cut(bone, genioplasty);
  expect_sound(chin, bone);
  EXPECT_NEAR(chin.segment.vertices.col(2).maxCoeff(), 348.75, 1e-6);
  EXPECT_GT(chin.volume_mm3, 9894 * 1.907);  // SOURCE.md's chin ends at y = -260
}

}  // namespace
}  // namespace gnathion::test
