#include "imaging/ct_slice.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace gnathion::test {
namespace {

constexpr int side = 40;
constexpr double pi = 3.14159265358979323846;

Eigen::Matrix4d affine(const Eigen::Matrix3d& linear) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = linear;
  // The middle voxel lies at LPS zero.
  matrix.topRightCorner<3, 1>() = -linear * Eigen::Vector3d::Constant((side - 1) / 2.0);
  return matrix;
}

/// How a scanner or a converter may lay its voxels into the patient.
std::map<std::string, Eigen::Matrix4d> affines() {
  const Eigen::Vector3d spacing(1, 1, 1.5);
  const Eigen::Matrix3d straight = spacing.asDiagonal();
  Eigen::Matrix3d swapped;  // i runs down, j to the right, k forward
  swapped << 0, -1, 0, 0, 0, -1.5, -1, 0, 0;
  Eigen::Matrix3d tilted = straight;  // a gantry by 15°: the slices are shifted, not turned
  tilted(1, 2) = 1.5 * std::tan(15 * pi / 180);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirrored = Eigen::Vector3d(-1, 1, 1).asDiagonal() * straight;
  return {{"straight", affine(straight)},
          {"left-handed", affine(mirrored)},
          {"upside down", affine(Eigen::Vector3d(1, 1, -1).asDiagonal() * straight)},
          {"turned about", affine(Eigen::Vector3d(-1, -1, 1).asDiagonal() * straight)},
          {"swapped", affine(swapped)},
          {"tilted gantry", affine(tilted)},
          {"oblique", affine(turn * straight)},
          {"oblique, left-handed", affine(turn * mirrored)}};
}

/// Air with a dense ball around each of some places of the patient.
CtVolume with_balls(const Eigen::Matrix4d& lps_from_ijk,
                    const std::vector<std::pair<Eigen::Vector3d, std::int16_t>>& balls) {
  std::vector<std::int16_t> hu;
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const Eigen::Vector3d lps = (lps_from_ijk * Eigen::Vector4d(i, j, k, 1)).head<3>();
        std::int16_t value = -1000;
        for (const auto& [centre, dense] : balls) {
          if ((lps - centre).norm() < 3) value = dense;
        }
        hu.push_back(value);
      }
    }
  }
  return {{side, side, side}, std::move(hu), lps_from_ijk, "phantom"};
}

/// Mean pixel of those near a value, or (−1, −1).
Eigen::Vector2d place_of(const CtSlice& slice, int value) {
  Eigen::Vector2d sum(0, 0);
  int count = 0;
  for (int y = 0; y < slice.height; ++y) {
    for (int x = 0; x < slice.width; ++x) {
      if (std::abs(slice.at(x, y) - value) > 60) continue;
      sum += Eigen::Vector2d(x, y);
      ++count;
    }
  }
  if (count == 0) return {-1, -1};
  return sum / count;
}

/// The edge of the picture that the place is nearest to, by its letter.
char edge_letter(SlicePlane plane, const CtSlice& slice, const Eigen::Vector2d& place) {
  const Eigen::Vector2d off = place - Eigen::Vector2d(slice.width - 1, slice.height - 1) / 2;
  const SliceLetters letters = letters_of(plane);
  if (std::abs(off.x() * slice.pixel.x()) > std::abs(off.y() * slice.pixel.y())) {
    return off.x() < 0 ? letters.left : letters.right;
  }
  return off.y() < 0 ? letters.top : letters.bottom;
}

TEST(CtSlice, LettersStandWhereThePatientsSidesAre) {
  // Off the middle along one axis each, by letter; a value each.
  const std::map<char, Eigen::Vector3d> directions{{'L', {1, 0, 0}}, {'R', {-1, 0, 0}},
                                                   {'P', {0, 1, 0}}, {'A', {0, -1, 0}},
                                                   {'S', {0, 0, 1}}, {'I', {0, 0, -1}}};
  for (const auto& [name, matrix] : affines()) {
    std::vector<std::pair<Eigen::Vector3d, std::int16_t>> balls;
    std::map<char, std::int16_t> values;
    for (const auto& [letter, direction] : directions) {
      values[letter] = static_cast<std::int16_t>(500 + 400 * values.size());
      balls.emplace_back(11 * direction, values[letter]);
    }
    const CtVolume volume = with_balls(matrix, balls);
    const SliceLattice lattice = slice_lattice(volume);
    for (const SlicePlane plane : all_slice_planes) {
      CtSlice slice;
      cut_slice(volume, lattice, plane, lattice.nearest({0, 0, 0}), slice);
      int seen = 0;
      for (const auto& [letter, direction] : directions) {
        if (std::abs(direction(normal_axis(plane))) > 0.5) continue;
        const Eigen::Vector2d place = place_of(slice, values[letter]);
        ASSERT_GE(place.x(), 0) << name << ' ' << letter;
        EXPECT_EQ(edge_letter(plane, slice, place), letter) << name;
        ++seen;
      }
      EXPECT_EQ(seen, 4);
    }
  }
}

TEST(CtSlice, RadiologistsConvention) {
  const SliceLetters axial = letters_of(SlicePlane::axial);
  EXPECT_EQ((std::string{axial.left, axial.right, axial.top, axial.bottom}), "RLAP");
  const SliceLetters coronal = letters_of(SlicePlane::coronal);
  EXPECT_EQ((std::string{coronal.left, coronal.right, coronal.top, coronal.bottom}), "RLSI");
  const SliceLetters sagittal = letters_of(SlicePlane::sagittal);
  EXPECT_EQ((std::string{sagittal.left, sagittal.right, sagittal.top, sagittal.bottom}), "APSI");
}

CtVolume noise(const Eigen::Matrix4d& matrix) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> value(-1024, 3071);
  std::vector<std::int16_t> hu(static_cast<std::size_t>(side) * side * side);
  for (std::int16_t& v : hu) v = static_cast<std::int16_t>(value(random));
  return {{side, side, side}, std::move(hu), matrix, "noise"};
}

TEST(CtSlice, EveryPixelIsTheVolumesOwnSample) {
  for (const auto& [name, matrix] : affines()) {
    const CtVolume volume = noise(matrix);
    const SliceLattice lattice = slice_lattice(volume);
    for (const SlicePlane plane : all_slice_planes) {
      const Eigen::Vector3d through = lattice.nearest({2, -3, 4});
      CtSlice slice;
      cut_slice(volume, lattice, plane, through, slice);
      int inside = 0;
      for (int y = 0; y < slice.height; ++y) {
        for (int x = 0; x < slice.width; ++x) {
          const Eigen::Vector2d at =
              slice.corner + Eigen::Vector2d(x + 0.5, y + 0.5).cwiseProduct(slice.pixel);
          const double sample = volume.sample(lps_from_picture(plane, at, through), -5000);
          if (sample < -4000) continue;
          ++inside;
          ASSERT_NEAR(slice.at(x, y), sample, 0.8) << name << ' ' << x << ' ' << y;
        }
      }
      EXPECT_GT(inside, 600) << name;
    }
  }
}

TEST(CtSlice, StraightVolumesComeVoxelForVoxel) {
  const std::map<std::string, Eigen::Matrix4d> all = affines();
  for (const char* name : {"straight", "left-handed", "upside down", "turned about"}) {
    const CtVolume volume = noise(all.at(name));
    const SliceLattice lattice = slice_lattice(volume);
    EXPECT_EQ(lattice.count, Eigen::Vector3i(side, side, side)) << name;
    const Eigen::Vector3d through = lattice.nearest({1, 1, 1});
    CtSlice slice;
    cut_slice(volume, lattice, SlicePlane::coronal, through, slice);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const Eigen::Vector2d at =
            slice.corner + Eigen::Vector2d(x + 0.5, y + 0.5).cwiseProduct(slice.pixel);
        const Eigen::Vector3d ijk =
            volume.ijk(lps_from_picture(SlicePlane::coronal, at, through)).array().round();
        ASSERT_EQ(slice.at(x, y), volume.at(static_cast<int>(ijk.x()), static_cast<int>(ijk.y()),
                                            static_cast<int>(ijk.z())));
      }
    }
  }
}

TEST(CtSlice, WhereThereIsNoVoxelThereIsNoValue) {
  const CtVolume volume = noise(affines().at("tilted gantry"));
  const SliceLattice lattice = slice_lattice(volume);
  CtSlice slice;
  cut_slice(volume, lattice, SlicePlane::sagittal, {0, 0, 0}, slice);
  // The shear leaves two corners without voxels: behind below and before above.
  EXPECT_EQ(slice.at(slice.width - 1, slice.height - 1), outside_volume);
  EXPECT_EQ(slice.at(0, 0), outside_volume);
  EXPECT_NE(slice.at(slice.width - 1, 0), outside_volume);
  EXPECT_NE(slice.at(0, slice.height - 1), outside_volume);
}

TEST(CtSlice, PicturePlacesGoBackToThePatient) {
  const Eigen::Vector3d p(12, -34, 56);
  for (const SlicePlane plane : all_slice_planes) {
    EXPECT_EQ(lps_from_picture(plane, picture_from_lps(plane, p), p), p);
    const SliceAxes axes = axes_of(plane);
    EXPECT_EQ(std::abs(axes.onward(normal_axis(plane))), 1);
    EXPECT_EQ(axes.right.dot(axes.down), 0);
  }
}

TEST(CtSlice, LatticeHoldsWhatIsNear) {
  const CtVolume volume = noise(affines().at("straight"));
  const SliceLattice lattice = slice_lattice(volume);
  EXPECT_EQ(lattice.step, Eigen::Vector3d(1, 1, 1.5));
  EXPECT_LT((lattice.nearest({0.4, 0.6, -0.7}) - Eigen::Vector3d(0.5, 0.5, -0.75)).norm(), 1e-12);
  EXPECT_EQ(lattice.nearest({1e4, 1e4, 1e4}), lattice.last());
  EXPECT_EQ(lattice.nearest({-1e4, -1e4, -1e4}), lattice.origin);
}

}  // namespace
}  // namespace gnathion::test
