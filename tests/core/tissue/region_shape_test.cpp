#include "tissue/region_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.h"
#include "support/expect_error.h"
#include "support/face_patch.h"
#include "support/solids.h"
#include "tissue/face_symmetry.h"
#include "tissue/intermediate_mesh.h"

namespace gnathion {
namespace {

using Kind = RegionFault::Kind;

class RegionShape : public ::testing::Test {
 protected:
  const SurfaceBrush brush_{testing::flat_disk(2500, 198, 1)};
  const TriangleMesh& mesh_ = brush_.face();
  const Eigen::RowVector3d middle_ = mesh_.vertices.colwise().mean();

  Selection within(double x, double y, double radius) const {
    Selection chosen(2500, false);
    for (int v = 0; v < 2500; ++v) {
      const Eigen::RowVector3d at = middle_ + Eigen::RowVector3d(x, y, 0);
      chosen[v] = (mesh_.vertices.row(v) - at).norm() <= radius;
    }
    return chosen;
  }
  static Selection both(const Selection& a, const Selection& b) {
    Selection all = a;
    for (std::size_t v = 0; v < a.size(); ++v) all[v] = a[v] || b[v];
    return all;
  }
  static int differing(const Selection& a, const Selection& b) {
    int count = 0;
    for (std::size_t v = 0; v < a.size(); ++v) count += a[v] != b[v];
    return count;
  }
  /// Of a disc as large as the selection, mm.
  double radius(const Selection& chosen) const {
    return std::sqrt(outline_of(brush_, chosen).area_mm2 / std::numbers::pi);
  }
};

TEST_F(RegionShape, SelectionAndVerticesAreTheSame) {
  EXPECT_EQ(vertices_of(selection_of({7, 2, 2, 40, -1}, 10)), (std::vector<int>{2, 7}));
}

TEST_F(RegionShape, OutlineIsThatOfTheRegion) {
  const Selection chosen = within(0, 0, 10);
  const RegionOutline outline = outline_of(brush_, chosen);
  const IntermediateMesh region = region_of_vertices(mesh_, vertices_of(chosen));
  EXPECT_EQ(outline.triangles.rows(), region.mesh.triangles.rows());
  EXPECT_NEAR(outline.area_mm2, surface_area(region.mesh), 1e-9);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(outline.rim.size()),
            std::count_if(region.edges.begin(), region.edges.end(),
                          [](const Edge& edge) { return edge.right == -1; }));
}

TEST_F(RegionShape, GrowsAndShrinksByMillimetres) {
  const Selection disc = within(0, 0, 10);
  EXPECT_NEAR(radius(grown(brush_, disc, 4)), radius(disc) + 4, 0.4);
  EXPECT_NEAR(radius(shrunk(brush_, disc, 4)), radius(disc) - 4, 0.4);
  EXPECT_NEAR(radius(shrunk(brush_, grown(brush_, disc, 5), 5)), radius(disc), 0.3);
  EXPECT_TRUE(vertices_of(shrunk(brush_, disc, 30)).empty());
  EXPECT_TRUE(vertices_of(grown(brush_, Selection(2500, false), 5)).empty());
}

TEST_F(RegionShape, ShrinkingLeavesTheFacesOwnBorder) {
  Selection half(2500);
  for (int v = 0; v < 2500; ++v) half[v] = mesh_.vertices(v, 0) < 20;
  const Selection smaller = shrunk(brush_, half, 5);
  for (int v = 0; v < 2500; ++v) {
    EXPECT_TRUE(smaller[v] || mesh_.vertices(v, 0) >= 14);
    EXPECT_FALSE(smaller[v] && mesh_.vertices(v, 0) > 16);
  }
}

TEST_F(RegionShape, SmoothingTakesSpikesAndBaysAndLeavesADisc) {
  const Selection disc = within(0, 0, 12);
  EXPECT_LT(differing(smoothed(brush_, disc, 2), disc), 40);
  Selection ragged = disc;
  for (int v = 0; v < 2500; ++v) {
    const Eigen::RowVector3d x = mesh_.vertices.row(v) - middle_;
    if (std::abs(x[1]) < 1.2 && x[0] > 0 && x[0] < 20) ragged[v] = true;     // a spike
    if (std::abs(x[1]) < 1.2 && x[0] < -5 && x[0] > -13) ragged[v] = false;  // a bay
  }
  EXPECT_GT(differing(ragged, disc), 25);
  EXPECT_LT(differing(smoothed(brush_, ragged, 3), smoothed(brush_, disc, 3)), 20);
}

TEST_F(RegionShape, KeepsTheLargestPiece) {
  const Selection large = within(-8, 0, 9), small = within(14, 0, 5);
  EXPECT_EQ(differing(largest_piece(brush_, both(large, small)), largest_piece(brush_, large)), 0);
}

TEST_F(RegionShape, FillsSmallHolesOfVisibleSkin) {
  const PocketSearch pockets(mesh_);
  Selection holed = within(0, 0, 15);
  for (const int v : vertices_of(within(3, 0, 2))) holed[v] = false;   // about 12 mm²
  for (const int v : vertices_of(within(-6, 0, 4))) holed[v] = false;  // about 50 mm²
  const Selection filled_small = filled(brush_, pockets, holed, 30);
  EXPECT_EQ(differing(filled_small, both(holed, within(3, 0, 2))), 0);
  EXPECT_EQ(differing(filled(brush_, pockets, holed, 200), within(0, 0, 15)), 0);
}

TEST_F(RegionShape, TakesPinchesAndLooseVerticesAway) {
  // Two squares that share one vertex, and a vertex alone.
  const auto columns = static_cast<int>((mesh_.vertices.col(1).array() == 0).count());
  Selection pinched(2500, false);
  const auto at = [&](int column, int row) { return row * columns + column; };
  for (int i = 0; i <= 6; ++i) {
    for (int j = 0; j <= 6; ++j) pinched[at(10 + i, 10 + j)] = pinched[at(16 + i, 16 + j)] = true;
  }
  pinched[at(40, 5)] = true;
  const auto faults = region_faults(brush_, pinched);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, Kind::touches_itself);
  EXPECT_EQ(faults[0].vertices, std::vector<int>{at(16, 16)});
  const Selection clean = without_pinches(brush_, pinched);
  EXPECT_FALSE(clean[at(40, 5)]);
  EXPECT_FALSE(clean[at(16, 16)]);
  const auto left = region_faults(brush_, clean);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].kind, Kind::pieces);
  EXPECT_EQ(left[0].count, 2);
}

TEST_F(RegionShape, SaysWhatIsWrong) {
  EXPECT_TRUE(region_faults(brush_, within(0, 0, 9)).empty());
  const auto empty = region_faults(brush_, Selection(2500, false));
  ASSERT_EQ(empty.size(), 1U);
  EXPECT_EQ(empty[0].kind, Kind::empty);
  const auto pieces = region_faults(brush_, both(within(-10, 0, 9), within(12, 0, 4)));
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].kind, Kind::pieces);
  EXPECT_EQ(pieces[0].count, 2);
  EXPECT_EQ(pieces[0].vertices, vertices_of(largest_piece(brush_, within(12, 0, 4))));
  const SurfaceBrush ball(test::sphere({0, 0, 0}, 20, 2));
  const auto whole =
      region_faults(ball, Selection(static_cast<std::size_t>(ball.face().vertices.rows()), true));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].kind, Kind::no_rim);
}

/// A lopsided head: an egg with a nose, leaning and moved in its frame, one cheek swollen.
TriangleMesh head(const Eigen::AngleAxisd& lean, const Eigen::Vector3d& shift) {
  TriangleMesh mesh = test::sphere({0, 0, 0}, 80, 5);
  for (auto x : mesh.vertices.rowwise()) {
    const Eigen::Vector3d d = x.transpose().normalized();
    const double nose = 25 * std::exp(-(d - Eigen::Vector3d(0, -1, 0)).squaredNorm() / 0.02);
    const double ears = 12 * std::exp(-std::pow(std::abs(d.x()) - 1, 2) / 0.01);
    const double cheek =
        4 * std::exp(-(d - Eigen::Vector3d(0.5, -0.8, -0.3).normalized()).squaredNorm() / 0.03);
    const double chin = 10 * std::exp(-(d - Eigen::Vector3d(0, -0.8, -0.6)).squaredNorm() / 0.05);
    const Eigen::Vector3d egg = d.cwiseProduct(Eigen::Vector3d(72, 95, 115));
    x = (lean * (egg + (nose + ears + cheek + chin) * d) + shift).transpose();
  }
  return mesh;
}

TEST(FaceSymmetry, FindsTheMidlineOfALeaningLopsidedHead) {
  const Eigen::AngleAxisd lean(8 * std::numbers::pi / 180,
                               Eigen::Vector3d(0.2, 1, 0.5).normalized());
  const Eigen::Vector3d shift(12, -40, 300);
  const TriangleMesh mesh = head(lean, shift);
  const SymmetryPlane plane = find_symmetry(mesh, BspTree(mesh));
  const Eigen::Vector3d truth = lean * Eigen::Vector3d::UnitX();
  EXPECT_LT(std::acos(plane.normal.dot(truth)) * 180 / std::numbers::pi, 0.7);
  const Eigen::Vector3d nose = lean * Eigen::Vector3d(0, -120, 0) + shift;
  EXPECT_NEAR(plane.normal.dot(nose) - plane.offset, 0, 0.7);
  EXPECT_LT(plane.error_mm, 0.5);
  EXPECT_NEAR((plane.mirrored(plane.mirrored(nose)) - nose).norm(), 0, 1e-9);
}

TEST(FaceSymmetry, MirrorsOneCheekOntoTheOther) {
  const TriangleMesh mesh = head(Eigen::AngleAxisd::Identity(), {0, 0, 0});
  const BspTree tree(mesh);
  const SurfaceBrush brush(mesh);
  const SymmetryPlane plane = find_symmetry(mesh, tree);
  const auto near = [&](double x) {
    Selection chosen(static_cast<std::size_t>(mesh.vertices.rows()), false);
    for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
      const Eigen::Vector3d d = mesh.vertices.row(v).normalized();
      chosen[v] = (d - Eigen::Vector3d(x, -0.8, -0.3).normalized()).norm() < 0.3;
    }
    return chosen;
  };
  const Selection left = near(0.5), right = near(-0.5);
  const Selection mirrored = with_mirror_image(brush, tree, plane, left);
  int wrong = 0;
  for (std::size_t v = 0; v < left.size(); ++v) wrong += mirrored[v] != (left[v] || right[v]);
  EXPECT_GT(vertices_of(left).size(), 120U);
  EXPECT_LT(wrong, 25);
  // What is symmetric already stays about as it is.
  const Selection again = with_mirror_image(brush, tree, plane, mirrored);
  EXPECT_LT(vertices_of(again).size() - vertices_of(mirrored).size(), 25U);
}

TEST(FaceSymmetry, RefusesWhatHasNoOtherSide) {
  TriangleMesh slope = testing::flat_disk(400, 76, 4);  // all of it on one slant
  slope.vertices.col(2) = 12 * slope.vertices.col(0);
  test::expect_error(ErrorKind::anatomy, {"region", "mirror"},
                     [&] { find_symmetry(slope, BspTree(slope)); });
}

TEST(PaintedRegion, LetsAPocketGoAlongAndHoldsVisibleHoles) {
  // A plate with a deep narrow well (a pocket), and a hole painted out of plain skin.
  TriangleMesh mesh = testing::flat_disk(2500, 198, 1);
  const Eigen::RowVector3d middle = mesh.vertices.colwise().mean();
  const auto from_well = [&](Eigen::Index v) {
    return std::hypot(mesh.vertices(v, 0) - middle[0] + 10, mesh.vertices(v, 1) - middle[1]);
  };
  std::vector<int> well;
  for (int v = 0; v < 2500; ++v) {
    if (from_well(v) >= 4) continue;
    mesh.vertices(v, 2) = -18;
    well.push_back(v);
  }
  std::vector<int> chosen;
  std::vector<int> bald;  // visible, not painted
  for (int v = 0; v < 2500; ++v) {
    const double r = (mesh.vertices.row(v).head<2>() - middle.head<2>()).norm();
    const double hole =
        std::hypot(mesh.vertices(v, 0) - middle[0] - 8, mesh.vertices(v, 1) - middle[1]);
    if (hole < 3) bald.push_back(v);
    if (r < 20 && from_well(v) >= 4 && hole >= 3) chosen.push_back(v);
  }
  const IntermediateMesh region = region_of_vertices(mesh, chosen);
  std::vector<int> enclosed = region.enclosed;
  std::sort(enclosed.begin(), enclosed.end());
  EXPECT_EQ(enclosed, well);
  for (std::size_t i = 0; i < region.rim.size(); ++i) {
    const bool at_well = from_well(region.face_vertex[i]) < 6;
    EXPECT_EQ(region.held[i], region.rim[i] && !at_well);
  }
  EXPECT_FALSE(bald.empty());
}

}  // namespace
}  // namespace gnathion
