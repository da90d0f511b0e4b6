#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/surface_distance.h"
#include "geometry/tet_quality.h"
#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

TEST(TetQuality, OfARegularTet) {
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
  mesh.tets << 1, 0, 2, 3;
  const TetQuality q = tet_quality(mesh);
  EXPECT_NEAR(q.total_volume, 8.0 / 3, 1e-12);
  EXPECT_NEAR(q.smallest_dihedral, 70.528779, 1e-6);
  EXPECT_NEAR(q.largest_dihedral, 70.528779, 1e-6);
  EXPECT_NEAR(q.median_aspect, 1, 1e-12);
  EXPECT_EQ(q.inverted, 0);
  mesh.tets << 0, 1, 2, 3;
  EXPECT_EQ(tet_quality(mesh).inverted, 1);
}

TEST(TetQuality, OfTheCornerOfACube) {
  TetMesh mesh{Points(4, 3), Tets(1, 4)};
  mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  mesh.tets << 0, 1, 2, 3;
  const TetQuality q = tet_quality(mesh);
  EXPECT_NEAR(q.smallest_volume, 1.0 / 6, 1e-12);
  EXPECT_NEAR(q.smallest_dihedral, std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(q.largest_dihedral, 90, 1e-9);
  // Longest edge √2, shortest height 1/√3 above the slanted face, scaled by √(2/3).
  EXPECT_NEAR(q.largest_aspect, std::sqrt(2.0 / 3) * std::sqrt(2.0) * std::sqrt(3.0), 1e-12);
}

TEST(TetQuality, AnglesAndAspectsOfEachTet) {
  TetMesh mesh{Points(4, 3), Tets(2, 4)};
  mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  mesh.tets << 0, 1, 2, 3, 1, 0, 2, 3;  // the corner of a cube, and it with two corners swapped
  const double slanted = std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi;
  Eigen::Matrix<double, 2, 6> dihedral;
  dihedral << 90, 90, 90, slanted, slanted, slanted,  // edges 01, 02, 03 at the corner
      90, slanted, slanted, 90, 90, slanted;
  EXPECT_LT((dihedral_angles(mesh) - dihedral).norm(), 1e-9);
  const auto angles = face_angles(mesh);
  Eigen::Matrix<double, 1, 12> faces;
  faces << 60, 60, 60, 90, 45, 45, 90, 45, 45, 90, 45, 45;
  EXPECT_LT((angles.row(0) - faces).norm(), 1e-9);
  const Eigen::VectorXd sums = angles.rowwise().sum();
  EXPECT_NEAR(sums[1], 4 * 180, 1e-9);
  EXPECT_NEAR(aspect_ratios(mesh)[0], tet_quality(mesh).largest_aspect, 1e-12);
  EXPECT_NEAR(aspect_ratios(mesh)[1], aspect_ratios(mesh)[0], 1e-12);
}

TEST(SignedDistances, ArePositiveOutsideAndNotMeasuredOutOfReach) {
  TriangleMesh sheet{Points(4, 3), Triangles(2, 3)};
  sheet.vertices << 0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0;
  sheet.triangles << 0, 1, 2, 0, 2, 3;
  Points points(4, 3);
  points << 3, 4, 2.5, 3, 4, -1.5, 13, 14, 0, 5, 5, 60;
  const Eigen::VectorXd d = signed_distances(points, sheet, 50);
  EXPECT_NEAR(d[0], 2.5, 1e-12);
  EXPECT_NEAR(d[1], -1.5, 1e-12);
  EXPECT_NEAR(d[2], 5, 1e-12) << "beside the sheet";
  EXPECT_TRUE(std::isnan(d[3]));
}

TEST(DistanceStatistics, AreOfAbsoluteValuesWithoutTheUnmeasured) {
  Eigen::VectorXd values(12);
  values << -1, 2, -3, 4, -5, 6, -7, 8, -9, 10, -11, std::numeric_limits<double>::quiet_NaN();
  const DistanceStatistics s = distance_statistics(values);
  EXPECT_EQ(s.count, 11);
  EXPECT_DOUBLE_EQ(s.mean, 6);
  EXPECT_DOUBLE_EQ(s.p90, 10);
  EXPECT_DOUBLE_EQ(s.max, 11);
}

}  // namespace
}  // namespace gnathion
