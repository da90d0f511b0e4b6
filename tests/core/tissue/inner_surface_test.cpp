#include "tissue/inner_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "geometry/tet_quality.h"
#include "support/face_patch.h"
#include "tissue/st_generator.h"

namespace gnathion {
namespace {

using testing::hard_patch;
using testing::whole_region;

SoftTissueMesh robust(const IntermediateMesh& region, double depth) {
  RobustGeneratorOptions options;
  options.layers = LayerOptions{};
  return st_generator(region, offset_directions(region, depth),
                      Eigen::VectorXd::Constant(region.mesh.vertices.rows(), depth), options);
}

InnerSurfaceCrossings crossings_of(const IntermediateMesh& region, const SoftTissueMesh& tissue) {
  return inner_surface_crossings(region, inner_surface(region, tissue), tissue);
}

/// A sheet bent over by half a turn of this radius, so that its two sides are 2 × radius mm apart:
/// away from the skin, with the tissue between them as in a nose's wing or a lip (side −1), or
/// towards it, with the skins facing each other as in a deep fold (side 1).
TriangleMesh bent_sheet(double radius, int side) {
  TriangleMesh mesh = testing::flat_disk(900, 116, 1.4);
  const double middle = mesh.vertices.col(1).mean();
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    const double s = mesh.vertices(v, 1) - middle;
    const double turn = std::clamp(s / radius, 0.0, M_PI);
    const double beyond = std::max(0.0, s - M_PI * radius);
    mesh.vertices(v, 1) = std::min(s, 0.0) + radius * std::sin(turn) - beyond;
    mesh.vertices(v, 2) = side * radius * (1 - std::cos(turn));
  }
  return mesh;
}

TriangleMesh spike(double height, double width) {
  TriangleMesh mesh = testing::flat_disk(900, 116, 1.6);
  testing::raise(mesh, [=](double x, double y) {
    return height * std::exp(-std::pow(std::hypot(x, y) / width, 4));
  });
  return mesh;
}

TriangleMesh deep_fold(double depth, double half_width) {
  TriangleMesh mesh = testing::flat_disk(900, 116, 1.6);
  testing::raise(mesh, [=](double x, double y) {
    return -depth * std::exp(-std::pow(y / half_width, 4) - std::pow(x / 16, 6));
  });
  return mesh;
}

TEST(InnerSurface, IsTheTissuesBoundaryTowardsTheBone) {
  const IntermediateMesh region = whole_region(testing::flat_disk(100, 36, 2));
  const SoftTissueMesh tissue = robust(region, 5);
  const Triangles inner = inner_surface(region, tissue);
  Eigen::Index interior = 0;
  for (const Edge& edge : region.edges) interior += edge.right != -1;
  ASSERT_EQ(inner.rows(), 2 * interior);
  const Points normals = triangle_normals({tissue.mesh.vertices, inner});
  for (Eigen::Index f = 0; f < inner.rows(); ++f) {
    EXPECT_NEAR(normals(f, 2), -1, 1e-9) << "below a flat patch it is flat, and faces away";
  }
  EXPECT_TRUE(crossings_of(region, tissue).none());
}

TEST(InnerSurface, CrossingsAreFoundWhereANodeIsPushedThroughASurface) {
  const IntermediateMesh region = whole_region(testing::flat_disk(400, 76, 2));
  const SoftTissueMesh tissue = robust(region, 5);
  ASSERT_TRUE(crossings_of(region, tissue).none());
  const int v = 210;
  SoftTissueMesh poked = tissue;
  poked.mesh.vertices(tissue.inner(v), 2) = 0.5;
  const InnerSurfaceCrossings through_skin = crossings_of(region, poked);
  EXPECT_TRUE(through_skin.with_itself.empty());
  ASSERT_FALSE(through_skin.with_skin.empty());
  const Triangles inner = inner_surface(region, poked);
  for (const auto& [i, skin] : through_skin.with_skin) {
    EXPECT_TRUE((inner.row(i).array() == tissue.inner(v)).any());
  }
  poked = tissue;
  poked.mesh.vertices.row(tissue.inner(v)) += Eigen::RowVector3d(9, 0.3, -3);  // folded over
  poked.mesh.vertices.row(tissue.inner(v + 1)) += Eigen::RowVector3d(0, 0, -6);
  const InnerSurfaceCrossings folded = crossings_of(region, poked);
  EXPECT_FALSE(folded.with_itself.empty());
  EXPECT_TRUE(folded.with_skin.empty());
}

TEST(InnerSurface, FoldedFlatOntoItselfIsACrossing) {
  const IntermediateMesh region = whole_region(testing::flat_disk(400, 76, 2));
  SoftTissueMesh tissue = robust(region, 5);
  tissue.mesh.vertices(tissue.inner(210), 0) += 9;  // in the plane of the inner surface
  EXPECT_FALSE(crossings_of(region, tissue).with_itself.empty());
}

TEST(InnerSurface, ThePapersRuleCrossesItselfAndTheSkinOnABentSheet) {
  const IntermediateMesh thick = whole_region(bent_sheet(4, -1)),
                         thin = whole_region(bent_sheet(2, -1));
  EXPECT_FALSE(crossings_of(thick, st_generator_paper(thick, 5)).with_itself.empty());
  EXPECT_FALSE(crossings_of(thin, st_generator_paper(thin, 5)).with_skin.empty());
}

struct Scene {
  const char* name;
  TriangleMesh mesh;
};

void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

class NoCrossing : public ::testing::TestWithParam<std::tuple<Scene, double>> {};

TEST_P(NoCrossing, OfTheRobustGenerator) {
  const auto& [scene, depth] = GetParam();
  const IntermediateMesh region = whole_region(scene.mesh);
  const SoftTissueMesh tissue = robust(region, depth);
  const InnerSurfaceCrossings crossings = crossings_of(region, tissue);
  EXPECT_EQ(crossings.with_itself.size(), 0);
  EXPECT_EQ(crossings.with_skin.size(), 0);
  EXPECT_EQ(tet_quality(tissue.mesh).inverted, 0);
  EXPECT_GT(tissue.depth.minCoeff(), 0.1) << "mm: some tissue is left everywhere";
}
INSTANTIATE_TEST_SUITE_P(
    Scenes, NoCrossing,
    ::testing::Combine(::testing::Values(Scene{"wing 8 mm thick", bent_sheet(4, -1)},
                                         Scene{"wing 4 mm thick", bent_sheet(2, -1)},
                                         Scene{"fold of skin 6 mm wide", bent_sheet(3, 1)},
                                         Scene{"spike", spike(15, 5)},
                                         Scene{"tall spike", spike(25, 5)},
                                         Scene{"deep lip fold", deep_fold(10, 3)},
                                         Scene{"deeper lip fold", deep_fold(14, 4)}),
                       ::testing::Values(5.0, 12.0)));

TEST(NoCrossing, OnHardPatches) {
  for (const double depth : {5.0, 12.0}) {
    for (int kind = 0; kind < 4; ++kind) {
      for (unsigned seed = 0; seed < 12; ++seed) {
        const IntermediateMesh region = whole_region(hard_patch(kind, seed));
        const SoftTissueMesh tissue = robust(region, depth);
        EXPECT_TRUE(crossings_of(region, tissue).none()) << kind << " " << seed << " " << depth;
        EXPECT_GT(tissue.depth.mean(), 0.85 * depth) << kind << " " << seed << " " << depth;
      }
    }
  }
}

TEST(NoCrossing, TissueOfAWingIsThinOnlyWhereItMustBe) {
  const IntermediateMesh region = whole_region(bent_sheet(4, -1));
  const SoftTissueMesh tissue = robust(region, 5);
  EXPECT_GT(tissue.depth.mean(), 2.5) << "of the 4 mm that there is room for";
  // A sheet that is bent the other way has room for all of it, but near the fold.
  const IntermediateMesh fold = whole_region(bent_sheet(4, 1));
  EXPECT_GT(robust(fold, 5).depth.mean(), 4.5);
}

}  // namespace
}  // namespace gnathion
