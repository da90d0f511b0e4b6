#include "plan/jaw_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

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

double distance(const RigidMotion& a, const RigidMotion& b) {
  return (a.rotation - b.rotation).norm() + (a(pivot) - b(pivot)).norm();
}

TEST(JawMotion, ComesBackFromTheRigidMotion) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift_mm(-30, 30), turn_deg(-89, 89), half_turn(-179, 179);
  for (int i = 0; i < 200; ++i) {
    const JawMotion motion{shift_mm(random),  shift_mm(random), shift_mm(random),
                           half_turn(random), turn_deg(random), half_turn(random)};
    const JawMotion back = jaw_motion(rigid_motion(motion, pivot), pivot);
    EXPECT_NEAR(back.forward_mm, motion.forward_mm, 1e-12);
    EXPECT_NEAR(back.up_mm, motion.up_mm, 1e-12);
    EXPECT_NEAR(back.left_mm, motion.left_mm, 1e-12);
    EXPECT_NEAR(back.pitch_deg, motion.pitch_deg, 1e-10);
    EXPECT_NEAR(back.roll_deg, motion.roll_deg, 1e-10);
    EXPECT_NEAR(back.yaw_deg, motion.yaw_deg, 1e-10);
  }
}

TEST(JawMotion, RoundTripKeepsTheRotationWherePitchAndYawTurnAlike) {
  for (const double roll : {90.0, -90.0, 90 - 1e-12, 90 - 1e-9, -90 + 1e-6, 90 - 1e-3, 89.9}) {
    const RigidMotion rigid =
        rigid_motion({.forward_mm = 3, .pitch_deg = 20, .roll_deg = roll, .yaw_deg = -35}, pivot);
    EXPECT_LT(distance(rigid_motion(jaw_motion(rigid, pivot), pivot), rigid), 1e-13) << roll;
  }
}

TEST(JawMotion, NothingComesBackAsNothing) {
  EXPECT_EQ(jaw_motion({}, pivot), JawMotion{});
}

TEST(JawMotion, AnotherPivotDoesNotMoveTheBone) {
  const JawMotion motion{4, -2, 1, 10, -7, 5};
  const Vector3d other = pivot + Vector3d(-20, -60, -70);
  const JawMotion told = about_pivot(motion, pivot, other);
  EXPECT_LT(distance(rigid_motion(told, other), rigid_motion(motion, pivot)), 1e-12);
  EXPECT_EQ(told.pitch_deg, motion.pitch_deg);
  EXPECT_GT(std::abs(told.up_mm - motion.up_mm), 5);
  EXPECT_EQ(about_pivot(motion, pivot, pivot), motion);
  const JawMotion straight{4, -2, 1};
  EXPECT_LT(distance(rigid_motion(about_pivot(straight, pivot, other), other),
                     rigid_motion(straight, pivot)),
            1e-12);
}

TEST(JawMotion, ATurnGoesOnAboutThePivotWhereItIs) {
  const JawMotion motion{4, -2, 1, 10, -7, 5};
  const RigidMotion before = rigid_motion(motion, pivot);
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
    const RigidMotion after = rigid_motion(turned(motion, axis, 8), pivot);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(8 * std::numbers::pi / 180, axis).toRotationMatrix();
    const Vector3d centre = before(pivot);
    expect_near(after(chin), centre + turn * (before(chin) - centre));
    expect_near(after(pivot), centre);
  }
  EXPECT_EQ(turned(motion, Vector3d::UnitX(), 0), motion);
  // The last of the three turns simply adds up.
  EXPECT_NEAR(turned(motion, Vector3d::UnitZ(), 8).yaw_deg, 13, 1e-12);
}

}  // namespace
}  // namespace gnathion
