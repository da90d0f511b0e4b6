// Places where a face folds in on itself: pockets that are left out of a region, and folds that
// are smoothed for meshing.
#include <gtest/gtest.h>

#include "base/error.h"
#include "support/face_patch.h"
#include "tissue/hidden.h"
#include "tissue/st_generator.h"
#include "tissue/unfold.h"

namespace gnathion {
namespace {

/// A sheet with a mouth: a narrow slit of a neck, 8 mm deep, that opens into a wide bag below.
TriangleMesh sheet_with_bag() {
  const int around = 24, rings = 30;
  TriangleMesh mesh{Points(around * rings + 1, 3), Triangles(around * (2 * rings - 1), 3)};
  const auto profile = [](int ring) -> Eigen::Vector2d {    // radius and height
    if (ring < 12) return {40.0 - 3 * ring, 0};             // sheet to radius 7
    if (ring < 18) return {1.5, -1.0 - 1.2 * (ring - 12)};  // neck
    const double angle = (ring - 18) / 12.0 * 2.9;          // bag
    return {1.5 + 7 * std::sin(angle), -15 + 7 * std::cos(angle)};
  };
  for (int r = 0; r < rings; ++r) {
    for (int k = 0; k < around; ++k) {
      const double a = 2 * M_PI * k / around;
      const Eigen::Vector2d p = profile(r);
      mesh.vertices.row(r * around + k) << p[0] * std::cos(a), p[0] * std::sin(a), p[1];
    }
  }
  const int bottom = around * rings;
  mesh.vertices.row(bottom) << 0, 0, -22;
  Eigen::Index f = 0;
  for (int r = 0; r + 1 < rings; ++r) {
    for (int k = 0; k < around; ++k) {
      const int a = r * around + k, b = r * around + (k + 1) % around;
      mesh.triangles.row(f++) << a, b, a + around;
      mesh.triangles.row(f++) << b, b + around, a + around;
    }
  }
  for (int k = 0; k < around; ++k) {
    const int a = (rings - 1) * around + k, b = (rings - 1) * around + (k + 1) % around;
    mesh.triangles.row(f++) << a, b, bottom;
  }
  return mesh;
}

TEST(Hidden, TheBagIsHiddenAndTheSheetIsNot) {
  const TriangleMesh mesh = sheet_with_bag();
  ASSERT_GT(triangle_normals(mesh)(0, 2), 0.9) << "the sheet faces up";
  const std::vector<bool> all(static_cast<std::size_t>(mesh.vertices.rows()), true);
  const std::vector<bool> hidden = hidden_vertices(mesh, all);
  for (int v = 0; v < 10 * 24; ++v) EXPECT_FALSE(hidden[v]) << v;
  for (int v = 20 * 24; v < mesh.vertices.rows(); ++v) EXPECT_TRUE(hidden[v]) << v;
}

TEST(Region, LeavesThePocketOutWithItsRimFreeAndTakesItAlong) {
  const TriangleMesh mesh = sheet_with_bag();
  // A small plate 12 mm below the sheet's middle is the moving bone.
  TriangleMesh bone{Points(3, 3), Triangles(1, 3)};
  bone.vertices << 12, 0, -12, 15, 2, -12, 12, 4, -12;
  bone.triangles << 0, 1, 2;
  const IntermediateMesh region = suggest_region(mesh, BspTree(bone), 30);
  EXPECT_GT(region.enclosed.size(), 9 * 24u);
  int free_rim = 0, held_rim = 0;
  for (std::size_t v = 0; v < region.rim.size(); ++v) {
    if (!region.rim[v]) continue;
    const double radius = region.mesh.vertices.row(static_cast<Eigen::Index>(v)).head<2>().norm();
    (region.held[v] ? held_rim : free_rim) += 1;
    EXPECT_EQ(region.held[v], radius > 10) << radius;
  }
  EXPECT_GT(free_rim, 10);
  EXPECT_GT(held_rim, 10);
}

TEST(Unfold, LeavesASmoothFaceAlone) {
  const IntermediateMesh region = testing::whole_region(testing::patch_p1());
  const Unfolding result = unfold(region);
  EXPECT_EQ(result.moved_count, 0);
  EXPECT_EQ(result.region.mesh.vertices, region.mesh.vertices);
}

TEST(Unfold, MakesAFoldedPatchMeshable) {
  TriangleMesh mesh = testing::flat_disk(400, 76, 2);
  mesh.vertices.row(210) += Eigen::RowVector3d(5, 0.5, 0.5);  // pushed across its neighbours
  const IntermediateMesh region = testing::whole_region(mesh);
  const auto generate = [](const IntermediateMesh& r) {
    return st_generator(r, offset_directions(r, 4),
                        Eigen::VectorXd::Constant(r.mesh.vertices.rows(), 4));
  };
  EXPECT_THROW(generate(region), Error) << "the patch is not folded enough";
  const Unfolding result = unfold(region);
  EXPECT_GT(result.moved_count, 0);
  EXPECT_LT(result.moved_count, 120) << "only the fold moves";
  EXPECT_NO_THROW(generate(result.region));
}

}  // namespace
}  // namespace gnathion
