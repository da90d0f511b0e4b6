#include "tissue/bone_normals.h"

#include <gtest/gtest.h>

#include <random>

#include "support/face_patch.h"
#include "support/solids.h"

namespace gnathion {
namespace {

double degrees_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// The largest angle between the rows and a direction.
double worst(const Points& normals, const Eigen::Vector3d& truth) {
  double angle = 0;
  for (const auto& n : normals.rowwise()) angle = std::max(angle, degrees_between(n, truth));
  return angle;
}

/// A patch 20 mm wide, 0.5 mm between vertices, over the plane z = 0, raised to height(x, y).
TriangleMesh fine_patch(const std::function<double(double, double)>& height) {
  TriangleMesh mesh = testing::flat_disk(1600, 156, 0.5);
  testing::raise(mesh, height);
  return mesh;
}

/// Places 2 mm above the inner vertices of the patch, away from its rim.
Points above_middle(const TriangleMesh& mesh) {
  const Eigen::RowVector3d middle =
      (mesh.vertices.colwise().minCoeff() + mesh.vertices.colwise().maxCoeff()) / 2;
  std::vector<int> inner;
  for (int i = 0; i < mesh.vertices.rows(); ++i) {
    if ((mesh.vertices.row(i) - middle).head<2>().norm() < 5) inner.push_back(i);
  }
  Points points = mesh.vertices(inner, Eigen::all);
  points.col(2).array() += 0.05;
  return points;
}

TEST(BoneNormals, OfASphereAreRadial) {
  const TriangleMesh mesh = test::sphere({1, 2, 3}, 20, 5);
  Points directions = test::sphere({0, 0, 0}, 1, 2).vertices;
  for (const double at : {0.8, 1.0, 1.2}) {
    const Points points = (20 * at * directions).rowwise() + Eigen::RowVector3d(1, 2, 3);
    const Points normals = smooth_normals(mesh, BspTree(mesh), points);
    for (int i = 0; i < points.rows(); ++i) {
      EXPECT_LT(degrees_between(normals.row(i), directions.row(i)), 1.0);
      EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
    }
  }
}

TEST(BoneNormals, NoiseOfAPlaneIsAveraged) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.15, 0.15);
  const TriangleMesh mesh = fine_patch([&](double, double) { return noise(random); });
  const Points points = above_middle(mesh);
  const BspTree tree(mesh);
  const Eigen::Vector3d up(0, 0, 1);
  EXPECT_GT(worst(smooth_normals(mesh, tree, points, 0.01), up), 15);
  EXPECT_LT(worst(smooth_normals(mesh, tree, points), up), 3);
}

TEST(BoneNormals, StairsGetTheNormalOfTheirSlope) {
  // Steps 1 mm high on a slope of 1 in 2.
  const TriangleMesh mesh = fine_patch([](double x, double) { return std::floor(x / 2 + 0.5); });
  const Points points = above_middle(mesh);
  const BspTree tree(mesh);
  const Eigen::Vector3d slope = Eigen::Vector3d(-1, 0, 2).normalized();
  EXPECT_GT(worst(smooth_normals(mesh, tree, points, 0.01), slope), 25);
  EXPECT_LT(worst(smooth_normals(mesh, tree, points), slope), 10);
}

TEST(BoneNormals, TheFarSideOfAThinPlateDoesNotCount) {
  // Bone 0.6 mm thick: two patches back to back, 20 mm wide, not joined.
  const TriangleMesh top = fine_patch([](double, double) { return 0.6; });
  TriangleMesh bottom = fine_patch([](double, double) { return 0; });
  bottom.triangles.col(1).swap(bottom.triangles.col(2));
  const TriangleMesh plate = test::joined(top, bottom);
  Points points = above_middle(top);
  EXPECT_LT(worst(smooth_normals(plate, BspTree(plate), points), {0, 0, 1}), 1e-6);
  points.col(2).array() -= 0.8;
  EXPECT_LT(worst(smooth_normals(plate, BspTree(plate), points), {0, 0, -1}), 1e-6);
}

TEST(BoneNormals, TheEdgeOfAThinBoneKeepsItsOuterSide) {
  TriangleMesh flat = test::sphere({0, 0, 0}, 1, 6);
  flat.vertices *= Eigen::Vector3d(15, 15, 1).asDiagonal();
  Points near_edge(1, 3);
  near_edge << 13.5, 0, 1;
  const Points normal = smooth_normals(flat, BspTree(flat), near_edge);
  EXPECT_GT(normal(0, 2), 0.7);
  EXPECT_GT(normal(0, 0), 0.05);
}

TEST(BoneNormals, TrianglesLargerThanTheRadiusKeepTheirOwn) {
  TriangleMesh one{Points(3, 3), Triangles(1, 3)};
  one.vertices << 0, 0, 0, 100, 0, 0, 0, 100, 0;
  one.triangles << 0, 1, 2;
  Points points(2, 3);
  points << 1, 1, 5, 50, 0, -5;
  EXPECT_LT(worst(smooth_normals(one, BspTree(one), points), {0, 0, 1}), 1e-9);
}

}  // namespace
}  // namespace gnathion
