#include "scan/scan_problems.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/triangle_mesh.h"
#include "scan/scan_repairs.h"
#include "support/solids.h"

namespace gnathion {
namespace {

ScanProblems problems_of(const TriangleMesh& surface) {
  Progress progress;
  return scan_problems(surface, progress);
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh both;
  both.vertices.resize(a.vertices.rows() + b.vertices.rows(), 3);
  both.vertices << a.vertices, b.vertices;
  both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  both.triangles << a.triangles, (b.triangles.array() + int(a.vertices.rows())).matrix();
  return both;
}

RawScan scan_of(const TriangleMesh& surface) {
  RawScan scan;
  scan.surface = surface;
  scan.corner_texture = Triangles::Constant(surface.triangles.rows(), 3, -1);
  scan.material.assign(std::size_t(surface.triangles.rows()), -1);
  return scan;
}

TriangleMesh without_triangle(TriangleMesh mesh, Eigen::Index f) {
  std::vector<bool> keep(std::size_t(mesh.triangles.rows()), true);
  keep[std::size_t(f)] = false;
  const TriangleMesh before = mesh;
  mesh.triangles.conservativeResize(mesh.triangles.rows() - 1, 3);
  for (Eigen::Index i = 0, row = 0; i < before.triangles.rows(); ++i) {
    if (keep[std::size_t(i)]) mesh.triangles.row(row++) = before.triangles.row(i);
  }
  return mesh;
}

TEST(ScanProblems, OfASphereAreNone) {
  const ScanProblems found = problems_of(test::sphere({1, 2, 3}, 80, 3));
  EXPECT_TRUE(found.duplicate_vertices.empty());
  EXPECT_TRUE(found.unreferenced_vertices.empty());
  EXPECT_TRUE(found.non_manifold_edges.empty());
  EXPECT_TRUE(found.non_manifold_vertices.empty());
  EXPECT_TRUE(found.inconsistent_edges.empty());
  EXPECT_TRUE(found.flipped_triangles.empty());
  EXPECT_TRUE(found.degenerate_triangles.empty());
  EXPECT_TRUE(found.borders.empty());
  EXPECT_EQ(found.islands.size(), 1U);
  EXPECT_TRUE(found.crossing_triangles.empty());
}

TEST(ScanProblems, NameTheHoleAndItsLength) {
  const TriangleMesh sphere = test::sphere({0, 0, 0}, 80, 2);
  const TriangleMesh mesh = without_triangle(sphere, 17);
  const ScanProblems found = problems_of(mesh);
  ASSERT_EQ(found.borders.size(), 1U);
  std::vector<int> border = found.borders[0].vertices, wanted;
  for (const int v : sphere.triangles.row(17)) wanted.push_back(v);
  double length = 0;
  for (int k = 0; k < 3; ++k) {
    length += (sphere.vertices.row(wanted[k]) - sphere.vertices.row(wanted[(k + 1) % 3])).norm();
  }
  std::sort(border.begin(), border.end());
  std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(border, wanted);
  EXPECT_NEAR(found.borders[0].length, length, 1e-9);
}

TEST(ScanProblems, NameFlippedFacesAndTheirEdges) {
  TriangleMesh mesh = test::sphere({0, 0, 0}, 80, 2);
  mesh.triangles.row(5).reverseInPlace();
  const ScanProblems found = problems_of(mesh);
  EXPECT_EQ(found.flipped_triangles, std::vector<int>{5});
  EXPECT_EQ(found.inconsistent_edges.size(), 3U);
  const RepairedScan repaired = oriented(scan_of(mesh));
  EXPECT_EQ(repaired.changed, 1U);
  EXPECT_GT(signed_volume(repaired.scan.surface), 0);
  EXPECT_TRUE(problems_of(repaired.scan.surface).inconsistent_edges.empty());
}

TEST(ScanProblems, NameAPieceThatIsInsideOut) {
  TriangleMesh inside_out = test::sphere({300, 0, 0}, 40, 2);
  inside_out.triangles.col(1).swap(inside_out.triangles.col(2));
  const TriangleMesh mesh = joined(test::sphere({0, 0, 0}, 80, 2), inside_out);
  const ScanProblems found = problems_of(mesh);
  EXPECT_EQ(found.flipped_triangles.size(), std::size_t(inside_out.triangles.rows()));
  EXPECT_EQ(found.islands.size(), 2U);
  EXPECT_GT(found.islands[0].size, found.islands[1].size);
}

TEST(ScanProblems, NameEdgesOfThreeFacesAndPiecesThatTouchInAPoint) {
  TriangleMesh fin;
  fin.vertices = (Points(5, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1).finished();
  fin.triangles = (Triangles(3, 3) << 0, 1, 2, 1, 0, 3, 0, 1, 4).finished();
  EXPECT_EQ(problems_of(fin).non_manifold_edges, (std::vector<std::array<int, 2>>{{0, 1}}));
  TriangleMesh bow;
  bow.vertices = (Points(5, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, 1, 0).finished();
  bow.triangles = (Triangles(2, 3) << 0, 1, 2, 0, 4, 3).finished();
  EXPECT_EQ(problems_of(bow).non_manifold_vertices, std::vector<int>{0});
}

TEST(ScanProblems, NameSpareVerticesAndFacesWithoutArea) {
  TriangleMesh mesh;
  mesh.vertices =
      (Points(7, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 9, 9, 9, 0.5, 0, 0, 0, 0, -0.0)
          .finished();
  mesh.triangles = (Triangles(2, 3) << 0, 1, 2, 0, 5, 1).finished();
  const ScanProblems found = problems_of(mesh);
  EXPECT_EQ(found.duplicate_vertices, (std::vector<int>{3, 6}));
  EXPECT_EQ(found.unreferenced_vertices, std::vector<int>{4});
  EXPECT_EQ(found.degenerate_triangles, std::vector<int>{1});
  const RepairedScan first = without_duplicate_vertices(scan_of(mesh));
  EXPECT_EQ(first.vertex_of, (std::vector<int>{0, 1, 2, 4, 5}));
  const RepairedScan second = without_degenerate_triangles(first.scan);
  const RepairedScan third = without_unreferenced_vertices(second.scan);
  EXPECT_EQ(composed(first.vertex_of, third.vertex_of), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(third.scan.surface.triangles, (Triangles(1, 3) << 0, 1, 2).finished());
  EXPECT_NE(third.said.find("2 vertices removed"), std::string::npos) << third.said;
}

TEST(ScanProblems, NameTrianglesThatRunThroughEachOther) {
  TriangleMesh mesh;
  mesh.vertices = (Points(9, 3) << 0, 0, 0, 2, 0, 0, 0, 2, 0,  // a triangle,
                   0.5, 0.5, -1, 0.5, 0.5, 1, 3, 3, 0,         // one through it,
                   0, 0, 5, 1, 0, 5, 0, 1, 5)
                      .finished();  // one above
  mesh.triangles = (Triangles(3, 3) << 0, 1, 2, 3, 4, 5, 6, 7, 8).finished();
  EXPECT_EQ(problems_of(mesh).crossing_triangles, (std::vector<std::array<int, 2>>{{0, 1}}));
  // Neighbours at a corner and at a side do not cross, unless folded onto each other.
  mesh.vertices = (Points(5, 3) << 0, 0, 0, 2, 0, 0, 0, 2, 0, 0.4, 0.4, 0, 2, 2, 1).finished();
  mesh.triangles = (Triangles(2, 3) << 0, 1, 2, 2, 1, 4).finished();
  EXPECT_TRUE(problems_of(mesh).crossing_triangles.empty());
  mesh.triangles = (Triangles(2, 3) << 0, 1, 2, 0, 1, 3).finished();
  EXPECT_EQ(problems_of(mesh).crossing_triangles.size(), 1U);
}

TEST(ScanProblems, OfTwoSpheresThatCrossAreACircleOfPairs) {
  const TriangleMesh a = test::sphere({0, 0, 0}, 80, 3), b = test::sphere({70.3, 3.1, 1.7}, 80, 3);
  const auto pairs = problems_of(joined(a, b)).crossing_triangles;
  EXPECT_GT(pairs.size(), 20U);
  const int first = int(a.triangles.rows());
  for (const auto& [f, g] : pairs) EXPECT_TRUE(f < first && g >= first) << f << " " << g;
}

TEST(ScanRepairs, RemoveSmallPiecesAndKeepTheOrderOfWhatStays) {
  const TriangleMesh crumb = test::sphere({300, 0, 0}, 2, 1), head = test::sphere({0, 0, 0}, 80, 3);
  RawScan scan = scan_of(joined(crumb, head));
  scan.colours = Points::Constant(scan.surface.vertices.rows(), 3, 0.5);
  const RepairedScan repaired = without_islands_below(scan, 10);
  EXPECT_EQ(repaired.scan.surface.vertices, head.vertices);
  EXPECT_EQ(repaired.scan.surface.triangles, head.triangles);
  EXPECT_EQ(repaired.scan.colours.rows(), head.vertices.rows());
  EXPECT_EQ(repaired.vertex_of.front(), int(crumb.vertices.rows()));
  EXPECT_NE(repaired.said.find("1 piece removed"), std::string::npos) << repaired.said;
  EXPECT_EQ(without_islands_below(scan, 1).changed, 0U);
  EXPECT_EQ(without_islands_below(scan, 1e9).scan.surface.triangles.rows(), head.triangles.rows())
      << "the largest piece stays";
}

TEST(ScanRepairs, CloseSmallHolesAndLeaveTheRim) {
  const TriangleMesh sphere = test::sphere({0, 0, 0}, 80, 3);
  // The rim: everything below is cut off. The hole: one vertex with all its triangles.
  TriangleMesh mesh = sphere;
  Eigen::Index kept = 0, top = 0;
  sphere.vertices.col(2).maxCoeff(&top);
  for (const auto& t : sphere.triangles.rowwise()) {
    const bool low = sphere.vertices(t[0], 2) < -40;
    if (!low && (t.array() != int(top)).all()) mesh.triangles.row(kept++) = t;
  }
  mesh.triangles.conservativeResize(kept, 3);
  ASSERT_EQ(problems_of(mesh).borders.size(), 2U);
  const RepairedScan repaired = with_holes_filled(scan_of(mesh), 300);
  const ScanProblems after = problems_of(repaired.scan.surface);
  EXPECT_EQ(after.borders.size(), 1U);
  EXPECT_TRUE(after.inconsistent_edges.empty());
  EXPECT_TRUE(after.crossing_triangles.empty());
  EXPECT_EQ(repaired.changed, problems_of(mesh).borders[1].vertices.size() - 2);
  EXPECT_EQ(repaired.scan.corner_texture.rows(), repaired.scan.surface.triangles.rows());
  EXPECT_EQ(repaired.vertex_of.size(), std::size_t(mesh.vertices.rows()));
}

TEST(ScanProblems, AreSaidInWords) {
  const TriangleMesh mesh = without_triangle(test::sphere({0, 0, 0}, 80, 2), 17);
  const std::vector<std::string> lines = in_words(problems_of(mesh), mesh, "mm");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NE(lines[1].find("1 border"), std::string::npos) << lines[1];
}

}  // namespace
}  // namespace gnathion
