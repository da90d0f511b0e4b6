#include "registration/stable_region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/scan_scene.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

/// The analytic head: its nose's tip is at −12.7 mm, its nasion at 30 mm, its mouth at −42 mm.
class UpperFace : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TriangleMesh skin = test::head_skin({.pixel_mm = 4, .slice_step_mm = 4, .noise_hu = 0});
    target = new SkinTarget(skin);
    photograph = new TriangleMesh(test::head_photograph({.photograph_edge_mm = 4}));
  }
  static void TearDownTestSuite() {
    delete target;
    delete photograph;
  }
  static void expect_upper_face(const std::vector<bool>& flags, const Similarity& place) {
    ASSERT_EQ(flags.size(), static_cast<std::size_t>(photograph->vertices.rows()));
    EXPECT_GT(std::count(flags.begin(), flags.end(), true), 300);
    double lowest = 1e9, highest = -1e9;
    for (Eigen::Index v = 0; v < photograph->vertices.rows(); ++v) {
      if (!flags[static_cast<std::size_t>(v)]) continue;
      const double z = place(photograph->vertices.row(v)).z();
      lowest = std::min(lowest, z);
      highest = std::max(highest, z);
    }
    EXPECT_GT(lowest, -12.7);  // above the nose's tip, far above the mouth
    EXPECT_LT(lowest, 20);
    EXPECT_GT(highest, 60);
  }
  inline static SkinTarget* target = nullptr;
  inline static TriangleMesh* photograph = nullptr;
};

TEST_F(UpperFace, IsFoundFromTheSkinAlone) {
  expect_upper_face(upper_face(photograph->vertices, {}, *target, {}), {});
}

TEST_F(UpperFace, FollowsTheLandmarks) {
  const std::vector<LandmarkPair> tip{{nose_tip_name, {}, {0, -125.6, -12.7}}};
  expect_upper_face(upper_face(photograph->vertices, {}, *target, tip), {});
  const std::vector<LandmarkPair> far{{nasion_name, {}, {0, -99.7, 500}}};
  const std::vector<bool> none = upper_face(photograph->vertices, {}, *target, far);
  EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

TEST_F(UpperFace, IsAskedForWhereTheTransformPutsIt) {
  Similarity place;
  place.scale = 10;
  TriangleMesh in_cm = *photograph;
  in_cm.vertices /= 10;
  EXPECT_EQ(upper_face(in_cm.vertices, place, *target, {}),
            upper_face(photograph->vertices, {}, *target, {}));
}

}  // namespace
}  // namespace gnathion
