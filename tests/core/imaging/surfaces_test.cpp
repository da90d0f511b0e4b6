#include "imaging/surfaces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <numbers>

#include "geometry/triangle_mesh.h"
#include "imaging/ct_import.h"
#include "support/expect_error.h"
#include "support/head_ct.h"

namespace gnathion::test {
namespace {

using Shape = std::function<double(const Eigen::Vector3d&)>;  // HU at an LPS point

CtVolume scanned(const Eigen::Matrix4d& grid, const Eigen::Vector3i& dims, const Shape& shape) {
  std::vector<std::int16_t> hu;
  const Eigen::Affine3d place(grid);
  for (int k = 0; k < dims.z(); ++k) {
    for (int j = 0; j < dims.y(); ++j) {
      for (int i = 0; i < dims.x(); ++i) {
        hu.push_back(
            static_cast<std::int16_t>(std::lround(shape(place * Eigen::Vector3d(i, j, k)))));
      }
    }
  }
  return CtVolume(dims, std::move(hu), grid, "synthetic");
}

Eigen::Matrix4d grid_of(const Eigen::Vector3d& steps, const Eigen::Vector3d& origin) {
  Eigen::Affine3d place = Eigen::Translation3d(origin) * Eigen::Scaling(steps);
  return place.matrix();
}

/// Blurred as a scanner does: a ramp of 2 mm between `outer` and `inner` HU around distance 0,
/// negative distance inside. The half-way level is the true surface.
double edge(double distance, double inner, double outer) {
  return outer + (inner - outer) * std::clamp(0.5 - distance / 2, 0.0, 1.0);
}

double ball(const Eigen::Vector3d& p, const Eigen::Vector3d& centre, double radius) {
  return (p - centre).norm() - radius;
}

void expect_closed(const TriangleMesh& mesh) {
  for (const Edge& e : edges_of(mesh)) ASSERT_GE(e.right, 0);
  EXPECT_GT(surface_area(mesh), 0);
  const Points normals = triangle_normals(mesh);
  EXPECT_GT(normals.rowwise().norm().minCoeff(), 0.5) << "a triangle without area";
}

int component_count(const TriangleMesh& mesh) {
  const std::vector<int> component = triangle_components(mesh);
  return *std::max_element(component.begin(), component.end()) + 1;
}

Eigen::Vector3d centre_of(const TriangleMesh& mesh) {
  return mesh.vertices.colwise().mean().transpose();
}

double distance_to(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  return std::sqrt((mesh.vertices.rowwise() - p.transpose()).rowwise().squaredNorm().minCoeff());
}

double smallest_angle(const TriangleMesh& mesh) {
  double smallest = 180;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(t, k));
      const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(t, (k + 1) % 3));
      const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(t, (k + 2) % 3));
      const double cosine = (b - a).normalized().dot((c - a).normalized());
      smallest = std::min(smallest, std::acos(cosine) * 180 / std::numbers::pi);
    }
  }
  return smallest;
}

constexpr double ball_volume(double r) {
  return 4.0 / 3 * std::numbers::pi * r * r * r;
}

BoneSurfaceOptions bare_bone() {
  BoneSurfaceOptions options;
  options.hu = 0;
  options.remove_support = false;
  return options;
}

class BoneGrid : public testing::TestWithParam<int> {};

TEST_P(BoneGrid, BallIsWhereItIsClosedAndOutward) {
  Eigen::Affine3d turned = Eigen::Translation3d(30, -60, 10) *
                           Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, -1).normalized()) *
                           Eigen::Scaling(0.9, 1.1, 1.6);
  if (GetParam() == 1) turned.linear().col(0) *= -1;                            // a mirrored grid
  if (GetParam() == 2) turned.linear().col(2) += turned.linear().col(1) * 0.4;  // a tilted gantry
  const Eigen::Vector3d centre = turned * Eigen::Vector3d(25, 22, 14);
  const CtVolume volume = scanned(turned.matrix(), {50, 45, 30}, [&](const auto& p) {
    // Linear for more than a voxel on both sides: interpolation errs by step²/(8 radius) only.
    return std::clamp(-300 * ball(p, centre, 15), -1000.0, 1000.0);
  });
  Progress progress;
  const TriangleMesh bone = bone_surface(volume, bare_bone(), progress);
  expect_closed(bone);
  EXPECT_NEAR(signed_volume(bone), ball_volume(15), 0.01 * ball_volume(15));
  EXPECT_LT((centre_of(bone) - centre).norm(), 0.5);
  for (Eigen::Index v = 0; v < bone.vertices.rows(); ++v) {
    ASSERT_NEAR((bone.vertices.row(v).transpose() - centre).norm(), 15, 0.03);
  }
}

INSTANTIATE_TEST_SUITE_P(Grids, BoneGrid, testing::Values(0, 1, 2));

const Eigen::Matrix4d unit_grid = grid_of({1, 1, 1}, {-40, -30, 0});

TEST(BoneSurface, DropsSpecksFillsHollowsKeepsPieces) {
  const Eigen::Vector3d left(-20, 0, 30), right(15, 0, 30), speck(-5, 20, 50);
  const CtVolume volume = scanned(unit_grid, {80, 60, 60}, [&](const Eigen::Vector3d& p) {
    const double shell = std::max(ball(p, left, 14), -ball(p, left, 7));  // hollow, with an island
    const double bone = std::min({shell, ball(p, left, 3), ball(p, right, 12), ball(p, speck, 3)});
    return edge(bone, 1000, -1000);
  });
  BoneSurfaceOptions options = bare_bone();
  options.minimum_component_volume = 1000;
  Progress progress;
  const TriangleMesh bone = bone_surface(volume, options, progress);
  expect_closed(bone);
  EXPECT_EQ(component_count(bone), 2);
  const double expected = ball_volume(14) + ball_volume(12);
  EXPECT_NEAR(signed_volume(bone), expected, 0.01 * expected);
  options.minimum_component_volume = 50;
  const TriangleMesh with_speck = bone_surface(volume, options, progress);
  EXPECT_EQ(component_count(with_speck), 3) << "the island lies in a hollow that is filled";
}

TEST(BoneSurface, ClosesWhereTheVolumeEnds) {
  const CtVolume volume = scanned(unit_grid, {80, 60, 60}, [&](const Eigen::Vector3d& p) {
    return edge(std::hypot(p.x(), p.y()) - 10, 1000, -1000);
  });
  Progress progress;
  const TriangleMesh bone = bone_surface(volume, bare_bone(), progress);
  expect_closed(bone);
  EXPECT_NEAR(signed_volume(bone), 60 * std::numbers::pi * 100, 0.02 * 60 * std::numbers::pi * 100);
}

TEST(BoneSurface, AWholeVoxelOnTheLevelMakesNoEmptyTriangle) {
  const CtVolume volume = scanned(unit_grid, {80, 60, 60}, [](const Eigen::Vector3d& p) {
    const Eigen::Vector3d d = (p - Eigen::Vector3d(0, 0, 30)).cwiseAbs();
    return d.maxCoeff() < 12 ? 1000.0 : d.maxCoeff() == 12 ? 250.0 : -1000.0;
  });
  BoneSurfaceOptions options;
  options.remove_support = false;
  Progress progress;
  const TriangleMesh bone = bone_surface(volume, options, progress);
  expect_closed(bone);
  EXPECT_GT(bone.vertices.col(0).maxCoeff(), 12) << "a voxel on the level is inside";
}

TEST(BoneSurface, CropsToABox) {
  const CtVolume volume = scanned(unit_grid, {80, 60, 60}, [](const Eigen::Vector3d& p) {
    return edge(std::min(ball(p, {-20, 0, 30}, 12), ball(p, {20, 0, 30}, 12)), 1000, -1000);
  });
  BoneSurfaceOptions options = bare_bone();
  options.crop = LpsBox{{2, -20, 10}, {36, 20, 50}};
  Progress progress;
  const TriangleMesh bone = bone_surface(volume, options, progress);
  EXPECT_EQ(component_count(bone), 1);
  EXPECT_LT((centre_of(bone) - Eigen::Vector3d(20, 0, 30)).norm(), 0.3);
  options.crop = LpsBox{{200, -20, 10}, {236, 20, 50}};
  expect_error(ErrorKind::input, {"crop box"}, [&] { bone_surface(volume, options, progress); });
}

TEST(Surfaces, NothingAtTheLevelIsAnError) {
  const CtVolume air =
      scanned(unit_grid, {80, 60, 60}, [](const Eigen::Vector3d&) { return -1000.0; });
  Progress progress;
  expect_error(ErrorKind::anatomy, {"no bone at 250 HU"}, [&] { bone_surface(air, {}, progress); });
  expect_error(ErrorKind::anatomy, {"no skin at -300 HU"},
               [&] { skin_surface(air, {}, progress); });
  SkinSurfaceOptions options;
  options.edge_mm = 0.01;
  expect_error(ErrorKind::usage, {"0.5 to 10"}, [&] { skin_surface(air, options, progress); });
}

/// A head of 45 mm radius with a skull, an airway that opens through a nostril, an ear on its left,
/// a tube beside it, on a couch as wide as the volume.
double small_head(const Eigen::Vector3d& p, bool with_couch) {
  const Eigen::Vector3d centre(0, 0, 60);
  const double cavity = ball(p, {0, -10, 55}, 15);
  const double nostril = std::max(std::hypot(p.x(), p.z() - 55) - 2.5, p.y() + 20);
  const double head = std::max({ball(p, centre, 45), -cavity, -nostril});
  const Eigen::Vector3d ear =
      (p - Eigen::Vector3d(50, 0, 60)).cwiseQuotient(Eigen::Vector3d(8, 2.5, 12));
  const double tube = std::hypot(p.y() + 10, p.z() - 20) - 3;
  const double tissue = std::min({head, 2.5 * (ear.norm() - 1), tube});
  double hu = edge(tissue, 40, -1000);
  const double skull = std::max(ball(p, centre, 38), -ball(p, centre, 32));
  if (skull < 1 && tissue < 0) hu = std::max(hu, edge(skull, 1200, 40));
  if (with_couch) hu = std::max(hu, edge(std::abs(p.y() - 58) - 13.5, 150, -1000));
  return hu;
}

const Eigen::Matrix4d head_grid = grid_of({1.5, 1.5, 2}, {-97.5, -66, 0});
const Eigen::Vector3i head_dims(131, 100, 61);

TEST(SkinSurface, TakesTheHeadFromTheCouchFillsItAndKeepsTheEar) {
  const CtVolume volume =
      scanned(head_grid, head_dims, [](const Eigen::Vector3d& p) { return small_head(p, true); });
  Progress progress;
  const TriangleMesh skin = skin_surface(volume, {}, progress);
  expect_closed(skin);
  EXPECT_EQ(component_count(skin), 1);
  EXPECT_NEAR(signed_volume(skin), ball_volume(45), 0.04 * ball_volume(45));
  EXPECT_NEAR(mean_edge_length(skin), 2.0, 0.1);
  EXPECT_GT(smallest_angle(skin), 5);
  EXPECT_NEAR(skin.vertices.col(0).maxCoeff(), 58, 2) << "the ear is on the patient's left";
  EXPECT_NEAR(skin.vertices.col(0).minCoeff(), -45, 1) << "no ear, no tube on the right";
  EXPECT_LT(skin.vertices.col(1).maxCoeff(), 45);
  EXPECT_NEAR(skin.vertices.col(1).minCoeff(), -45, 1);
  EXPECT_NEAR(distance_to(skin, {0, -45, 55}), 0, 3) << "the nostril is closed";
}

TEST(SkinSurface, WithoutSupportToRemoveTheLargestBodyStays) {
  const CtVolume volume = scanned(head_grid, head_dims, [](const Eigen::Vector3d& p) {
    return edge(ball(p, {0, 0, 60}, 40), 40, -640);
  });
  SkinSurfaceOptions options;
  options.remove_support = false;
  options.edge_mm = 3;
  Progress progress;
  const TriangleMesh skin = skin_surface(volume, options, progress);
  expect_closed(skin);
  EXPECT_NEAR(mean_edge_length(skin), 3, 0.15);
  for (Eigen::Index v = 0; v < skin.vertices.rows(); ++v) {
    ASSERT_NEAR((skin.vertices.row(v).transpose() - Eigen::Vector3d(0, 0, 60)).norm(), 40, 0.3);
  }
}

TEST(BoneSurface, LeavesTheCouchOut) {
  const CtVolume volume = scanned(head_grid, head_dims, [](const Eigen::Vector3d& p) {
    return small_head(p, true) + (std::abs(p.y() - 58) < 10 ? 300 : 0);  // as dense as bone
  });
  Progress progress;
  const TriangleMesh bone = bone_surface(volume, {}, progress);
  EXPECT_LT(bone.vertices.col(1).maxCoeff(), 45);
  BoneSurfaceOptions with_couch;
  with_couch.remove_support = false;
  EXPECT_GT(bone_surface(volume, with_couch, progress).vertices.col(1).maxCoeff(), 60);
}

// --- the real CT (see SOURCE.md there) ----------------------------------------------------------

struct Seconds {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double operator()() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

class RealCt : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = head_ct_folder();
    if (folder_.empty()) GTEST_SKIP() << "no real CT at " << GNATHION_SHARED_DATA;
  }
  std::filesystem::path folder_;
  Progress progress_;
};

TEST_F(RealCt, DicomAndItsMetaImageAgreeVoxelByVoxel) {
  const CtVolume dicom = read_ct(folder_, std::nullopt, progress_);
  EXPECT_EQ(dicom.dims(), Eigen::Vector3i(512, 512, 135));
  EXPECT_TRUE(progress_.notices().empty());
  const CtVolume crop = read_ct(
      std::filesystem::path(GNATHION_SHARED_DATA) / "ct-head-phantom" / "phantom_head_crop_HU.mha",
      std::nullopt, progress_);
  const Eigen::Vector3d at = dicom.ijk(crop.lps(Eigen::Vector3d::Zero()));
  const Eigen::Vector3i shift = at.array().round().cast<int>();
  EXPECT_LT((at - shift.cast<double>()).norm(), 1e-3);
  for (int k = 0; k < crop.dims().z(); ++k) {
    for (int j = 0; j < crop.dims().y(); ++j) {
      for (int i = 0; i < crop.dims().x(); ++i) {
        ASSERT_EQ(crop.at(i, j, k), dicom.at(i + shift.x(), j + shift.y(), k + shift.z()));
      }
    }
  }
}

/// Distances from the skin's vertices, along their normals, to the scan's own level surface; those
/// without a crossing within 5 mm (filled openings, the cut through the neck) are left out.
std::vector<double> deviations(const CtVolume& volume, const TriangleMesh& skin, double level) {
  std::vector<double> found;
  const Points normals = vertex_normals(skin);
  for (Eigen::Index v = 0; v < skin.vertices.rows(); ++v) {
    const Eigen::Vector3d p = skin.vertices.row(v), n = normals.row(v);
    double best = std::numeric_limits<double>::infinity();
    double before = volume.sample(p - 5 * n) - level;
    for (double s = -4.9; s < 5; s += 0.1) {
      const double here = volume.sample(p + s * n) - level;
      if ((here < 0) != (before < 0)) {
        best = std::min(best, std::abs(s - 0.1 * here / (here - before)));
      }
      before = here;
    }
    if (std::isfinite(best)) found.push_back(best);
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST_F(RealCt, SkinAndBoneAreTheHeadWithoutTheCouch) {
  const Seconds reading;
  const CtVolume volume = read_ct(folder_, std::nullopt, progress_);
  const double read_seconds = reading();
  const Seconds boning;
  const TriangleMesh bone = bone_surface(volume, {}, progress_);
  const double bone_seconds = boning();
  const Seconds skinning;
  const TriangleMesh skin = skin_surface(volume, {}, progress_);
  const double skin_seconds = skinning();
  std::cout << "real CT: read " << read_seconds << " s, bone " << bone_seconds << " s ("
            << bone.triangles.rows() << " triangles), skin " << skin_seconds << " s ("
            << skin.triangles.rows() << " triangles)\n";
#ifndef __SANITIZE_ADDRESS__
  EXPECT_LT(read_seconds + bone_seconds + skin_seconds, 7);
#endif

  expect_closed(bone);
  expect_closed(skin);
  EXPECT_EQ(component_count(skin), 1);
  EXPECT_NEAR(static_cast<double>(bone.triangles.rows()), 545e3, 0.05 * 545e3);
  for (const TriangleMesh* mesh : {&bone, &skin}) {  // the couch begins at y = -105
    EXPECT_LT(mesh->vertices.col(1).maxCoeff(), -102);
    EXPECT_GT(mesh->vertices.col(0).minCoeff(), -95);
    EXPECT_LT(mesh->vertices.col(0).maxCoeff(), 100);
  }
  EXPECT_NEAR(mean_edge_length(skin), 2.0, 0.1);
  EXPECT_GT(smallest_angle(skin), 10);

  const std::vector<double> deviation = deviations(volume, skin, -300);
  double mean = 0;
  for (const double d : deviation) mean += d / static_cast<double>(deviation.size());
  const double p95 = deviation[deviation.size() * 95 / 100];
  std::cout << "skin against the scan's level surface: mean " << mean << ", 95 % " << p95
            << ", max " << deviation.back() << " mm; " << skin.vertices.rows() - deviation.size()
            << " of " << skin.vertices.rows() << " vertices on filled openings\n";
  EXPECT_LT(mean, 0.1);
  EXPECT_LT(p95, 0.4);
}

TEST_F(RealCt, TheSkinPassesThroughTheLandmarks) {
  const CtVolume volume = read_ct(folder_, std::nullopt, progress_);
  const TriangleMesh skin = skin_surface(volume, {}, progress_);
  const std::vector<Eigen::Vector3d> landmarks = {
      {2.5, -324.8, 410.5}, {2.5, -309.1, 394}, {-27.5, -297.1, 369}, {29.0, -300.8, 369},
      {2.5, -304.1, 345},   {2.5, -296.6, 325}, {2.5, -296.8, 455}};
  for (const Eigen::Vector3d& landmark : landmarks) {
    EXPECT_LT(distance_to(skin, landmark), 2.0) << landmark.transpose();
  }
}

}  // namespace
}  // namespace gnathion::test
