#include "plan/jaw_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace gnathion {
namespace {

using Eigen::Vector3d;

// A jaw in LPS: the pivot between the condyles, the chin 80 mm before and 90 mm below it, the angle
// of the jaw on the patient's left at +x.
const Vector3d pivot(3, -20, 40);
const Vector3d chin = pivot + Vector3d(0, -80, -90);
const Vector3d left_angle = pivot + Vector3d(50, 0, 0);

Vector3d shift(const JawMotion& motion, const Vector3d& point) {
  return rigid_motion(motion, pivot)(point) - point;
}

void expect_near(const Vector3d& a, const Vector3d& b) {
  EXPECT_LT((a - b).norm(), 1e-12) << a.transpose() << " is not " << b.transpose();
}

TEST(JawMotion, NothingIsTheIdentityToTheBit) {
  const RigidMotion still = rigid_motion({}, pivot);
  EXPECT_EQ(still.rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(still.translation, Vector3d::Zero());
}

TEST(JawMotion, TranslationsPointToThePatientsSides) {
  for (const Vector3d& point : {chin, left_angle, pivot}) {
    expect_near(shift({.forward_mm = 7}, point), {0, -7, 0});
    expect_near(shift({.up_mm = 3}, point), {0, 0, 3});
    expect_near(shift({.left_mm = 2}, point), {2, 0, 0});
  }
}

TEST(JawMotion, PositivePitchLiftsTheChin) {
  const Vector3d u = shift({.pitch_deg = 5}, chin);
  EXPECT_GT(u.z(), 5);
  EXPECT_LT(u.y(), 0) << "a chin below the pivot also comes forward";
  EXPECT_NEAR(u.x(), 0, 1e-12);
}

TEST(JawMotion, PositiveRollLiftsTheLeftSide) {
  EXPECT_GT(shift({.roll_deg = 5}, left_angle).z(), 4);
  EXPECT_LT(shift({.roll_deg = 5}, pivot - Vector3d(50, 0, 0)).z(), -4);
}

TEST(JawMotion, PositiveYawTurnsTheChinToTheLeft) {
  const Vector3d u = shift({.yaw_deg = 5}, chin);
  EXPECT_GT(u.x(), 6);
  EXPECT_NEAR(u.z(), 0, 1e-12);
}

TEST(JawMotion, RotationsAreOfTheGivenAngle) {
  for (const JawMotion& turn : {JawMotion{.pitch_deg = 12}, JawMotion{.roll_deg = 12},
                                JawMotion{.yaw_deg = 12}, JawMotion{.yaw_deg = -12}}) {
    const Eigen::Matrix3d R = rigid_motion(turn, pivot).rotation;
    EXPECT_NEAR(Eigen::AngleAxisd(R).angle(), 12 * std::numbers::pi / 180, 1e-12);
    EXPECT_NEAR(R.determinant(), 1, 1e-12);
  }
}

TEST(JawMotion, ThePivotMovesOnlyByTheTranslation) {
  const JawMotion motion{4, -2, 1, 10, -7, 5};
  expect_near(shift(motion, pivot), {1, -4, -2});
}

TEST(JawMotion, PitchThenRollThenYawAboutThePatientsAxesThenTheTranslation) {
  const JawMotion all{4, -2, 1, 10, -7, 5};
  Vector3d x = chin;
  for (const JawMotion& step :
       {JawMotion{.pitch_deg = 10}, JawMotion{.roll_deg = -7}, JawMotion{.yaw_deg = 5},
        JawMotion{.forward_mm = 4, .up_mm = -2, .left_mm = 1}}) {
    x = rigid_motion(step, pivot)(x);
  }
  expect_near(rigid_motion(all, pivot)(chin), x);
}

}  // namespace
}  // namespace gnathion
