#include "tissue/intermediate_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/face_patch.h"
#include "support/solids.h"

namespace gnathion {
namespace {

using test::expect_error;

int rim_loops(const IntermediateMesh& region) {
  std::vector<int> next(region.rim.size(), -1);
  int loops = 0;
  for (const Edge& edge : region.edges) {
    if (edge.right == -1) next[edge.a] = edge.b;
  }
  for (std::size_t v = 0; v < next.size(); ++v) {
    if (next[v] == -1) continue;
    ++loops;
    for (int at = static_cast<int>(v); next[at] != -1;) at = std::exchange(next[at], -1);
  }
  return loops;
}

/// What every region promises: one piece, a rim, and vertices that are the face's own.
void expect_sound(const IntermediateMesh& region, const TriangleMesh& face) {
  ASSERT_EQ(region.face_vertex.size(), static_cast<std::size_t>(region.mesh.vertices.rows()));
  for (Eigen::Index v = 0; v < region.mesh.vertices.rows(); ++v) {
    ASSERT_EQ(region.mesh.vertices.row(v), face.vertices.row(region.face_vertex[v]));
  }
  const std::vector<int> pieces = triangle_components(region.mesh);
  EXPECT_EQ(*std::max_element(pieces.begin(), pieces.end()), 0);
  EXPECT_EQ(region.rim, rim_vertices(region.mesh, region.edges));
  EXPECT_GE(rim_loops(region), 1);
}

TEST(SuggestRegion, TakesTheFaceWithinReachOfTheSegment) {
  const TriangleMesh face = testing::flat_disk(2000, 180, 2);
  const Eigen::RowVector3d middle = face.vertices.colwise().mean();
  const TriangleMesh segment = test::sphere(middle.transpose() + Eigen::Vector3d(0, 0, -15), 5, 3);
  const double reach = 18;
  const IntermediateMesh region = suggest_region(face, BspTree(segment), reach);
  expect_sound(region, face);
  EXPECT_EQ(rim_loops(region), 1);
  // On the plane, 15 mm above the ball's centre, reach means a circle around the middle.
  const double radius = std::sqrt(std::pow(reach + 5, 2) - 15 * 15);
  double rim_min = 1e9;
  for (Eigen::Index v = 0; v < region.mesh.vertices.rows(); ++v) {
    const double r = (region.mesh.vertices.row(v) - middle).norm();
    EXPECT_LT(r, radius + 0.1);
    if (region.rim[v]) rim_min = std::min(rim_min, r);
  }
  EXPECT_GT(rim_min, radius - 2 * 2.9) << "the region is smaller than the reach";
}

TEST(SuggestRegion, KeepsTheLargestOfSeveralPieces) {
  // Two sheets, the smaller one on the other side of the segment.
  const TriangleMesh near = testing::flat_disk(900, 120, 2);
  TriangleMesh far = testing::flat_disk(100, 36, 2);
  const Eigen::RowVector3d middle = near.vertices.colwise().mean();
  far.vertices.rowwise() += middle - far.vertices.colwise().mean() + Eigen::RowVector3d(0, 0, -30);
  const TriangleMesh face = test::joined(far, near);
  const TriangleMesh segment = test::sphere(middle.transpose() + Eigen::Vector3d(0, 0, -15), 5, 3);
  const IntermediateMesh region = suggest_region(face, BspTree(segment), 18);
  expect_sound(region, face);
  EXPECT_GE(*std::min_element(region.face_vertex.begin(), region.face_vertex.end()), 100);
}

TEST(SuggestRegion, CleansTrianglesThatHangOnByACorner) {
  const TriangleMesh face = testing::hard_patch(3, 1);
  const Eigen::RowVector3d middle = face.vertices.colwise().mean();
  const TriangleMesh segment = test::sphere(middle.transpose() + Eigen::Vector3d(0, 0, -12), 4, 3);
  const IntermediateMesh region = suggest_region(face, BspTree(segment), 16);
  expect_sound(region, face);
  std::vector<int> rim_edges_of_triangle(static_cast<std::size_t>(region.mesh.triangles.rows()));
  std::vector<int> rim_edges_of_vertex(region.rim.size());
  for (const Edge& edge : region.edges) {
    if (edge.right != -1) continue;
    EXPECT_LE(++rim_edges_of_triangle[edge.left], 1);
    EXPECT_LE(++rim_edges_of_vertex[edge.a], 2);
    EXPECT_LE(++rim_edges_of_vertex[edge.b], 2);
  }
}

TEST(SuggestRegion, RefusesAFaceThatIsNowhereNear) {
  TriangleMesh face = testing::flat_disk(400, 76, 2);
  face.vertices *= 0.001;  // a scan in metres
  const TriangleMesh segment = test::sphere({0, 0, -50}, 5, 2);
  expect_error(ErrorKind::anatomy, {"region", "35", "transform"},
               [&] { suggest_region(face, BspTree(segment), 35); });
}

TEST(SuggestRegion, RefusesAClosedFaceThatIsWhollyWithinReach) {
  const TriangleMesh face = test::sphere({0, 0, 0}, 20, 3);
  const TriangleMesh segment = test::sphere({0, 0, 0}, 10, 2);
  expect_error(ErrorKind::anatomy, {"region", "no rim"},
               [&] { suggest_region(face, BspTree(segment), 35); });
}

class RegionOfVertices : public ::testing::Test {
 protected:
  const TriangleMesh face_ = testing::flat_disk(400, 76, 2);

  std::vector<int> within(double x, double y, double radius) const {
    std::vector<int> chosen;
    for (int v = 0; v < face_.vertices.rows(); ++v) {
      if ((face_.vertices.row(v) - Eigen::RowVector3d(x, y, 0)).norm() < radius)
        chosen.push_back(v);
    }
    return chosen;
  }
};

TEST_F(RegionOfVertices, HasTheTrianglesBetweenThem) {
  const std::vector<int> chosen = within(18, 18, 9);
  const IntermediateMesh region = region_of_vertices(face_, chosen);
  expect_sound(region, face_);
  const std::set<int> set(chosen.begin(), chosen.end());
  Eigen::Index expected = 0;
  for (Eigen::Index f = 0; f < face_.triangles.rows(); ++f) {
    expected += set.contains(face_.triangles(f, 0)) && set.contains(face_.triangles(f, 1)) &&
                set.contains(face_.triangles(f, 2));
  }
  EXPECT_EQ(region.mesh.triangles.rows(), expected);
}

TEST_F(RegionOfVertices, DoesNotDependOnTheirOrderOrRepetition) {
  std::vector<int> chosen = within(18, 18, 9);
  const IntermediateMesh first = region_of_vertices(face_, chosen);
  std::reverse(chosen.begin(), chosen.end());
  chosen.push_back(chosen.front());
  const IntermediateMesh second = region_of_vertices(face_, chosen);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
  EXPECT_EQ(first.face_vertex, second.face_vertex);
}

TEST_F(RegionOfVertices, RefusesSeveralPieces) {
  std::vector<int> chosen = within(8, 8, 6);
  const std::vector<int> other = within(30, 30, 6);
  chosen.insert(chosen.end(), other.begin(), other.end());
  expect_error(ErrorKind::anatomy, {"region", "2 pieces"},
               [&] { region_of_vertices(face_, chosen); });
}

TEST_F(RegionOfVertices, RefusesIndicesThatTheFaceDoesNotHave) {
  for (const int bad : {-1, 400, 1000000}) {
    expect_error(ErrorKind::anatomy, {"region", std::to_string(bad), "400"}, [&] {
      region_of_vertices(face_, {0, 1, bad});
    });
  }
}

TEST_F(RegionOfVertices, RefusesVerticesThatSpanNoTriangle) {
  expect_error(ErrorKind::anatomy, {"region", "no triangle"}, [&] {
    region_of_vertices(face_, {0, 57, 200});
  });
  expect_error(ErrorKind::anatomy, {"region", "no triangle"},
               [&] { region_of_vertices(face_, {}); });
}

TEST_F(RegionOfVertices, RefusesAWholeClosedSurface) {
  const TriangleMesh closed = test::sphere({0, 0, 0}, 20, 2);
  std::vector<int> all(static_cast<std::size_t>(closed.vertices.rows()));
  std::iota(all.begin(), all.end(), 0);
  expect_error(ErrorKind::anatomy, {"region", "no rim"}, [&] { region_of_vertices(closed, all); });
}

}  // namespace
}  // namespace gnathion
