#include "plan/hinge.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gnathion {
namespace {

using Eigen::Vector3d;

// Not level and not square to the middle: the condyles of a crooked head.
const HingeAxis hinge{{-51, -12, 3}, {48, -17, -2}};
const Vector3d chin(0, -90, -80);
const Vector3d pivot(2, -70, -60);

double distance(const RigidMotion& a, const RigidMotion& b) {
  return (a.rotation - b.rotation).norm() + (a(chin) - b(chin)).norm();
}

TEST(Hinge, ClosingLiftsTheChinAndLeavesTheCondyles) {
  const RigidMotion closed = with_hinge_angle({}, hinge, 6);
  EXPECT_LT((closed(hinge.left) - hinge.left).norm(), 1e-12);
  EXPECT_LT((closed(hinge.right) - hinge.right).norm(), 1e-12);
  EXPECT_GT(closed(chin).z(), chin.z() + 5);
  EXPECT_LT(with_hinge_angle({}, hinge, -6)(chin).z(), chin.z() - 5);
  EXPECT_NEAR(Eigen::AngleAxisd(closed.rotation).angle(), 6 * std::numbers::pi / 180, 1e-12);
}

TEST(Hinge, MotionInWordsIsExactlyTheTurnAboutTheAxis) {
  for (const double degrees : {-12.0, -0.5, 3.0, 9.0}) {
    const RigidMotion turn = with_hinge_angle({}, hinge, degrees);
    const JawMotion words = jaw_motion(turn, pivot);
    EXPECT_LT(distance(rigid_motion(words, pivot), turn), 1e-12);
    EXPECT_NEAR(hinge_angle(rigid_motion(words, pivot), hinge), degrees, 1e-10);
  }
}

TEST(Hinge, AngleOfAMotionWithoutTurningIsNought) {
  EXPECT_EQ(hinge_angle({}, hinge), 0);
  EXPECT_EQ(hinge_angle(rigid_motion({.forward_mm = 7, .up_mm = -3}, pivot), hinge), 0);
}

TEST(Hinge, SettingTheAngleIsReadBackWhateverCameBefore) {
  const RigidMotion before = rigid_motion({5, -2, 1, 4, -6, 8}, pivot);
  for (const double degrees : {-7.0, 0.0, 2.5, 11.0}) {
    EXPECT_NEAR(hinge_angle(with_hinge_angle(before, hinge, degrees), hinge), degrees, 1e-10);
  }
  // And back to where it was.
  const double was = hinge_angle(before, hinge);
  EXPECT_LT(distance(with_hinge_angle(with_hinge_angle(before, hinge, 9), hinge, was), before),
            1e-12);
}

TEST(Hinge, AdvancedJawClosesAsAWhole) {
  const RigidMotion advanced = rigid_motion({.forward_mm = 6}, pivot);
  const RigidMotion turn = with_hinge_angle({}, hinge, 4);
  const RigidMotion closed = with_hinge_angle(advanced, hinge, 4);
  EXPECT_LT((closed(chin) - turn(advanced(chin))).norm(), 1e-12);
}

}  // namespace
}  // namespace gnathion
