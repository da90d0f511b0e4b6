#include "tissue/tissue_from_ct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/tet_quality.h"
#include "support/expect_error.h"
#include "support/solids.h"
#include "synthetic_ct.h"

namespace gnathion {
namespace {

using testing::grid;
using testing::synthetic_ct;

/// A box of 1 mm cubes of six tets each: 0 <= x, y <= n, −depth <= z <= 0.
TetMesh block(int n, int depth) {
  const auto node = [&](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  TetMesh mesh{Points((n + 1) * (n + 1) * (depth + 1), 3), Tets(6 * n * n * depth, 4)};
  for (int k = 0; k <= depth; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) mesh.vertices.row(node(i, j, k)) << i, j, k - depth;
    }
  }
  const int paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  int t = 0;
  for (int cube = 0; cube < n * n * depth; ++cube) {
    for (int p = 0; p < 6; ++p) {
      Eigen::Vector3i at(cube % n, cube / n % n, cube / (n * n));
      for (int corner = 0; corner < 4; ++corner) {
        mesh.tets(t, corner) = node(at.x(), at.y(), at.z());
        if (corner < 3) ++at[paths[p][corner]];
      }
      if (p >= 3) std::swap(mesh.tets(t, 2), mesh.tets(t, 3));  // odd paths turn the other way
      ++t;
    }
  }
  return mesh;
}

/// Air above z = 0, then 2 mm of skin, fat down to −7, muscle down to −13, bone below.
double layers(const Eigen::Vector3d& x) {
  if (x.z() > 0) return -1000;
  if (x.z() > -2) return 30;
  if (x.z() > -7) return -100;
  return x.z() > -13 ? 55 : 900;
}

CtVolume layered_ct(double noise_hu = 0) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 1);
  return synthetic_ct(
      {24, 24, 56}, grid({0.5, 0.5, 0.4}, {-2, -2, -20.2}),
      [&](const Eigen::Vector3d& x) { return layers(x) + noise_hu * noise(random); });
}

TissueConstants skin_of(double mm) {
  TissueConstants constants;
  constants.skin_mm = mm;
  return constants;
}

Eigen::Vector3d centre_of(const TetMesh& mesh, Eigen::Index t) {
  return mesh.vertices(mesh.tets.row(t), Eigen::all).colwise().mean();
}

TissueKind kind_of(const TissueFromCt& tissue, Eigen::Index t) {
  return static_cast<TissueKind>(tissue.materials.of_tet[static_cast<std::size_t>(t)]);
}

/// Tets nearer than `margin` mm to a border between tissues are not asked.
void expect_layers(const CtVolume& ct, double margin, double volume_tolerance) {
  const TetMesh mesh = block(6, 12);
  const TissueFromCt tissue = tissue_from_ct(ct, mesh, -mesh.vertices.col(2), skin_of(2));
  ASSERT_EQ(static_cast<Eigen::Index>(tissue.materials.of_tet.size()), mesh.tets.rows());
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const double z = centre_of(mesh, t).z();
    if (std::abs(z + 7) < margin) continue;
    const TissueKind truth = z > -2   ? TissueKind::skin
                             : z > -7 ? TissueKind::fat
                                      : TissueKind::muscle;
    EXPECT_EQ(kind_of(tissue, t), truth) << "tet " << t << " at z " << z;
  }
  EXPECT_NEAR(tissue.of(TissueKind::skin).volume_mm3, 36 * 2, 1e-9);
  EXPECT_NEAR(tissue.of(TissueKind::fat).volume_mm3, 36 * 5, volume_tolerance);
  EXPECT_NEAR(tissue.of(TissueKind::muscle).volume_mm3, 36 * 5, volume_tolerance);
  long tets = 0;
  for (const TissueFromCt::Share& share : tissue.share) tets += share.tets;
  EXPECT_EQ(tets, mesh.tets.rows());
  EXPECT_EQ(tissue.unclear, 0);
}

TEST(TissueFromCt, LayersAreFound) {
  expect_layers(layered_ct(), 0, 1e-9);
}

// Next to a border, within the CT's voxel, noise may decide.
TEST(TissueFromCt, LayersAreFoundInNoise) {
  expect_layers(layered_ct(25), 0.4, 36 * 0.1);
}

TEST(TissueFromCt, ATetIsSkinWhereHalfOfItIs) {
  // A tet from the surface to 10 mm below: the part above depth d is 1 − (1 − d/10)³; half of it
  // at d = 2.06 mm.
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << 0, 0, 0, 0, 6, 0, 6, 0, 0, 2, 2, -10;
  mesh.tets << 0, 1, 2, 3;
  ASSERT_GT(tet_volumes(mesh)[0], 0);
  const Eigen::VectorXd depth = -mesh.vertices.col(2);
  const CtVolume ct = layered_ct();
  EXPECT_EQ(kind_of(tissue_from_ct(ct, mesh, depth, skin_of(2.05)), 0), TissueKind::fat);
  EXPECT_EQ(kind_of(tissue_from_ct(ct, mesh, depth, skin_of(2.07)), 0), TissueKind::skin);
}

TEST(TissueFromCt, HalfATetIsExactWhateverItsDepths) {
  // The median depth of a tet by its volume, found by bisection on the classification, against
  // evenly spread points.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << 0, 0, 0, 0, 6, 0, 6, 0, 0, 2, 2, -10;
  mesh.tets << 0, 1, 2, 3;
  const CtVolume ct = layered_ct();
  for (const Eigen::Vector4d& depth :
       {Eigen::Vector4d(0, 0, 0, 4), Eigen::Vector4d(0, 0, 5, 5), Eigen::Vector4d(4, 1, 3, 0),
        Eigen::Vector4d(2, 6, 6, 6), Eigen::Vector4d(0, 0.1, 7, 9)}) {
    double low = 0, high = 10;
    for (int round = 0; round < 40; ++round) {
      const double middle = (low + high) / 2;
      const TissueFromCt tissue = tissue_from_ct(ct, mesh, depth, skin_of(middle));
      (kind_of(tissue, 0) == TissueKind::skin ? high : low) = middle;
    }
    std::vector<double> depths(200001);
    for (double& d : depths) {
      Eigen::Vector4d w;
      for (double& x : w) x = -std::log(1 - uniform(random));  // Dirichlet: uniform on the simplex
      d = depth.dot(w) / w.sum();
    }
    std::nth_element(depths.begin(), depths.begin() + 100000, depths.end());
    EXPECT_NEAR(high, depths[100000], 0.03) << depth.transpose();
  }
}

TEST(TissueFromCt, BoneAndAirTakeNoPart) {
  // Of a tet half in fat and half in bone, or half in fat and half in air, only the fat counts.
  const auto half = [](double other) {
    return synthetic_ct({24, 24, 56}, grid({0.5, 0.5, 0.4}, {-2, -2, -20.2}),
                        [=](const Eigen::Vector3d& x) { return x.z() > -5 ? -100.0 : other; });
  };
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << 0, 0, -3, 0, 6, -3, 6, 0, -3, 2, 2, -12;
  mesh.tets << 0, 1, 2, 3;
  const Eigen::VectorXd depth = -mesh.vertices.col(2);
  for (const double other : {900.0, -1000.0}) {
    const TissueFromCt tissue = tissue_from_ct(half(other), mesh, depth);
    EXPECT_EQ(kind_of(tissue, 0), TissueKind::fat) << other;
    EXPECT_EQ(tissue.unclear, 0);
  }
  EXPECT_EQ(kind_of(tissue_from_ct(half(140), mesh, depth), 0), TissueKind::muscle);
}

TEST(TissueFromCt, WhatIsNoSoftTissueIsMuscleAndSaysSo) {
  TetMesh mesh = block(3, 2);
  mesh.vertices.col(2).array() -= 15;  // within the bone
  TissueFromCt tissue = tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2));
  EXPECT_EQ(tissue.unclear, mesh.tets.rows());
  EXPECT_EQ(tissue.of(TissueKind::muscle).tets, mesh.tets.rows());
  mesh.vertices.col(0).array() += 500;  // outside the CT
  tissue = tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2));
  EXPECT_EQ(tissue.unclear, mesh.tets.rows());
}

TEST(TissueFromCt, MaterialsAreTheConstants) {
  const TetMesh mesh = block(3, 12);
  TissueConstants constants = skin_of(2);
  constants.fat = {0.002, 0.48};
  const TissueFromCt tissue = tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2), constants);
  ASSERT_EQ(tissue.materials.kinds.size(), 3u);
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const ElasticMaterial& found = tissue.materials[t];
    const ElasticMaterial& expected = kind_of(tissue, t) == TissueKind::fat    ? constants.fat
                                      : kind_of(tissue, t) == TissueKind::skin ? constants.skin
                                                                               : constants.muscle;
    EXPECT_EQ(found.young_MPa, expected.young_MPa);
    EXPECT_EQ(found.poisson, expected.poisson);
  }
  EXPECT_LT(TissueConstants().fat.young_MPa, TissueConstants().muscle.young_MPa);
  EXPECT_LT(TissueConstants().muscle.young_MPa, TissueConstants().skin.young_MPa);
}

TEST(TissueFromCt, ConstantsOutOfRangeAreRefused) {
  const TetMesh mesh = block(1, 1);
  TissueConstants constants;
  constants.fat.poisson = 0.5;
  test::expect_error(ErrorKind::case_file, {"poisson"},
                     [&] { tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2), constants); });
}

TEST(TissueFromCt, DepthsAreDistancesFromTheSkin) {
  const TriangleMesh skin = test::box({0, 0, 0}, {10, 10, 10}, 4);
  Points points(3, 3);
  points << 0, 0, 10, 1, 2, 7, 0, 0, 0;
  EXPECT_TRUE(depths_below(points, BspTree(skin)).isApprox(Eigen::Vector3d(0, 3, 10)));
  test::expect_error(ErrorKind::anatomy, {"skin"},
                     [&] { depths_below(points, BspTree(TriangleMesh{})); });
}

}  // namespace
}  // namespace gnathion
