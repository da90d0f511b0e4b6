#include "render/slice_scene.h"

#include <gtest/gtest.h>
#include <cmath>

namespace gnathion::test {
namespace {

std::shared_ptr<const CtVolume> empty_volume() {
  return std::make_shared<CtVolume>(Eigen::Vector3i(50, 50, 50),
                                    std::vector<std::int16_t>(125000, -1000),
                                    Eigen::Matrix4d::Identity(), "phantom");
}

std::shared_ptr<const PlaneSection> block(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int c = 0; c < 8; ++c) {
    mesh.vertices.row(c) << (c & 1 ? high : low).x(), (c & 2 ? high : low).y(),
        (c & 4 ? high : low).z();
  }
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
      2, 4, 6, 1, 3, 5, 3, 7, 5;
  return std::make_shared<PlaneSection>(std::make_shared<TriangleMesh>(mesh));
}

/// Least and greatest corner of a contour's lines.
std::pair<Eigen::Vector2d, Eigen::Vector2d> extent(const SliceContour& contour) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;
  for (const auto& line : contour.lines) {
    for (const Eigen::Vector2d& p : line) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return {low, high};
}

TEST(HuWindow, IsDicomsLinearFunctionToTheBit) {
  // PS3.3 C.11.2.1.2.1 with level 50, width 400, output 0..255.
  const HuWindow window{50, 400};
  for (int hu = -400; hu < 500; ++hu) {
    double expected = 0;
    if (hu <= 50 - 0.5 - 399 / 2.0) {
      expected = 0;
    } else if (hu > 50 - 0.5 + 399 / 2.0) {
      expected = 255;
    } else {
      expected = ((hu - 49.5) / 399 + 0.5) * 255;
    }
    EXPECT_EQ(grey_of(hu, window), static_cast<int>(std::lround(expected))) << hu;
  }
  EXPECT_EQ(grey_of(-150, window), 0);
  EXPECT_EQ(grey_of(249, window), 255);
  EXPECT_EQ(grey_of(49.5, window), 128);
}

TEST(HuWindow, NarrowestIsAThreshold) {
  const HuWindow window = limited({100, 0});
  EXPECT_EQ(window.width, 2);
  EXPECT_EQ(grey_of(98, window), 0);
  EXPECT_EQ(grey_of(101, window), 255);
  EXPECT_EQ(limited({1e9, 1e9}), (HuWindow{6000, 8000}));
}

TEST(HuWindow, GreysOfASliceAreThoseOfItsValues) {
  CtSlice slice;
  slice.width = 5;
  slice.height = 1;
  slice.hu = {-1024, 500, 3071, outside_volume, 32767};
  std::vector<std::uint8_t> greys;
  grey_slice(slice, bone_window, greys);
  ASSERT_EQ(greys.size(), 5U);
  for (const std::size_t p : {0U, 1U, 2U, 4U})
    EXPECT_EQ(greys[p], grey_of(slice.hu[p], bone_window));
  EXPECT_EQ(greys[3], 0);
  grey_slice(slice, {-32000, 8000}, greys);
  EXPECT_EQ(greys[3], 0) << "black beyond the volume, whatever the window";
}

TEST(SliceScene, OutlinesASurfaceInItsPose) {
  SliceScene scene;
  scene.set_volume(empty_volume());
  scene.set_surface("block", block({10, 20, 30}, {14, 26, 38}), {1, 0, 0});
  const auto axial = scene.contours(SlicePlane::axial, {0, 0, 33});
  ASSERT_EQ(axial.size(), 1U);
  EXPECT_EQ(axial[0].name, "block");
  EXPECT_EQ(extent(axial[0]).first, Eigen::Vector2d(10, 20));
  EXPECT_EQ(extent(axial[0]).second, Eigen::Vector2d(14, 26));
  const auto coronal = scene.contours(SlicePlane::coronal, {0, 25, 0});
  ASSERT_EQ(coronal.size(), 1U);
  EXPECT_EQ(extent(coronal[0]).first, Eigen::Vector2d(10, -38));
  const auto sagittal = scene.contours(SlicePlane::sagittal, {12, 0, 0});
  ASSERT_EQ(sagittal.size(), 1U);
  EXPECT_EQ(extent(sagittal[0]).first, Eigen::Vector2d(20, -38));
  EXPECT_TRUE(scene.contours(SlicePlane::axial, {0, 0, 39}).empty());

  // A quarter turn about +z and a shift: x' = −y + 50, y' = x.
  RigidMotion pose;
  pose.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  pose.translation = {50, 0, 5};
  scene.set_surface_pose("block", pose);
  const auto turned = scene.contours(SlicePlane::axial, {0, 0, 39});
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_LT((extent(turned[0]).first - Eigen::Vector2d(24, 10)).norm(), 1e-9);
  EXPECT_LT((extent(turned[0]).second - Eigen::Vector2d(30, 14)).norm(), 1e-9);
  scene.set_surface_visible("block", false);
  EXPECT_TRUE(scene.contours(SlicePlane::axial, {0, 0, 39}).empty());
}

TEST(SliceScene, OutlineLiesOnTheEdgeInThePixels) {
  // The same block as voxels and as a surface: the outline runs where the greys change.
  std::vector<std::int16_t> hu(125000, -1000);
  for (int k = 30; k <= 38; ++k) {
    for (int j = 20; j <= 26; ++j) {
      for (int i = 10; i <= 14; ++i) hu[static_cast<std::size_t>(50 * (50 * k + j) + i)] = 1000;
    }
  }
  const auto volume = std::make_shared<CtVolume>(Eigen::Vector3i(50, 50, 50), std::move(hu),
                                                 Eigen::Matrix4d::Identity(), "phantom");
  SliceScene scene;
  scene.set_volume(volume);
  scene.set_surface("block", block({9.5, 19.5, 29.5}, {14.5, 26.5, 38.5}), {1, 0, 0});
  for (const SlicePlane plane : all_slice_planes) {
    const Eigen::Vector3d through(12, 23, 33);
    CtSlice slice;
    scene.cut(plane, through, slice);
    const auto contours = scene.contours(plane, through);
    ASSERT_EQ(contours.size(), 1U);
    const auto [low, high] = extent(contours[0]);
    for (int y = 0; y < slice.height; ++y) {
      for (int x = 0; x < slice.width; ++x) {
        const Eigen::Array2d at =
            slice.corner + Eigen::Vector2d(x + 0.5, y + 0.5).cwiseProduct(slice.pixel);
        const bool within = (at > low.array()).all() && (at < high.array()).all();
        ASSERT_EQ(slice.at(x, y), within ? 1000 : -1000);
      }
    }
  }
}

TEST(SliceScene, SubjectIsAroundTheSurfacesWithinTheVolume) {
  SliceScene scene;
  scene.set_volume(empty_volume());
  EXPECT_EQ(scene.subject(), (LpsBox{{-0.5, -0.5, -0.5}, {49.5, 49.5, 49.5}}));
  scene.set_surface("jaw", block({20, 25, 30}, {30, 30, 32}), {1, 0, 0});
  EXPECT_EQ(scene.subject(), (LpsBox{{10, 15, 20}, {40, 40, 42}}));
  scene.set_surface("face", block({-300, 10, 30}, {300, 20, 45}), {1, 0, 0});
  EXPECT_EQ(scene.subject(), (LpsBox{{-0.5, 0, 20}, {49.5, 40, 49.5}}));
  scene.remove_surfaces();
  scene.set_surface("elsewhere", block({500, 500, 500}, {600, 600, 600}), {1, 0, 0});
  EXPECT_EQ(scene.subject(), (LpsBox{{-0.5, -0.5, -0.5}, {49.5, 49.5, 49.5}}));
}

TEST(SliceScene, AnotherVolumeBringsItsOwnSurfaces) {
  SliceScene scene;
  EXPECT_FALSE(scene.has_volume());
  scene.set_volume(empty_volume());
  scene.set_surface("block", block({1, 1, 1}, {9, 9, 9}), {1, 0, 0});
  scene.set_surface("block", block({1, 1, 1}, {5, 5, 5}), {1, 0, 0});
  EXPECT_TRUE(scene.contours(SlicePlane::axial, {0, 0, 7}).empty()) << "replaced, not added";
  scene.set_surface_points("no such", Points(0, 3));
  scene.set_volume(empty_volume());
  EXPECT_TRUE(scene.contours(SlicePlane::axial, {0, 0, 3}).empty());
}

}  // namespace
}  // namespace gnathion::test
