#include "tissue/st_generator.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/tet_quality.h"
#include "support/face_patch.h"

namespace gnathion {
namespace {

using testing::hard_patch;
using testing::whole_region;

SoftTissueMesh robust(const IntermediateMesh& region, double depth) {
  return st_generator(region, offset_directions(region, 5),
                      Eigen::VectorXd::Constant(region.mesh.vertices.rows(), depth));
}

/// Table 1 of the paper: V and F give exactly these element counts, in either mode.
struct TableOneRow {
  TriangleMesh mesh;
  int vertices, triangles, tets;
};

class TableOne : public ::testing::TestWithParam<int> {};

TEST_P(TableOne, ElementCountIsThePapers) {
  const TableOneRow row = GetParam() == 1 ? TableOneRow{testing::patch_p1(), 2192, 4202, 22841}
                                          : TableOneRow{testing::patch_p2(), 4817, 9337, 50911};
  ASSERT_EQ(row.mesh.vertices.rows(), row.vertices);
  ASSERT_EQ(row.mesh.triangles.rows(), row.triangles);
  const IntermediateMesh region = whole_region(row.mesh);
  EXPECT_EQ(st_generator_paper(region, 5).mesh.tets.rows(), row.tets);
  EXPECT_EQ(robust(region, 5).mesh.tets.rows(), row.tets);
}
INSTANTIATE_TEST_SUITE_P(Experiments, TableOne, ::testing::Values(1, 2));

TEST(StGeneratorPaper, PointsAndElementsFollowAlgorithm1) {
  // Two triangles that share the edge 1–2.
  TriangleMesh mesh{Points(4, 3), Triangles(2, 3)};
  mesh.vertices << 0, 0, 0, 3, 0, 0, 0, 3, 0, 3, 3, 0;
  mesh.triangles << 0, 1, 2, 1, 3, 2;
  const SoftTissueMesh tissue = st_generator_paper(whole_region(mesh), 2, 0.25);
  ASSERT_EQ(tissue.mesh.vertices.rows(), 10);
  ASSERT_EQ(tissue.mesh.tets.rows(), 2 + 3);
  EXPECT_TRUE(tissue.mesh.vertices.row(tissue.inner(3)).isApprox(Eigen::RowVector3d(3, 3, -2)));
  EXPECT_TRUE(tissue.mesh.vertices.row(tissue.centre(0)).isApprox(Eigen::RowVector3d(1, 1, -0.5)));
  EXPECT_EQ(tet_quality(tissue.mesh).inverted, 0);
  // Per triangle area × d_c / 3; per interior edge the rest of method.md's formula.
  EXPECT_NEAR(tet_volumes(tissue.mesh)[0], 4.5 * 0.5 / 3, 1e-12);
}

TEST(StGeneratorRobust, KeepsTheVolumeOfAFlatPatchAwayFromTheRim) {
  const TriangleMesh mesh = testing::flat_disk(700, 100, 2);
  const SoftTissueMesh tissue = robust(whole_region(mesh), 5);
  // Every tet of an interior edge and triangle is there, so the only tissue missing is below the
  // rim's edges: half a prism each, at most.
  const double prism = surface_area(mesh) * 5;
  const double rim_loss = 100 * 2 * 2 * 5 / 3.0;
  EXPECT_LT(tet_quality(tissue.mesh).total_volume, prism);
  EXPECT_GT(tet_quality(tissue.mesh).total_volume, prism - rim_loss);
}

TEST(StGeneratorRobust, NoInvertedTetOnHardPatchesWhereThePapersRuleHasSome) {
  long inverted_by_paper = 0;
  for (int kind = 0; kind < 4; ++kind) {
    for (unsigned seed = 0; seed < 6; ++seed) {
      const IntermediateMesh region = whole_region(hard_patch(kind, seed));
      const SoftTissueMesh tissue = robust(region, 5);
      EXPECT_EQ(tet_quality(tissue.mesh).inverted, 0) << "kind " << kind << " seed " << seed;
      EXPECT_GT(tissue.depth.mean(), 3.5) << "kind " << kind << " seed " << seed;
      inverted_by_paper += tet_quality(st_generator_paper(region, 5).mesh).inverted;
    }
  }
  EXPECT_GT(inverted_by_paper, 0) << "the patches are not hard";
}

TEST(StGeneratorRobust, RefusesAFoldedSurfaceNamingThePlace) {
  TriangleMesh mesh = testing::flat_disk(100, 36, 2);
  mesh.vertices.row(44) += Eigen::RowVector3d(7, 0, 0);  // pushed across its neighbours
  try {
    robust(whole_region(mesh), 5);
    FAIL() << "a folded surface was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::anatomy);
    EXPECT_NE(error.problem().find("folded at LPS"), std::string::npos);
  }
}

}  // namespace
}  // namespace gnathion
