#include "geometry/section_chains.h"

#include <gtest/gtest.h>

#include "geometry/histogram.h"
#include "geometry/surface_point.h"

namespace gnathion::test {
namespace {

/// A closed box from 0 to its size.
TriangleMesh box(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.row(i) << (i & 1) * size.x(), (i >> 1 & 1) * size.y(), (i >> 2) * size.z();
  }
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
      2, 4, 6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

double length(const Points& chain) {
  return (chain.bottomRows(chain.rows() - 1) - chain.topRows(chain.rows() - 1))
      .rowwise()
      .norm()
      .sum();
}

TEST(SectionChains, OfABoxIsARectangle) {
  const auto chains = section_chains(box({4, 2, 3}), {1.5, 0, 0}, {7, 0, 0});
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_NEAR(length(chains[0]), 2 * (2 + 3), 1e-12);
  EXPECT_EQ(chains[0].row(0), chains[0].row(chains[0].rows() - 1));
  EXPECT_LT((chains[0].col(0).array() - 1.5).abs().maxCoeff(), 1e-12);
}

TEST(SectionChains, ThroughVerticesStaysClosed) {
  const auto chains = section_chains(box({2, 2, 2}), {0, 0, 0}, {1, 1, -1});
  for (const Points& chain : chains) {
    EXPECT_LT((chain.row(0) - chain.row(chain.rows() - 1)).norm(), 1e-12);
  }
}

TEST(SectionChains, OfAnOpenSurfaceIsAnOpenChain) {
  TriangleMesh open = box({4, 2, 3});
  open.triangles.conservativeResize(4, 3);  // bottom and top alone
  const auto chains = section_chains(open, {1.5, 0, 0}, {1, 0, 0});
  ASSERT_EQ(chains.size(), 2U);
  for (const Points& chain : chains) EXPECT_NEAR(length(chain), 2, 1e-12);
}

TEST(SectionChains, BesideTheSurfaceIsNothing) {
  EXPECT_TRUE(section_chains(box({1, 1, 1}), {5, 0, 0}, {1, 0, 0}).empty());
}

TEST(Histogram, CountsEveryFiniteValueOnce) {
  Eigen::VectorXd values(7);
  values << -1.2, -0.01, 0, 0.01, 3.9, std::nan(""), 2;
  const Histogram counted = histogram(values, 12);
  EXPECT_EQ(counted.total(), 6);
  EXPECT_LE(counted.counts.size(), 12U);
  EXPECT_LE(counted.low, -1.2);
  EXPECT_GT(counted.high(), 3.9);
  // Zero is a border: below it are two values.
  Eigen::Index below = 0;
  for (std::size_t i = 0; i < counted.counts.size(); ++i) {
    const double middle = counted.low + counted.width * (static_cast<double>(i) + 0.5);
    if (middle < 0) below += counted.counts[i];
  }
  EXPECT_EQ(below, 2);
}

TEST(Histogram, OfNothingIsEmptyAndOfOneValueIsNot) {
  EXPECT_TRUE(histogram(Eigen::VectorXd()).counts.empty());
  EXPECT_EQ(histogram(Eigen::VectorXd::Constant(5, 2.5)).total(), 5);
}

TEST(SurfacePoint, FollowsTheSurface) {
  const TriangleMesh at_rest = box({4, 2, 3});
  const BspTree tree(at_rest);
  const auto seen = point_in_sight(tree, {1, 1, 10}, {0, 0, -1});
  ASSERT_TRUE(seen);
  EXPECT_LT((seen->position(at_rest.triangles, at_rest.vertices) - Eigen::Vector3d(1, 1, 3)).norm(),
            1e-12);
  const Points larger = 2 * at_rest.vertices;
  EXPECT_LT((seen->position(at_rest.triangles, larger) - Eigen::Vector3d(2, 2, 6)).norm(), 1e-12);
  EXPECT_NEAR(seen->value(at_rest.triangles, at_rest.vertices.col(0)), 1, 1e-12);
  const auto nearest = nearest_surface_point(tree, at_rest, {1, 1, 3.4}, 1);
  ASSERT_TRUE(nearest);
  EXPECT_LT(
      (nearest->position(at_rest.triangles, at_rest.vertices) - Eigen::Vector3d(1, 1, 3)).norm(),
      1e-12);
  EXPECT_FALSE(nearest_surface_point(tree, at_rest, {1, 1, 8}, 1));
  EXPECT_FALSE(point_in_sight(tree, {9, 9, 10}, {0, 0, -1}));
}

}  // namespace
}  // namespace gnathion::test
