#include "geometry/bsp_tree.h"

#include <gtest/gtest.h>

#include <random>

#include "geometry/triangle_mesh.h"

namespace gnathion {
namespace {

TriangleMesh random_soup(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967295.0; };
  TriangleMesh mesh{Points(3 * count, 3), Triangles(count, 3)};
  for (int f = 0; f < count; ++f) {
    const Eigen::RowVector3d at(20 * uniform(), 20 * uniform(), 20 * uniform());
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.row(3 * f + k) = at + 3 * Eigen::RowVector3d(uniform(), uniform(), uniform());
    }
    mesh.triangles.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
  }
  return mesh;
}

/// Nearest hit by asking each triangle in a tree of its own.
std::optional<RayHit> brute_force(const TriangleMesh& mesh, const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction, double reach) {
  std::optional<RayHit> best;
  for (int f = 0; f < mesh.triangles.rows(); ++f) {
    Eigen::Matrix3d A;
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(f, 0));
    A << mesh.vertices.row(mesh.triangles(f, 1)).transpose() - a,
        mesh.vertices.row(mesh.triangles(f, 2)).transpose() - a, -direction;
    const Eigen::Vector3d uvt = A.fullPivLu().solve(origin - a);
    if (uvt[0] < 0 || uvt[1] < 0 || uvt[0] + uvt[1] > 1 || uvt[2] < 0 || uvt[2] > reach) continue;
    if (!best || uvt[2] < best->distance) best = RayHit{f, uvt[2], {}};
  }
  return best;
}

TEST(BspTree, HitsAreThoseOfBruteForce) {
  const TriangleMesh mesh = random_soup(400, 1);
  const BspTree tree(mesh);
  std::mt19937 random(2);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967295.0; };
  int hits = 0;
  for (int ray = 0; ray < 2000; ++ray) {
    const Eigen::Vector3d origin(20 * uniform(), 20 * uniform(), 20 * uniform());
    const Eigen::Vector3d direction =
        Eigen::Vector3d(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5).normalized();
    const auto expected = brute_force(mesh, origin, direction, 15);
    const auto found = tree.first_hit(origin, direction, 15);
    ASSERT_EQ(found.has_value(), expected.has_value()) << "ray " << ray;
    if (!found) continue;
    ++hits;
    EXPECT_EQ(found->triangle, expected->triangle);
    EXPECT_NEAR(found->distance, expected->distance, 1e-9);
    const Eigen::Vector3d at =
        mesh.vertices(mesh.triangles.row(found->triangle), Eigen::all).transpose() *
        found->barycentric;
    EXPECT_NEAR((at - (origin + found->distance * direction)).norm(), 0, 1e-9);
  }
  EXPECT_GT(hits, 200);
}

TEST(BspTree, NoRayAimedAtAVertexOrAnEdgeIsLost) {
  // A fine, bent grid; rays straight down at every vertex and every edge's middle.
  const int n = 60;
  TriangleMesh mesh{Points(n * n, 3), Triangles(2 * (n - 1) * (n - 1), 3)};
  for (int i = 0; i < n * n; ++i) {
    const double x = 0.7 * (i % n), y = 0.9 * (i / n);
    mesh.vertices.row(i) << x, y, std::sin(x / 3) + std::cos(y / 4);
  }
  Eigen::Index f = 0;
  for (int r = 0; r + 1 < n; ++r) {
    for (int c = 0; c + 1 < n; ++c) {
      const int v = r * n + c;
      mesh.triangles.row(f++) << v, v + 1, v + n + 1;
      mesh.triangles.row(f++) << v, v + n + 1, v + n;
    }
  }
  const BspTree tree(mesh);
  int lost = 0, rays = 0;
  const auto ask = [&](const Eigen::RowVector3d& at) {
    ++rays;
    const Eigen::Vector3d origin = at.transpose() + Eigen::Vector3d(0, 0, 10);
    lost += !tree.first_hit(origin, -Eigen::Vector3d::UnitZ(), 20).has_value();
  };
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) ask(mesh.vertices.row(i));
  for (const Edge& edge : edges_of(mesh)) {
    ask((mesh.vertices.row(edge.a) + mesh.vertices.row(edge.b)) / 2);
  }
  EXPECT_EQ(lost, 0) << "of " << rays;
}

TEST(BspTree, NearestPointIsThatOfBruteForce) {
  const TriangleMesh mesh = random_soup(300, 3);
  const BspTree tree(mesh);
  std::mt19937 random(4);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967295.0; };
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d p(20 * uniform(), 20 * uniform(), 20 * uniform());
    double least = 1e9;
    for (int f = 0; f < mesh.triangles.rows(); ++f) {
      TriangleMesh one{mesh.vertices, mesh.triangles.row(f)};
      least = std::min(least, BspTree(one).nearest(p, 100)->distance);
    }
    const auto found = tree.nearest(p, 100);
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->distance, least);
    EXPECT_NEAR((found->point - p).norm(), least, 1e-12);
    EXPECT_FALSE(tree.nearest(p, least * 0.99));
  }
}

TEST(BspTree, ATriangleWithoutAreaHidesNoOther) {
  TriangleMesh mesh{Points(6, 3), Triangles(2, 3)};
  mesh.vertices << 0, 0, 0, 0, 0, 0, 1, 0, 0, /* the other: */ 5, -1, -1, 5, 1, -1, 5, 0, 1;
  mesh.triangles << 0, 1, 2, 3, 4, 5;
  const BspTree tree(mesh);
  const auto beside = tree.nearest({0.5, 0.1, 0}, 10);
  ASSERT_TRUE(beside);
  EXPECT_NEAR(beside->distance, 0.1, 1e-12);
  const auto far = tree.nearest({4.9, 0, 0}, 10);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->triangle, 1);
  EXPECT_NEAR(far->distance, 0.1, 1e-12);
  EXPECT_EQ(tree.first_hit({-1, 0, 0}, {1, 0, 0}, 10)->triangle, 1);
}

TEST(BspTree, AnEmptySurfaceIsNeverHit) {
  const BspTree tree(TriangleMesh{});
  EXPECT_FALSE(tree.first_hit({0, 0, 0}, {0, 0, 1}, 100));
  EXPECT_FALSE(tree.nearest({0, 0, 0}, 100));
}

}  // namespace
}  // namespace gnathion
