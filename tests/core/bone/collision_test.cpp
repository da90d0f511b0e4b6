#include "bone/collision.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>

#include "geometry/triangle_mesh.h"
#include "support/solids.h"

namespace gnathion::test {
namespace {

using Eigen::Vector3d;

RigidMotion shifted(double x, double y, double z) {
  return {Eigen::Matrix3d::Identity(), {x, y, z}};
}

/// One segment against the bone that stays; a depth of 0: they do not collide.
Collision collide(const TriangleMesh& segment, const TriangleMesh& fixed, const RigidMotion& pose) {
  const std::vector<Collision> found =
      CollisionModel({&segment}, fixed).collisions(std::array{pose});
  EXPECT_LE(found.size(), 1U);
  return found.empty() ? Collision{} : found[0];
}

// Two blocks 20 mm wide that touch at x = 0, as the halves of a box cut do.
const TriangleMesh right_block = box({-10, 0, 0}, {10, 10, 10}, 10);
const TriangleMesh left_block = box({10, 0, 0}, {10, 10, 10}, 10);

TEST(Collision, BlocksThatTouchDoNotCollide) {
  EXPECT_EQ(collide(left_block, right_block, {}).depth, 0);
  EXPECT_EQ(collide(left_block, right_block, shifted(5, 0, 0)).depth, 0);
  // Along the cut, and within the tolerance into each other.
  EXPECT_EQ(collide(left_block, right_block, shifted(0, 7, -3)).depth, 0);
  EXPECT_EQ(collide(left_block, right_block, shifted(-0.29, 0, 0)).depth, 0);
}

TEST(Collision, BlockDrivenIntoAnotherIsAsDeepAsItWentIn) {
  for (const double depth : {0.31, 1.0, 1.8, 4.0}) {
    const Collision found = collide(left_block, right_block, shifted(-depth, 0, 0));
    EXPECT_NEAR(found.depth, depth, 1e-9);
    EXPECT_EQ(found.segment, 0);
    EXPECT_EQ(found.other, -1);
    ASSERT_GT(found.places.rows(), 50);
    ASSERT_EQ(found.places.rows(), found.depths.size());
    // Both ends of the overlap, each vertex as deep as it lies from the other's surface.
    EXPECT_NEAR(found.places.col(0).minCoeff(), -depth, 1e-9);
    EXPECT_NEAR(found.places.col(0).maxCoeff(), 0, 1e-9);
    EXPECT_LE(found.depths.maxCoeff(), depth + 1e-9);
    EXPECT_GT(found.depths.minCoeff(), 0.3);
  }
}

TEST(Collision, BallsOverlapByRadiiLessDistance) {
  const double radius = 12;
  const TriangleMesh fixed = sphere({0, 0, 0}, 15, 6);
  const TriangleMesh ball = sphere({0, -40, 0}, radius, 6);  // free at rest
  for (const double way : {12.0, 13.5, 16.0, 20.0}) {
    const double overlap = 15 + radius - (40 - way);
    const Collision found = collide(ball, fixed, shifted(0, way, 0));
    if (overlap <= 0) {
      EXPECT_EQ(found.depth, 0) << way;
      continue;
    }
    // The facets lie up to r (1 − cos(edge / 2r)), 0.03 mm, below the balls.
    EXPECT_NEAR(found.depth, overlap, 0.06) << way;
    EXPECT_NEAR(found.deepest.x(), 0, 1.0);
    EXPECT_NEAR(found.deepest.z(), 0, 1.0);
  }
}

TEST(Collision, TurningCountsAsMuchAsShifting) {
  RigidMotion turn;
  turn.rotation = Eigen::AngleAxisd(0.2, Vector3d::UnitZ()).toRotationMatrix();
  // Of the touching side's vertices, 2 mm apart, (0, 8) lies deepest: the corner (0, 10) is by then
  // within 0.2 mm of the other block's outer side.
  const Collision found = collide(left_block, right_block, turn);
  EXPECT_NEAR(found.deepest.x(), -8 * std::sin(0.2), 1e-9);
  EXPECT_NEAR(found.depth, 8 * std::sin(0.2), 1e-9);
}

TEST(Collision, SegmentsCollideWithOneAnotherByTheirRelativeMotion) {
  const TriangleMesh far = box({0, 0, 200}, {5, 5, 5}, 4);
  const CollisionModel model({&right_block, &left_block}, far);
  const RigidMotion away = shifted(3, 8, 1);
  EXPECT_TRUE(model.collisions(std::array{away, away}).empty());  // together
  const auto found = model.collisions(std::array{shifted(1, 8, 1), shifted(-1, 8, 1)});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].segment, 0);
  EXPECT_EQ(found[0].other, 1);
  EXPECT_NEAR(found[0].depth, 2, 1e-9);
  // Where they are now, not where they were.
  EXPECT_GE(found[0].places.col(1).minCoeff(), -2 - 1e-9);
  EXPECT_LE(found[0].places.col(0).cwiseAbs().maxCoeff(), 1 + 1e-9);
}

TEST(Collision, ConcaveBoneHoldsWhatIsInIt) {
  // A cup: a ball within its hollow touches nothing until it comes to the wall.
  const TriangleMesh outer = sphere({0, 0, 0}, 30, 5);
  TriangleMesh inner = sphere({0, 0, 0}, 20, 5);
  inner.triangles.col(0).swap(inner.triangles.col(1));  // the hollow's side faces inward
  const TriangleMesh shell = joined(outer, inner);
  const TriangleMesh ball = sphere({0, 0, 0}, 10, 5);
  EXPECT_EQ(collide(ball, shell, shifted(0, 0, 9)).depth, 0);
  EXPECT_NEAR(collide(ball, shell, shifted(0, 0, 13)).depth, 3, 0.1);
}

TEST(Collision, RayChoosesTheFirstSegment) {
  const TriangleMesh fixed = box({0, 30, 0}, {5, 5, 5}, 2);
  const CollisionModel model({&right_block, &left_block}, fixed);
  const std::array still{RigidMotion{}, RigidMotion{}};
  const Vector3d back = Vector3d::UnitY();
  EXPECT_EQ(model.segment_at({-5, -100, 0}, back, still), 0);
  EXPECT_EQ(model.segment_at({5, -100, 0}, back, still), 1);
  EXPECT_EQ(model.segment_at({50, -100, 0}, back, still), -1);
  EXPECT_EQ(model.segment_at({2, 100, 0}, -back, still), -1);  // fixed bone is before it
  EXPECT_EQ(model.segment_at({50, -100, 0}, back, std::array{RigidMotion{}, shifted(40, 0, 0)}), 1);
}

TEST(Collision, IsQuickEnoughForADrag) {
  const TriangleMesh fixed = sphere({0, 0, 0}, 60, 7);     // 98 306 vertices
  const TriangleMesh ball = sphere({0, -80.5, 0}, 20, 6);  // 24 578
  const CollisionModel model({&ball}, fixed);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 20; ++i) {
    const std::array poses{shifted(0.1 * i, 6, 0)};
    const auto begin = std::chrono::steady_clock::now();
    const auto found = model.collisions(poses);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].depth, 5.5, 0.2);
    best = std::min(best, took.count());
  }
  std::cout << "collisions of a drag's frame: " << best << " ms\n";
}

}  // namespace
}  // namespace gnathion::test
