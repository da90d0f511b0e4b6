#include "tissue/coarse_region.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <map>

#include "base/error.h"
#include "geometry/tet_quality.h"
#include "support/face_patch.h"
#include "tissue/inner_surface.h"
#include "tissue/st_generator.h"

namespace gnathion {
namespace {

using testing::whole_region;

/// A face of the shape of patch p1 with 101 094 triangles, edges of half a millimetre.
const TriangleMesh& dense_face() {
  static const TriangleMesh face = [] {
    TriangleMesh mesh = testing::flat_disk(51000, 904, 0.45);
    testing::raise(mesh, testing::lower_face);
    return mesh;
  }();
  return face;
}

/// Of it, all but a mouth of 12 × 5 mm, whose rim is free and which encloses some vertices.
IntermediateMesh region_with_mouth(const TriangleMesh& face) {
  const Eigen::RowVector3d middle =
      (face.vertices.colwise().minCoeff() + face.vertices.colwise().maxCoeff()) / 2;
  std::vector<int> chosen, mouth;
  for (int v = 0; v < face.vertices.rows(); ++v) {
    const Eigen::RowVector3d x = face.vertices.row(v) - middle;
    (std::hypot(x[0] / 12, (x[1] - 4) / 5) < 1 ? mouth : chosen).push_back(v);
  }
  IntermediateMesh region = region_of_vertices(face, chosen);
  for (std::size_t v = 0; v < region.rim.size(); ++v) {
    const Eigen::RowVector3d x = region.mesh.vertices.row(static_cast<Eigen::Index>(v)) - middle;
    region.held[v] = region.rim[v] && std::hypot(x[0], x[1]) > 20;
  }
  region.enclosed = mouth;
  return region;
}

class DenseRegion : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dense_ = new IntermediateMesh(region_with_mouth(dense_face()));
    coarse_ = new CoarseRegion(coarse_region(*dense_, dense_face().vertices, 2.5));
  }
  static void TearDownTestSuite() {
    delete dense_;
    delete coarse_;
  }
  static const IntermediateMesh& dense() { return *dense_; }
  static const CoarseRegion& coarse() { return *coarse_; }

 private:
  static inline const IntermediateMesh* dense_ = nullptr;
  static inline const CoarseRegion* coarse_ = nullptr;
};

TEST_F(DenseRegion, BecomesCoarseAndStaysAFaceWithItsRims) {
  ASSERT_GT(dense().mesh.triangles.rows(), 90000);
  const IntermediateMesh& region = coarse().region;
  EXPECT_NEAR(mean_edge_length(region.mesh), 2.5, 0.25);
  EXPECT_LT(region.mesh.triangles.rows(), 6000);
  EXPECT_TRUE(region.face_vertex.empty());
  EXPECT_EQ(region.enclosed, dense().enclosed);
  for (const int component : triangle_components(region.mesh)) EXPECT_EQ(component, 0);
  // edges_of throws unless it is an oriented two-manifold; with a hole V − E + F is 0.
  const auto edges = edges_of(region.mesh);
  EXPECT_EQ(region.mesh.vertices.rows() - Eigen::Index(edges.size()) + region.mesh.triangles.rows(),
            0);
  // Orientation: no triangle is turned over.
  const Points normals = triangle_normals(region.mesh);
  EXPECT_GT(normals.col(2).minCoeff(), 0.1);
  EXPECT_NEAR(surface_area(region.mesh), surface_area(dense().mesh),
              0.01 * surface_area(dense().mesh));
}

TEST_F(DenseRegion, LiesOnTheDenseSurface) {
  // Edges of 2.5 mm over a lip of radius R leave it by e²/8R; the rim's corners by a tenth of e.
  EXPECT_LT(coarse().distance.mean, 0.02);
  EXPECT_LT(coarse().distance.p95, 0.1);
  EXPECT_LT(coarse().distance.max, 0.5);
  EXPECT_EQ(coarse().distance.count, dense().mesh.vertices.rows());
  const BspTree surface(dense().mesh);
  for (Eigen::Index v = 0; v < coarse().region.mesh.vertices.rows(); ++v) {
    if (coarse().region.rim[v]) continue;
    ASSERT_LT(surface.nearest(coarse().region.mesh.vertices.row(v), 10)->distance, 1e-6);
  }
}

TEST_F(DenseRegion, HeldAndFreeRimsAreCarriedOver) {
  const IntermediateMesh& region = coarse().region;
  int held = 0, free = 0;
  for (std::size_t v = 0; v < region.rim.size(); ++v) {
    EXPECT_TRUE(region.rim[v] || !region.held[v]);
    held += region.held[v];
    free += region.rim[v] && !region.held[v];
  }
  EXPECT_NEAR(held, 904 * 0.45 / 2.5, 50);
  EXPECT_NEAR(free, 30, 12) << "around the mouth, 56 mm or, with its steps, 71 mm";
}

TEST_F(DenseRegion, RowsOfTheMapSumToOneAndTheOthersAreEmpty) {
  const SurfaceMap& W = coarse().surface_map;
  ASSERT_EQ(W.rows(), dense_face().vertices.rows());
  ASSERT_EQ(W.cols(), coarse().region.mesh.vertices.rows());
  std::vector<bool> mapped(static_cast<std::size_t>(W.rows()), false);
  for (const int v : dense().face_vertex) mapped[v] = true;
  for (const int v : dense().enclosed) mapped[v] = true;
  for (int row = 0; row < W.rows(); ++row) {
    double sum = 0;
    for (SurfaceMap::InnerIterator weight(W, row); weight; ++weight) {
      EXPECT_GT(weight.value(), 0);
      sum += weight.value();
    }
    if (mapped[row]) {
      ASSERT_NEAR(sum, 1, 1e-12);
    } else {
      ASSERT_EQ(sum, 0);
    }
  }
}

TEST_F(DenseRegion, ALinearFieldIsReproducedToItsGradientTimesTheDistance) {
  Eigen::Matrix3d gradient;
  gradient << 0.1, -0.2, 0.05, 0.3, 0.1, 0, -0.1, 0.2, 0.25;
  const Eigen::RowVector3d shift(1, -2, 3);
  const auto field = [&](const Points& x) -> Points {
    return (x * gradient.transpose()).rowwise() + shift;
  };
  const Points on_face = coarse().surface_map * field(coarse().region.mesh.vertices);
  const Points wanted = field(dense_face().vertices);
  const double steepness = gradient.norm();
  double mean = 0;
  for (std::size_t i = 0; i < dense().face_vertex.size(); ++i) {
    const int v = dense().face_vertex[i];
    const double error = (on_face.row(v) - wanted.row(v)).norm();
    // The held rim goes to the rim, which is up to a tenth of an edge further off than the surface.
    ASSERT_LE(error, steepness * (coarse().distance.max + 0.25)) << v;
    mean += error / static_cast<double>(dense().face_vertex.size());
  }
  EXPECT_LT(mean, steepness * 2 * coarse().distance.mean);
}

TEST_F(DenseRegion, TheHeldRimIsStill) {
  Points u = Points::Random(coarse().region.mesh.vertices.rows(), 3);
  for (Eigen::Index v = 0; v < u.rows(); ++v) {
    if (coarse().region.held[v]) u.row(v).setZero();
  }
  const Points on_face = coarse().surface_map * u;
  int held = 0;
  for (std::size_t i = 0; i < dense().held.size(); ++i) {
    if (!dense().held[i]) continue;
    EXPECT_EQ(on_face.row(dense().face_vertex[i]), Eigen::RowVector3d::Zero());
    ++held;
  }
  EXPECT_EQ(held, 904);
}

TEST_F(DenseRegion, IsMeshedByTheGenerator) {
  RobustGeneratorOptions options;
  options.layers = LayerOptions{};
  const IntermediateMesh& region = coarse().region;
  const SoftTissueMesh tissue =
      st_generator(region, offset_directions(region, 8),
                   Eigen::VectorXd::Constant(region.mesh.vertices.rows(), 8), options);
  EXPECT_EQ(tet_quality(tissue.mesh).inverted, 0);
  EXPECT_GT(tissue.depth.mean(), 7.5);
  EXPECT_LT(tet_quality(tissue.mesh).median_aspect, 3.5);
  EXPECT_TRUE(inner_surface_crossings(region, inner_surface(region, tissue), tissue).none());
}

TEST(CoarseRegion, OfAHardPatchFollowsItsFolds) {
  // Four triangles for each of a hard patch: edges of 1.1 mm, asked for 2.2.
  const TriangleMesh coarse = testing::hard_patch(1, 3);
  TriangleMesh fine{Points(coarse.vertices.rows() + Eigen::Index(edges_of(coarse).size()), 3),
                    Triangles(4 * coarse.triangles.rows(), 3)};
  fine.vertices.topRows(coarse.vertices.rows()) = coarse.vertices;
  std::map<std::pair<int, int>, int> middle;
  const auto middle_of = [&](int a, int b) {
    const auto next = static_cast<int>(coarse.vertices.rows()) + static_cast<int>(middle.size());
    const auto [place, is_new] = middle.try_emplace(std::minmax(a, b), next);
    if (is_new) fine.vertices.row(next) = (coarse.vertices.row(a) + coarse.vertices.row(b)) / 2;
    return place->second;
  };
  for (Eigen::Index f = 0; f < coarse.triangles.rows(); ++f) {
    const int a = coarse.triangles(f, 0), b = coarse.triangles(f, 1), c = coarse.triangles(f, 2);
    const int ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    fine.triangles.middleRows<4>(4 * f) << a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca;
  }
  const IntermediateMesh region = whole_region(fine);
  const CoarseRegion result = coarse_region(region, fine.vertices, 2.2);
  EXPECT_NEAR(mean_edge_length(result.region.mesh), 2.2, 0.3);
  EXPECT_LT(result.distance.p95, 0.3);
  EXPECT_LT(result.distance.max, 0.9);
}

TEST(CoarseRegion, IsTheRegionItselfWhereThatIsCoarseEnough) {
  const IntermediateMesh region = whole_region(testing::patch_p1());
  const CoarseRegion same = coarse_region(region, region.mesh.vertices, 2.5);
  EXPECT_EQ(same.region.mesh.vertices, region.mesh.vertices);
  EXPECT_EQ(same.region.face_vertex, region.face_vertex);
  const Points u = Points::Random(region.mesh.vertices.rows(), 3);
  EXPECT_EQ(Points(same.surface_map * u), u);
  EXPECT_EQ(same.distance.max, 0);
}

TEST(CoarseRegion, TheMapToTheRegionItselfIsTheIndexMap) {
  const IntermediateMesh region = whole_region(testing::patch_p1());
  const SurfaceMap W = barycentric_map(region, region, region.mesh.vertices);
  const Points u = Points::Random(region.mesh.vertices.rows(), 3);
  EXPECT_EQ(Points(W * u), u);
}

TEST(CoarseRegion, RefusesWhatCannotBeMeantAndNamesIt) {
  const IntermediateMesh region = whole_region(testing::patch_p1());
  const Points& face = region.mesh.vertices;
  for (const double edge : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(coarse_region(region, face, edge), Error) << edge;
  }
  try {
    coarse_region(region, face, 60);
    FAIL() << "a region of a few triangles was made";
  } catch (const Error& error) {
    EXPECT_EQ(error.subject(), "region");
    EXPECT_NE(error.problem().find("triangles are left"), std::string::npos);
  }
}

}  // namespace
}  // namespace gnathion
