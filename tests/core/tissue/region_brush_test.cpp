#include "tissue/region_brush.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/bsp_tree.h"
#include "support/face_patch.h"
#include "support/solids.h"

namespace gnathion {
namespace {

/// The point of the surface straight before `target`, seen from `eye`.
SurfacePoint seen(const TriangleMesh& mesh, const Eigen::Vector3d& eye,
                  const Eigen::Vector3d& target) {
  const auto hit = BspTree(mesh).first_hit(eye, (target - eye).normalized(), 1e4);
  EXPECT_TRUE(hit.has_value());
  return {hit->triangle, hit->barycentric};
}

/// Two flat lips, one above the other with a gap of 1 mm, joined 30 mm behind their edge.
TriangleMesh lips() {
  TriangleMesh mesh = testing::flat_disk(40 * 61, 198, 1);  // about 40 × 61 mm
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    const double along = mesh.vertices(v, 1);
    const double half = mesh.vertices.col(1).maxCoeff() / 2;
    mesh.vertices.row(v) =
        Eigen::RowVector3d(mesh.vertices(v, 0), std::abs(along - half), along < half ? -0.5 : 0.5);
  }
  return mesh;
}

TEST(SurfaceBrush, DistancesOnFlatSkinAreExact) {
  TriangleMesh mesh = testing::hard_patch(3, 5);
  mesh.vertices.col(2).setZero();  // an uneven mesh in the plane
  const Eigen::Vector3d middle = mesh.vertices.colwise().mean().transpose();
  const SurfaceBrush brush(mesh);
  const SurfacePoint centre = seen(mesh, middle + Eigen::Vector3d(0.3, 0.2, 50), middle);
  const Eigen::Vector3d x = centre.position(brush.face().triangles, brush.face().vertices);
  const double radius = 15;
  std::map<int, double> reached;
  for (const ReachedVertex& r : brush.disc(centre, radius)) reached[r.vertex] = r.distance;
  double worst = 0;
  int missed = 0;
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    const double straight = (mesh.vertices.row(v).transpose() - x).norm();
    if (reached.contains(v)) {
      EXPECT_GE(reached[v], straight - 1e-9);
      worst = std::max(worst, reached[v] / std::max(straight, 1.0) - 1);
    } else if (straight < radius) {
      ++missed;
      EXPECT_GT(straight, 0.97 * radius);
    }
  }
  EXPECT_GT(reached.size(), 100U);
  EXPECT_LT(worst, 0.03);
  EXPECT_LT(missed, 5);
}

TEST(SurfaceBrush, DistancesOnABallAreArcs) {
  const double R = 80;
  const TriangleMesh ball = test::sphere({0, 0, 0}, R, 5);
  const SurfaceBrush brush(ball);
  const SurfacePoint centre = seen(ball, {200, 30, 10}, {0, 0, 0});
  const Eigen::Vector3d x =
      centre.position(brush.face().triangles, brush.face().vertices).normalized();
  double worst = 0;
  const auto disc = brush.disc(centre, 40);
  for (const ReachedVertex& r : disc) {
    const Eigen::Vector3d y = ball.vertices.row(r.vertex).normalized();
    const double arc = R * std::acos(std::clamp(x.dot(y), -1.0, 1.0));
    worst = std::max(worst, std::abs(r.distance - arc));
  }
  EXPECT_LT(worst, 0.4) << "mm, at 40 mm";
}

TEST(SurfaceBrush, DoesNotJumpFromLipToLip) {
  const TriangleMesh mesh = lips();
  const SurfaceBrush brush(mesh);
  const SurfacePoint centre = seen(mesh, {20, 20, 40}, {20, 20, 0});
  const auto disc = brush.disc(centre, 10);
  EXPECT_GT(disc.size(), 200U);
  for (const ReachedVertex& r : disc) EXPECT_GT(mesh.vertices(r.vertex, 2), 0);
  // Farther than the way round the fold it reaches the other lip, too.
  const auto wide = brush.disc(centre, 25);
  EXPECT_TRUE(std::any_of(wide.begin(), wide.end(),
                          [&](const ReachedVertex& r) { return mesh.vertices(r.vertex, 2) < 0; }));
}

TEST(SurfaceBrush, SmallestBrushTakesTheNearestCorner) {
  const TriangleMesh mesh = testing::flat_disk(400, 76, 2);
  const SurfaceBrush brush(mesh);
  SurfacePoint centre{100, {0.6, 0.3, 0.1}};
  const auto disc = brush.disc(centre, 0.01);
  ASSERT_EQ(disc.size(), 1U);
  EXPECT_EQ(disc[0].vertex, mesh.triangles(100, 0));
  EXPECT_TRUE(brush.circle(centre, 0.01).empty());
}

TEST(SurfaceBrush, CircleIsWhereTheRadiusIs) {
  const TriangleMesh mesh = testing::flat_disk(2500, 198, 1);
  const SurfaceBrush brush(mesh);
  const Eigen::Vector3d middle = mesh.vertices.colwise().mean().transpose();
  const SurfacePoint centre = seen(mesh, middle + Eigen::Vector3d(0, 0, 9), middle);
  const double radius = 10;
  double length = 0;
  for (const auto& ends : brush.circle(centre, radius)) {
    std::array<Eigen::RowVector3d, 2> at;
    for (std::size_t i = 0; i < 2; ++i) {
      at[i] = (1 - ends[i].share) * mesh.vertices.row(ends[i].a) +
              ends[i].share * mesh.vertices.row(ends[i].b);
      EXPECT_NEAR(
          (at[i].transpose() - centre.position(brush.face().triangles, brush.face().vertices))
              .norm(),
          radius, 0.15);
    }
    length += (at[0] - at[1]).norm();
  }
  EXPECT_NEAR(length, 2 * std::numbers::pi * radius, 1.5);
}

TEST(SurfaceBrush, AskedTwiceItAnswersTheSame) {
  const TriangleMesh mesh = testing::hard_patch(0, 1);
  const SurfaceBrush brush(mesh);
  const auto first = brush.disc({300, {0.2, 0.3, 0.5}}, 9);
  brush.circle({10, {0.2, 0.3, 0.5}}, 20);
  brush.front({1, 2, 3}, 5, std::vector<bool>(676, true));
  const auto second = brush.disc({300, {0.2, 0.3, 0.5}}, 9);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].vertex, second[i].vertex);
    EXPECT_EQ(first[i].distance, second[i].distance);
  }
}

TEST(SurfaceBrush, FrontOfALineRunsStraight) {
  const TriangleMesh mesh = testing::flat_disk(2500, 198, 1);
  const SurfaceBrush brush(mesh);
  std::vector<int> line;
  for (int v = 0; v < mesh.vertices.rows(); ++v) {
    if (mesh.vertices(v, 1) == 0) line.push_back(v);
  }
  ASSERT_GT(line.size(), 30U);
  const std::vector<bool> all(2500, true);
  for (const ReachedVertex& r : brush.front(line, 20, all)) {
    EXPECT_NEAR(r.distance, mesh.vertices(r.vertex, 1), 0.05);
  }
}

TEST(SurfaceBrush, FrontKeepsWithinTheGivenVertices) {
  const TriangleMesh mesh = testing::flat_disk(400, 76, 2);
  const SurfaceBrush brush(mesh);
  std::vector<bool> within(400, false);
  for (int v = 0; v < 400; ++v) within[v] = mesh.vertices(v, 0) < 10;
  for (const ReachedVertex& r : brush.front({0}, 1e3, within)) {
    EXPECT_LT(mesh.vertices(r.vertex, 0), 10);
  }
}

TEST(SurfaceBrush, KnowsTheTrianglesAcrossItsEdges) {
  const TriangleMesh mesh = testing::flat_disk(400, 76, 2);
  const SurfaceBrush brush(mesh);
  int border = 0;
  for (std::size_t side = 0; side < brush.across().size(); ++side) {
    const int other = brush.across()[side];
    border += other == -1;
    if (other == -1) continue;
    int shared = 0;
    for (const int v : mesh.triangles.row(static_cast<Eigen::Index>(side / 3))) {
      for (const int w : mesh.triangles.row(other)) shared += v == w;
    }
    EXPECT_EQ(shared, 2);
  }
  EXPECT_EQ(border, 76);
}

}  // namespace
}  // namespace gnathion
