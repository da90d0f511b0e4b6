#include "bone/cut_box.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace gnathion::test {
namespace {

RigidMotion motion() {
  return {Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 2).normalized()).toRotationMatrix(),
          {3, -4, 5}};
}

PlateCut plate() {
  PlateCut cut;
  cut.centre = {1, 2, 3};
  cut.normal = {0, 1, 2};
  cut.in_plane = {1, 1, 0};
  cut.half_width = 20;
  cut.half_height = 10;
  cut.kerf = 0.8;
  cut.seed = {1, 8, 9};
  return cut;
}

TEST(CutBox, OfAPlateHasTheKerfAsItsThickness) {
  const BoxCut box = box_of(plate());
  EXPECT_EQ(box.centre, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(box.half_extents, Eigen::Vector3d(20, 10, 0.4));
  EXPECT_LT((box.axes.col(2) - Eigen::Vector3d(0, 1, 2).normalized()).norm(), 1e-12);
  EXPECT_NEAR(box.axes.determinant(), 1, 1e-12);
}

TEST(CutBox, MovesWithItsSeedAndTellsTheMotion) {
  for (const BoundedCut& cut :
       {BoundedCut(plate()), BoundedCut(box_between({0, 1, 2}, {5, 7, 9}))}) {
    const BoundedCut there = moved(cut, motion());
    EXPECT_LT((box_of(there).centre - motion()(box_of(cut).centre)).norm(), 1e-12);
    EXPECT_EQ(box_of(there).half_extents, box_of(cut).half_extents);
    const RigidMotion told = motion_between(cut, there);
    EXPECT_LT((told.rotation - motion().rotation).norm(), 1e-12);
    EXPECT_LT((told.translation - motion().translation).norm(), 1e-12);
  }
  const auto there = std::get<PlateCut>(moved(plate(), motion()));
  EXPECT_LT((there.seed - motion()(plate().seed)).norm(), 1e-12);
}

TEST(CutBox, TakesOtherExtents) {
  const Eigen::Vector3d half(7, 6, 0.5);
  for (const BoundedCut& cut :
       {BoundedCut(plate()), BoundedCut(box_between({0, 1, 2}, {5, 7, 9}))}) {
    const BoxCut box = box_of(with_half_extents(cut, half));
    EXPECT_EQ(box.half_extents, half);
    EXPECT_EQ(box.centre, box_of(cut).centre);
    EXPECT_EQ(box.axes, box_of(cut).axes);
  }
}

}  // namespace
}  // namespace gnathion::test
