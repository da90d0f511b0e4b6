#include "tissue/bone_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/face_patch.h"
#include "support/solids.h"

namespace gnathion {
namespace {

using test::box;
using test::joined;

constexpr double kEdge = 2;

/// Skin in the plane z = 0 about the origin, normals up.
IntermediateMesh skin_sheet() {
  TriangleMesh mesh = testing::flat_disk(900, 116, kEdge);
  mesh.vertices.rowwise() -= mesh.vertices.colwise().mean().eval();
  return testing::whole_region(mesh);
}

/// Bone whose upper side is 20×20 mm, `depth` mm below the skin.
TriangleMesh block(double depth, double x = 0) {
  return box({x, 0, -depth - 5}, {10, 10, 5}, 10);
}

std::vector<BoneLink> links_of(const TriangleMesh& bone, const IntermediateMesh& skin,
                               double threshold = 20) {
  return bone_map(bone, BspTree(bone), skin, BspTree(skin.mesh), threshold);
}

TEST(BoneMap, LinksRunAlongTheNormalsOfTheBone) {
  const IntermediateMesh skin = skin_sheet();
  const TriangleMesh bone = block(7);
  const Points normals = vertex_normals(bone);
  const std::vector<BoneLink> links = links_of(bone, skin);
  ASSERT_EQ(links.size(), 11U * 11) << "one for each vertex of the side that sees the skin";
  int last = -1;
  for (const BoneLink& link : links) {
    EXPECT_GT(link.bone_vertex, last) << "not in order";
    last = link.bone_vertex;
    const Eigen::RowVector3d from = bone.vertices.row(link.bone_vertex);
    Eigen::RowVector3d to = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      to += link.barycentric[k] * skin.mesh.vertices.row(skin.mesh.triangles(link.triangle, k));
    }
    EXPECT_NEAR(link.barycentric.sum(), 1, 1e-12);
    EXPECT_LT((from + link.distance * normals.row(link.bone_vertex) - to).norm(), 1e-9);
    EXPECT_NEAR(to.z(), 0, 1e-12);
    if (normals(link.bone_vertex, 2) > 1 - 1e-12) {
      EXPECT_NEAR(link.distance, 7, 1e-9);
    }
  }
}

TEST(BoneMap, TheThresholdIsTheLongestLink) {
  const IntermediateMesh skin = skin_sheet();
  EXPECT_FALSE(links_of(block(19.999), skin).empty());
  EXPECT_TRUE(links_of(block(20.001), skin).empty());
  EXPECT_TRUE(links_of(block(7), skin, 6.999).empty());
  for (const BoneLink& link : links_of(block(18), skin)) EXPECT_LE(link.distance, 20);
}

TEST(BoneMap, BoneThatHidesBoneIsInTheWay) {
  const IntermediateMesh skin = skin_sheet();
  const TriangleMesh deep = block(15);
  const TriangleMesh shield = box({0, 0, -8}, {14, 14, 1}, 14);  // from −9 to −7
  const TriangleMesh both = joined(deep, shield);
  ASSERT_FALSE(links_of(deep, skin).empty());
  const std::vector<BoneLink> links = links_of(both, skin);
  ASSERT_FALSE(links.empty());
  for (const BoneLink& link : links) {
    EXPECT_GE(link.bone_vertex, deep.vertices.rows()) << "a link passes through the shield";
    EXPECT_GT(both.vertices(link.bone_vertex, 2), -7.5);
  }
}

TEST(BoneMap, HitsFromOutsideAreDropped) {
  // The bone lies outside of the skin: its lower side looks at the skin's outer face.
  const IntermediateMesh skin = skin_sheet();
  TriangleMesh outside = block(7);
  outside.vertices.rowwise() += Eigen::RowVector3d(0, 0, 24);
  EXPECT_TRUE(links_of(outside, skin).empty());
}

TEST(BoneMap, BoneBesideTheSkinHasNoLinks) {
  EXPECT_TRUE(links_of(block(7, 60), skin_sheet()).empty());
}

class BoneBelowSheets : public ::testing::Test {
 protected:
  const IntermediateMesh skin_ = skin_sheet();
  const Points down_ = Eigen::RowVector3d(0, 0, -1).replicate(skin_.mesh.vertices.rows(), 1);
  const TriangleMesh far_away_ = block(7, 500);

  BoneBelow below(const TriangleMesh& segment, const TriangleMesh& skull,
                  const BoneBelowOptions& options = {}) const {
    return bone_below(skin_, down_, std::array{BspTree(segment)}, BspTree(skull), {}, options);
  }
  bool over(Eigen::Index v, double x) const {
    return std::abs(skin_.mesh.vertices(v, 0) - x) < 9.99 &&
           std::abs(skin_.mesh.vertices(v, 1)) < 9.99;
  }
};

TEST_F(BoneBelowSheets, DepthsAreExactOverParallelBone) {
  const BoneBelow result = below(block(6.25), far_away_);
  int found = 0;
  for (Eigen::Index v = 0; v < down_.rows(); ++v) {
    if (over(v, 0)) {
      ++found;
      EXPECT_EQ(result.bone[v], 0);
      EXPECT_NEAR(result.depth[v], 6.25, 1e-9);
    } else if (!over(v, 0) && skin_.mesh.vertices.row(v).norm() > 15) {
      EXPECT_EQ(result.bone[v], kNoBone);
    }
  }
  EXPECT_GT(found, 80);
}

TEST_F(BoneBelowSheets, DepthsPassOverToTheDefaultInManySteps) {
  BoneBelowOptions options;
  options.default_depth = 9;
  const BoneBelow result = below(block(4), far_away_, options);
  double largest = 0, total = 0;
  for (const Edge& edge : skin_.edges) {
    const double step = std::abs(result.depth[edge.a] - result.depth[edge.b]);
    largest = std::max(largest, step);
    total += step;
  }
  EXPECT_LT(largest, 0.52 * (9 - 4)) << "at the bone's corners";
  EXPECT_LT(total / static_cast<double>(skin_.edges.size()), 0.1 * (9 - 4));
  EXPECT_GE(result.depth.minCoeff(), 4 - 1e-9);
  EXPECT_LE(result.depth.maxCoeff(), 9);
  EXPECT_GT(result.depth.maxCoeff(), 6.5);
}

TEST_F(BoneBelowSheets, TheNearerOfSegmentAndSkullWins) {
  const BoneBelow segment_near = below(block(5), block(8)), skull_near = below(block(8), block(5));
  for (Eigen::Index v = 0; v < down_.rows(); ++v) {
    if (!over(v, 0)) continue;
    EXPECT_EQ(segment_near.bone[v], 0);
    EXPECT_EQ(skull_near.bone[v], Support::kUnmoved);
    EXPECT_NEAR(segment_near.depth[v], 5, 1e-9);
    EXPECT_NEAR(skull_near.depth[v], 5, 1e-9);
  }
}

TEST_F(BoneBelowSheets, EachHoldsWhatLiesAboveIt) {
  const BoneBelow result = below(block(6, -12), block(6, 12));
  int on_segment = 0, on_skull = 0;
  for (Eigen::Index v = 0; v < down_.rows(); ++v) {
    const double x = skin_.mesh.vertices(v, 0);
    on_segment += result.bone[v] == 0;
    on_skull += result.bone[v] == Support::kUnmoved;
    if (result.bone[v] != kNoBone) {
      EXPECT_EQ(result.bone[v] == 0, x < 0) << x;
    }
  }
  EXPECT_GT(on_segment, 80);
  EXPECT_GT(on_skull, 80);
}

TEST_F(BoneBelowSheets, BoneBeyondTheThresholdIsNotBelow) {
  const BoneBelow result = below(block(20.5), block(25));
  EXPECT_EQ(std::count(result.bone.begin(), result.bone.end(), kNoBone), down_.rows());
  EXPECT_EQ(result.depth.minCoeff(), 8);
  EXPECT_EQ(result.depth.maxCoeff(), 8);
}

TEST_F(BoneBelowSheets, BoneAtTheSkinDoesNotHoldIt) {
  const BoneBelow result = below(block(0.4), far_away_);
  EXPECT_EQ(std::count(result.bone.begin(), result.bone.end(), kNoBone), down_.rows());
  EXPECT_GE(result.depth.minCoeff(), 1);
}

TEST_F(BoneBelowSheets, AVertexThatALinkMeetsTakesTheLinksLengthWhereItsOwnRayMisses) {
  BoneLink link;
  link.triangle = 500;
  link.distance = 11;
  BoneLink longer = link;
  longer.distance = 13;
  const BoneBelow result = bone_below(skin_, down_, std::array{BspTree(far_away_)},
                                      BspTree(far_away_), {link, longer}, BoneBelowOptions{});
  for (const int v : skin_.mesh.triangles.row(500)) {
    EXPECT_EQ(result.bone[v], 0);
    EXPECT_NEAR(result.depth[v], 12, 1e-12);
  }
  EXPECT_EQ(std::count(result.bone.begin(), result.bone.end(), 0), 3);
}

}  // namespace
}  // namespace gnathion
