#include "imaging/reduced_volume.h"

#include <gtest/gtest.h>

namespace gnathion::test {
namespace {

/// 8 × 6 × 5 voxels of 0.5 × 1 × 2 mm; HU rise by 10 a voxel along i and by 100 along k.
CtVolume ramp() {
  std::vector<std::int16_t> hu;
  for (int k = 0; k < 5; ++k) {
    for (int j = 0; j < 6; ++j) {
      for (int i = 0; i < 8; ++i) hu.push_back(static_cast<std::int16_t>(10 * i + 100 * k));
    }
  }
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.diagonal() << 0.5, 1, 2, 1;
  affine(0, 3) = 7;
  return {{8, 6, 5}, hu, affine, "ramp"};
}

TEST(ReducedVolume, HoldsTheMeansAtTheirPlaces) {
  const CtVolume volume = ramp();
  const CtVolume small = reduced(volume, 2);
  EXPECT_EQ(small.dims(), Eigen::Vector3i(2, 3, 5));
  EXPECT_LT((small.steps() - Eigen::Vector3d(2, 2, 2)).norm(), 1e-12);
  for (int k = 0; k < 5; ++k) {
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(small.at(i, 1, k), 40 * i + 15 + 100 * k);
      // Along a ramp the mean is the value in the block's middle.
      EXPECT_NEAR(volume.sample(small.lps(Eigen::Vector3d(i, 1, k))), small.at(i, 1, k), 1e-9);
    }
  }
}

TEST(ReducedVolume, LeavesACoarseVolumeAsItIs) {
  const CtVolume volume = ramp();
  const CtVolume same = reduced(volume, 0.4);
  EXPECT_EQ(same.dims(), volume.dims());
  EXPECT_EQ(&same.hu(), &volume.hu());
}

}  // namespace
}  // namespace gnathion::test
