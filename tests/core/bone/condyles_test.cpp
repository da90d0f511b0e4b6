#include "bone/condyles.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/triangle_mesh.h"
#include "imaging/ct_import.h"
#include "imaging/surfaces.h"
#include "phantom/head_model.h"
#include "support/expect_error.h"
#include "support/head_ct.h"
#include "support/solids.h"

namespace gnathion::test {
namespace {

using Eigen::Vector3d;

constexpr double step = 2;  // mm, of the grid on which the head is sampled

/// The embedded head's bone up to a height, by its distance function.
TriangleMesh head_bone(double top) {
  const HeadModel head;
  const Vector3d low(-76, -120, -104);
  const Eigen::Vector3i size(77, 66, static_cast<int>((top - low.z()) / step) + 1);
  std::vector<std::int16_t> hu;
  for (int k = 0; k < size.z(); ++k) {
    for (int j = 0; j < size.y(); ++j) {
      for (int i = 0; i < size.x(); ++i) {
        const double d = head.bone(low + step * Vector3d(i, j, k));
        hu.push_back(static_cast<std::int16_t>(std::clamp(250 - 200 * d, -900.0, 1500.0)));
      }
    }
  }
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  frame.topLeftCorner<3, 3>() *= step;
  frame.topRightCorner<3, 1>() = low;
  BoneSurfaceOptions options;
  options.remove_support = false;
  Progress progress;
  return bone_surface(CtVolume(size, std::move(hu), frame, "head"), options, progress);
}

TEST(Condyles, AreFoundOnTheEmbeddedHead) {
  const Condyles found = find_condyles(head_bone(60), {0, -90, -75});
  // The centres of the ellipsoids that the head is made of.
  EXPECT_LT((found.left - Vector3d(50, -16, -4)).norm(), 2.5) << found.left.transpose();
  EXPECT_LT((found.right - Vector3d(-50, -16, -4)).norm(), 2.5) << found.right.transpose();
}

TEST(Condyles, OutsideTheCtAreNotMadeUp) {
  for (const double top : {-8.0, -30.0}) {
    expect_error(ErrorKind::anatomy, {"condyles"}, [&] {
      find_condyles(head_bone(top), {0, -90, -75});
    });
  }
}

TEST(Condyles, SkullAndOtherPiecesAreNoJaw) {
  const TriangleMesh head = head_bone(60);
  expect_error(ErrorKind::anatomy, {"condyles"}, [&] { find_condyles(head, {0, -95, 30}); });
  const TriangleMesh tall = box({0, 0, 0}, {50, 50, 80}, 8);
  expect_error(ErrorKind::anatomy, {"one piece"}, [&] { find_condyles(tall, {0, -50, 0}); });
  const TriangleMesh bar = joined(box({0, 0, 0}, {50, 6, 6}, 8), box({0, 0, 90}, {5, 5, 5}, 2));
  expect_error(ErrorKind::anatomy, {"do not lie"}, [&] { find_condyles(bar, {0, 0, 0}); });
  expect_error(ErrorKind::anatomy, {"no bone"}, [] { find_condyles({}, {0, 0, 0}); });
}

TEST(Condyles, OfTheRealCt) {
  const auto folder = head_ct_folder();
  if (folder.empty()) GTEST_SKIP() << "the shared CT is not there";
  Progress progress;
  const TriangleMesh bone = bone_surface(read_ct(folder, {}, progress), {}, progress);
  // Its teeth meet, so that jaw and skull are one piece of bone at this level.
  expect_error(ErrorKind::anatomy, {"one piece", "type two points"}, [&] {
    find_condyles(bone, {2.5, -290, 345});
  });
}

}  // namespace
}  // namespace gnathion::test
