#include "tissue/tissue_from_ct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

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

/// The modulus of a tet with this part of skin.
double mixed_young(const ElasticMaterial& rest, double skin) {
  return skin * TissueConstants().skin.young_MPa + (1 - skin) * rest.young_MPa;
}

/// A single tet of 6 mm² base, its apex below the others.
TetMesh one_tet(double top = 0, double apex = -10) {
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << 0, 0, top, 0, 6, top, 6, 0, top, 2, 2, apex;
  mesh.tets << 0, 1, 2, 3;
  return mesh;
}

/// Tets nearer than `margin` mm to a border between tissues are not asked.
void expect_layers(const CtVolume& ct, double margin, double volume_tolerance) {
  const TetMesh mesh = block(6, 12);
  const TissueConstants constants = skin_of(2);
  const TissueFromCt tissue = tissue_from_ct(ct, mesh, -mesh.vertices.col(2), constants);
  ASSERT_EQ(static_cast<Eigen::Index>(tissue.materials.of_tet.size()), mesh.tets.rows());
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    const double z = centre_of(mesh, t).z();
    if (std::abs(z + 7) < margin) continue;
    const ElasticMaterial& truth = z > -2   ? constants.skin
                                   : z > -7 ? constants.fat
                                            : constants.muscle;
    EXPECT_DOUBLE_EQ(tissue.materials[t].young_MPa, truth.young_MPa) << t << " at z " << z;
  }
  EXPECT_NEAR(tissue.of(TissueKind::skin).volume_mm3, 36 * 2, 1e-9);
  EXPECT_NEAR(tissue.of(TissueKind::fat).volume_mm3, 36 * 5, volume_tolerance);
  EXPECT_NEAR(tissue.of(TissueKind::muscle).volume_mm3, 36 * 5, volume_tolerance);
  long tets = 0;
  for (const TissueFromCt::Share& share : tissue.share) tets += share.tets;
  EXPECT_EQ(tets, mesh.tets.rows());
  EXPECT_EQ(tissue.of(TissueKind::skin).tets, 6 * 36 * 2);
  EXPECT_EQ(tissue.unclear, 0);
}

TEST(TissueFromCt, LayersAreFound) {
  expect_layers(layered_ct(), 0, 1e-9);
}

// Next to a border, within the CT's voxel, noise may decide.
TEST(TissueFromCt, LayersAreFoundInNoise) {
  expect_layers(layered_ct(25), 0.4, 36 * 0.1);
}

TEST(TissueFromCt, SkinThinnerThanATetIsMixedIn) {
  // Of a tet from the surface to 10 mm below, 1 − (1 − d/10)³ is above depth d.
  const TetMesh mesh = one_tet();
  const double volume = tet_volumes(mesh)[0];
  for (const double mm : {0.5, 1.5, 2.5}) {
    const double skin = 1 - std::pow(1 - mm / 10, 3);
    const TissueFromCt tissue =
        tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2), skin_of(mm));
    EXPECT_NEAR(tissue.of(TissueKind::skin).volume_mm3, skin * volume, 1e-9);
    EXPECT_NEAR(tissue.of(TissueKind::fat).volume_mm3, (1 - skin) * volume, 1e-9);
    EXPECT_NEAR(tissue.materials[0].young_MPa, mixed_young(TissueConstants().fat, skin),
                0.026 * TissueConstants().skin.young_MPa);
    EXPECT_EQ(tissue.of(TissueKind::skin).tets, skin > 0.5);
  }
}

TEST(TissueFromCt, SkinHasItsVolumeAndStiffnessOnCoarseAndFineMeshes) {
  for (const int tall : {1, 2, 5, 12}) {
    TetMesh mesh = block(4, 12);
    mesh.vertices.col(2) *= tall;  // mm an element
    const TissueFromCt tissue =
        tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2), skin_of(1.5));
    EXPECT_NEAR(tissue.of(TissueKind::skin).volume_mm3, 16 * 1.5, 1e-9) << tall;
    // N/mm: the tension of the topmost elements per strain along the skin, without what is below
    // it.
    double tension = 0;
    const Eigen::VectorXd volumes = tet_volumes(mesh);
    for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
      const double young = tissue.materials[t].young_MPa;
      if (young > TissueConstants().muscle.young_MPa) tension += young * volumes[t] / 16;
    }
    const double below = TissueConstants().muscle.young_MPa * std::max(1, tall);
    EXPECT_NEAR(tension, 1.5 * TissueConstants().skin.young_MPa, below) << tall;
  }
}

TEST(TissueFromCt, PartOfATetIsExactWhateverItsDepths) {
  std::mt19937 random(11);
  std::exponential_distribution<double> exponential;  // normalised: evenly over the simplex
  const CtVolume ct = layered_ct();
  const double volume = tet_volumes(one_tet())[0];
  for (const Eigen::Vector4d& depth :
       {Eigen::Vector4d(0, 0, 0, 4), Eigen::Vector4d(0, 0, 5, 5), Eigen::Vector4d(4, 1, 3, 0),
        Eigen::Vector4d(2, 6, 6, 6), Eigen::Vector4d(0, 0.1, 7, 9), Eigen::Vector4d(3, 3, 3, 3)}) {
    for (const double mm : {0.05, 0.5, 2.0, 2.9, 3.5, 4.9, 8.0}) {
      int inside = 0;
      constexpr int kPoints = 40000;
      for (int i = 0; i < kPoints; ++i) {
        const Eigen::Vector4d w(exponential(random), exponential(random), exponential(random),
                                exponential(random));
        inside += depth.dot(w) <= mm * w.sum();
      }
      const TissueFromCt tissue = tissue_from_ct(ct, one_tet(), depth, skin_of(mm));
      EXPECT_NEAR(tissue.of(TissueKind::skin).volume_mm3 / volume,
                  static_cast<double>(inside) / kPoints, 0.01)
          << depth.transpose() << ", skin " << mm;
    }
  }
}

TEST(TissueFromCt, BoneAndAirTakeNoPart) {
  // Of a tet half in soft tissue and half in bone or air, only the soft tissue counts.
  const auto found = [](double soft, double other) {
    const CtVolume ct =
        synthetic_ct({24, 24, 56}, grid({0.5, 0.5, 0.4}, {-2, -2, -20.2}),
                     [=](const Eigen::Vector3d& x) { return x.z() > -5 ? soft : other; });
    const TetMesh mesh = one_tet(-3, -12);
    const TissueFromCt tissue = tissue_from_ct(ct, mesh, -mesh.vertices.col(2));
    EXPECT_EQ(tissue.unclear, 0);
    return tissue.of(TissueKind::fat).tets == 1 ? TissueKind::fat : TissueKind::muscle;
  };
  EXPECT_EQ(found(-100, 900), TissueKind::fat);
  EXPECT_EQ(found(-100, 140), TissueKind::muscle);
  EXPECT_EQ(found(55, -1000), TissueKind::muscle);
  EXPECT_EQ(found(55, -180), TissueKind::fat);
}

TEST(TissueFromCt, SkinThatBlursIntoFatDoesNotMakeItMuscle) {
  // 1.5 mm of skin, which voxels of 2 mm show as 3 mm.
  const CtVolume ct =
      synthetic_ct({8, 12, 60}, grid({2, 1, 0.5}, {-2, -2, -24}),
                   [](const Eigen::Vector3d& x) { return x.z() > -3 ? 100 : -100; });
  const TetMesh mesh = one_tet(0, -4.5);
  EXPECT_EQ(tissue_from_ct(ct, mesh, -mesh.vertices.col(2)).of(TissueKind::muscle).volume_mm3, 0);
  // A tet that has no part deeper is taken as it is.
  const TetMesh thin = one_tet(0, -3.4);
  EXPECT_GT(tissue_from_ct(ct, thin, -thin.vertices.col(2)).of(TissueKind::muscle).volume_mm3, 0);
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

TEST(TissueFromCt, ConstantsOfAllKindsAreUsed) {
  const TetMesh mesh = block(3, 12);
  TissueConstants constants = skin_of(2);
  constants.fat = {0.002, 0.48};
  constants.muscle = {0.02, 0.3};
  constants.skin = {0.5, 0.4};
  const TissueFromCt tissue = tissue_from_ct(layered_ct(), mesh, -mesh.vertices.col(2), constants);
  std::set<std::pair<double, double>> found;
  for (Eigen::Index t = 0; t < mesh.tets.rows(); ++t) {
    found.emplace(tissue.materials[t].young_MPa, tissue.materials[t].poisson);
  }
  EXPECT_EQ(found, (std::set<std::pair<double, double>>{{0.002, 0.48}, {0.02, 0.3}, {0.5, 0.4}}));
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
