#include "geometry/triangle_mesh.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/rigid_motion.h"

namespace gnathion {
namespace {

TriangleMesh cube(double side, const Eigen::RowVector3d& at) {
  TriangleMesh mesh{Points(8, 3), Triangles(12, 3)};
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.row(i) = at + side * Eigen::RowVector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  mesh.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
      2, 4, 6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

TEST(TriangleMesh, VolumeAndAreaOfACubeEvenFarFromTheOrigin) {
  EXPECT_NEAR(signed_volume(cube(2, {0, 0, 0})), 8, 1e-12);
  EXPECT_NEAR(signed_volume(cube(2, {1e6, -1e6, 1e6})), 8, 1e-8);
  EXPECT_NEAR(surface_area(cube(2, {0, 0, 0})), 24, 1e-12);
}

TEST(TriangleMesh, VertexNormalsOfACubePointAlongItsDiagonals) {
  const TriangleMesh mesh = cube(2, {-1, -1, -1});
  const Points normals = vertex_normals(mesh);
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(normals.row(i).isApprox(mesh.vertices.row(i).normalized(), 1e-12));
  }
}

TEST(TriangleMesh, ClosedSurfaceHasNoRimAndEulerCharacteristicTwo) {
  const TriangleMesh mesh = cube(1, {0, 0, 0});
  const auto edges = edges_of(mesh);
  EXPECT_EQ(8 - static_cast<int>(edges.size()) + 12, 2);
  for (const bool on_rim : rim_vertices(mesh, edges)) EXPECT_FALSE(on_rim);
}

TEST(TriangleMesh, AFlippedTriangleIsNoOrientedSurface) {
  TriangleMesh mesh = cube(1, {0, 0, 0});
  std::swap(mesh.triangles(3, 0), mesh.triangles(3, 1));
  EXPECT_THROW(edges_of(mesh), Error);
}

TEST(TriangleMesh, SubMeshKeepsParentIndices) {
  TriangleMesh two = cube(1, {0, 0, 0});
  const TriangleMesh other = cube(1, {5, 0, 0});
  two.vertices.conservativeResize(16, 3);
  two.vertices.bottomRows(8) = other.vertices;
  two.triangles.conservativeResize(24, 3);
  two.triangles.bottomRows(12) = other.triangles.array() + 8;
  const auto component = triangle_components(two);
  EXPECT_EQ(component.front(), 0);
  EXPECT_EQ(component.back(), 1);
  std::vector<bool> keep(24);
  for (int f = 0; f < 24; ++f) keep[f] = component[f] == 1;
  const SubMesh part = sub_mesh(two, keep);
  ASSERT_EQ(part.mesh.vertices.rows(), 8);
  EXPECT_EQ(part.parent_vertex.front(), 8);
  EXPECT_EQ(part.parent_triangle.front(), 12);
  EXPECT_TRUE(part.mesh.vertices.isApprox(other.vertices));
  EXPECT_NEAR(signed_volume(part.mesh), 1, 1e-12);
}

TEST(Similarity, DisplacementsGoBackToTheSourceFrame) {
  Similarity s;
  s.scale = 50;
  s.rotation << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  s.translation << 1, 2, 3;
  const Eigen::Vector3d x(0.1, -0.7, 2), u(0, -8, 1);
  EXPECT_TRUE(s(x + s.displacement_to_source(u)).isApprox(s(x) + u, 1e-12));
}

}  // namespace
}  // namespace gnathion
