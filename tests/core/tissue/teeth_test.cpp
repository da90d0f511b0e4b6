#include "tissue/teeth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <random>

#include "phantom/phantom_ct.h"
#include "synthetic_ct.h"

namespace gnathion {
namespace {

using testing::grid;
using testing::synthetic_ct;

/// A jaw as a plate: bone for 0 <= y <= 10 and z <= 40, its outer face at y = 0; seven crowns
/// 6 mm wide and deep stand on its rim, from z = 32 to 40. Soft tissue elsewhere.
double jaw(const Eigen::Vector3d& x, double crown_hu = 2600) {
  const bool bone = x.y() >= 0 && x.y() <= 10 && x.z() <= 40 && x.x() >= 0 && x.x() <= 56;
  if (!bone) return 40;
  const double along = x.x() - 8 * std::floor(x.x() / 8);
  return x.z() >= 32 && along >= 1 && along <= 7 && x.y() <= 6 ? crown_hu : 1400;
}

CtVolume jaw_ct(const std::function<double(const Eigen::Vector3d&)>& hu,
                const Eigen::Matrix4d& affine = grid({0.8, 0.8, 1}, {-5, -6, -5.5})) {
  return synthetic_ct({82, 26, 50}, affine, hu);
}

/// Points of the outer face of the jaw at the middle of the fourth crown, at these heights.
Points up_the_jaw(const std::vector<double>& heights) {
  Points points(static_cast<Eigen::Index>(heights.size()), 3);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) << 28, 0, heights[i];
  }
  return points;
}

const std::vector<double> heights = {0, 10, 22, 25, 28.5, 33, 36, 40};
const std::vector<BoneCover> truth = {
    BoneCover::periosteum, BoneCover::periosteum, BoneCover::periosteum, BoneCover::gum,
    BoneCover::gum,        BoneCover::tooth,      BoneCover::tooth,      BoneCover::tooth};

TEST(Teeth, CrownsAndGumsOfAJawAreFound) {
  const Crowns crowns = find_crowns(jaw_ct([](const auto& x) { return jaw(x); }));
  EXPECT_EQ(crowns.piece_count, 7);
  EXPECT_NEAR(crowns.volume_mm3, 7 * 6 * 6 * 8, 0.2 * 7 * 6 * 6 * 8);
  EXPECT_GE(crowns.border.col(2).minCoeff(), 32);
  EXPECT_EQ(bone_cover(crowns, up_the_jaw(heights)), truth);
}

TEST(Teeth, NoiseAndFillingsChangeNothing) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 60);
  const CtVolume ct = jaw_ct([&](const Eigen::Vector3d& x) {
    const bool filling = (x - Eigen::Vector3d(28, 2, 37)).norm() < 2;
    return filling ? 3071 : jaw(x) + noise(random);
  });
  EXPECT_EQ(bone_cover(find_crowns(ct), up_the_jaw(heights)), truth);
}

TEST(Teeth, BrightSpecksAndLonelyDenseBoneAreNoTeeth) {
  const CtVolume ct = jaw_ct([](const Eigen::Vector3d& x) {
    // Every fourth voxel of the chin by itself, and a dense spot of 4 × 4 × 4 mm.
    const Eigen::Vector3i ijk =
        ((x - Eigen::Vector3d(-5, -6, -5.5)).array() / Eigen::Array3d(0.8, 0.8, 1))
            .round()
            .cast<int>();
    const bool speck = (ijk.array() - 4 * (ijk.array() / 4)).matrix().isZero() && x.z() < 8;
    const bool dense = (x - Eigen::Vector3d(50, 5, 10)).cwiseAbs().maxCoeff() <= 2;
    return jaw(x, 1400) > 1000 && (speck || dense) ? 2800 : jaw(x, 1400);
  });
  const Crowns crowns = find_crowns(ct);
  EXPECT_EQ(crowns.piece_count, 0);
  EXPECT_EQ(crowns.volume_mm3, 0);
  // The same spots are found when the limits on volume are taken away, so it is these that hold.
  EXPECT_GT(find_crowns(ct, {2000, 0, 0, 15}).piece_count, 50);
  EXPECT_EQ(find_crowns(ct, {2000, 10, 0, 15}).piece_count, 1);
}

TEST(Teeth, AToothFarFromTheOthersNeedsTheirVolumeItself) {
  const auto one_more = [](double side) {
    return jaw_ct([side](const Eigen::Vector3d& x) {
      const double far = (x - Eigen::Vector3d(28, 5, 5)).cwiseAbs().maxCoeff();
      return far <= side / 2 ? 2600 : jaw(x);
    });
  };
  EXPECT_EQ(find_crowns(one_more(4)).piece_count, 7);
  EXPECT_EQ(find_crowns(one_more(4), {2000, 10, 100, 30}).piece_count, 8);
  EXPECT_EQ(find_crowns(one_more(6)).piece_count, 8);
}

TEST(Teeth, WithoutEnamelThereAreNone) {
  const Crowns crowns = find_crowns(jaw_ct([](const auto& x) { return jaw(x, 1800); }));
  EXPECT_EQ(crowns.piece_count, 0);
  const auto cover = bone_cover(crowns, up_the_jaw(heights));
  EXPECT_EQ(std::count(cover.begin(), cover.end(), BoneCover::periosteum), 8);
}

TEST(Teeth, TheGridsPlaceInThePatientDoesNotMatter) {
  // The same jaw in a grid that is turned, mirrored and elsewhere.
  Eigen::Affine3d turn = Eigen::Translation3d(30, -120, 60) *
                         Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, -1).normalized()) *
                         Eigen::Scaling(-1.0, 1.0, 1.0);
  const CtVolume ct = jaw_ct([&](const Eigen::Vector3d& x) { return jaw(turn.inverse() * x); },
                             turn.matrix() * grid({0.8, 0.8, 1}, {-5, -6, -5.5}));
  Points points = up_the_jaw(heights);
  for (auto row : points.rowwise()) row = (turn * row.transpose()).transpose().eval();
  const Crowns crowns = find_crowns(ct);
  EXPECT_EQ(crowns.piece_count, 7);
  EXPECT_EQ(bone_cover(crowns, points), truth);
}

TEST(Teeth, TheAnalyticHeadHasTwoRowsAndNothingElse) {
  const HeadModel head;
  PhantomOptions options;
  options.pixel_mm = options.slice_step_mm = 2;
  Progress progress;
  PhantomVolume volume = make_phantom_volume(head, options, progress);
  const CtVolume ct(volume.size, std::move(volume.hounsfield), grid(volume.spacing, volume.origin),
                    "phantom");
  const Crowns crowns = find_crowns(ct);
  EXPECT_GT(crowns.volume_mm3, 4000);
  double farthest = 0;
  for (const auto& x : crowns.border.rowwise()) farthest = std::max(farthest, head.teeth(x));
  EXPECT_LT(farthest, 0.5);  // mm outside the truth
  const std::map<std::string, Eigen::Vector3d> landmarks = phantom_truth().landmarks;
  const auto cover_at = [&](const Eigen::Vector3d& x) {
    return bone_cover(crowns, Points(x.transpose()))[0];
  };
  EXPECT_EQ(cover_at(landmarks.at("upper_incisor_edge")), BoneCover::tooth);
  EXPECT_EQ(cover_at(landmarks.at("lower_incisor_edge")), BoneCover::tooth);
  for (const char* bone : {"nasion", "pogonion", "menton", "gonion_left", "condyle_right"}) {
    EXPECT_EQ(cover_at(landmarks.at(bone)), BoneCover::periosteum) << bone;
  }
}

}  // namespace
}  // namespace gnathion
