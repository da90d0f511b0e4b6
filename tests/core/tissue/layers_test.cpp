#include "tissue/layers.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "geometry/tet_quality.h"
#include "support/face_patch.h"
#include "tissue/st_generator.h"

namespace gnathion {
namespace {

using testing::hard_patch;
using testing::whole_region;

SoftTissueMesh robust(const IntermediateMesh& region, double depth, const LayerOptions& layers) {
  RobustGeneratorOptions options;
  options.layers = layers;
  return st_generator(region, offset_directions(region, depth),
                      Eigen::VectorXd::Constant(region.mesh.vertices.rows(), depth), options);
}

/// Of the faces of all tets, by their sorted corners: how many tets have it one way round, and how
/// many the other.
std::map<std::array<int, 3>, std::array<int, 2>> faces_of(const Tets& tets) {
  constexpr int kOutward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  std::map<std::array<int, 3>, std::array<int, 2>> faces;
  for (Eigen::Index t = 0; t < tets.rows(); ++t) {
    for (const auto& face : kOutward) {
      std::array<int, 3> key{tets(t, face[0]), tets(t, face[1]), tets(t, face[2])};
      int swaps = 0;
      for (const auto [i, j] : {std::array{0, 1}, std::array{1, 2}, std::array{0, 1}}) {
        if (key[i] < key[j]) continue;
        std::swap(key[i], key[j]);
        ++swaps;
      }
      ++faces[key][swaps % 2];
    }
  }
  return faces;
}

/// Whether neighbours fit: no face has two tets on the same side, and those with one tet are the
/// skin's triangles, the inner surface's 2 E_i triangles and the walls below the rim.
void expect_conforming(const IntermediateMesh& region, const SoftTissueMesh& tissue) {
  const int M = tissue.surface_count, N = tissue.triangle_count;
  int skin = 0, inner = 0;
  for (const auto& [face, sides] : faces_of(tissue.mesh.tets)) {
    ASSERT_LE(sides[0], 1);
    ASSERT_LE(sides[1], 1);
    if (sides[0] + sides[1] == 2) continue;
    int of_skin = 0, centres = 0, inners = 0;
    bool below_rim = true;
    for (const int node : face) {
      of_skin += node < M;
      centres += node >= 2 * M && node < 2 * M + N;
      inners += node >= M && node < 2 * M;
    }
    if (centres == 2 && inners == 1) {
      ++inner;
      continue;
    }
    if (of_skin == 3) {
      ++skin;
      continue;
    }
    for (const int node : face) {
      if (node >= 2 * M && node < 2 * M + N) continue;  // of a triangle with a rim edge
      int v = 0;
      while (v < M && !(node == v || node == tissue.inner(v) ||
                        (node >= tissue.column_node(v, 1) && node <= tissue.above_deepest(v) &&
                         tissue.layers(v) > 1))) {
        ++v;
      }
      ASSERT_LT(v, M);
      below_rim = below_rim && region.rim[v];
    }
    EXPECT_TRUE(below_rim) << face[0] << " " << face[1] << " " << face[2];
  }
  EXPECT_EQ(skin, N);
  const auto interior = std::count_if(region.edges.begin(), region.edges.end(),
                                      [](const Edge& edge) { return edge.right != -1; });
  EXPECT_EQ(inner, 2 * interior);
}

TEST(SetLayers, FitTogetherWhateverTheNumbersOfLayers) {
  const IntermediateMesh region = whole_region(testing::flat_disk(120, 40, 2));
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    std::vector<int> layers;
    for (int v = 0; v < 120; ++v) layers.push_back(1 + static_cast<int>(random() % 5));
    SoftTissueMesh tissue = robust(region, 5, kOneLayer);
    const Points before = tissue.mesh.vertices;
    set_layers(region, layers, seed % 2 == 0 ? 1 : 1.5, tissue);
    for (int v = 0; v < 120; ++v) ASSERT_EQ(tissue.layers(v), layers[v]);
    EXPECT_EQ(tissue.mesh.vertices.topRows(before.rows()), before);
    expect_conforming(region, tissue);
    EXPECT_EQ(tet_quality(tissue.mesh).inverted, 0) << "on a flat patch all columns are parallel";
  }
}

TEST(SetLayers, OneEverywhereIsThePapersMesh) {
  const IntermediateMesh region = whole_region(hard_patch(0, 1));
  const SoftTissueMesh paper = st_generator_paper(region, 5);
  SoftTissueMesh tissue = robust(region, 5, {1, 1, 8});
  ASSERT_GT(tissue.mesh.tets.rows(), paper.mesh.tets.rows());
  set_layers(region, std::vector<int>(static_cast<std::size_t>(tissue.surface_count), 1), 1,
             tissue);
  EXPECT_EQ(tissue.mesh.tets, paper.mesh.tets);
  EXPECT_EQ(tissue.mesh.vertices.rows(), paper.mesh.vertices.rows());
}

TEST(SetLayers, PlaceTheNodesOfAColumnByGrowth) {
  const IntermediateMesh region = whole_region(testing::flat_disk(100, 36, 2));
  const SoftTissueMesh tissue = robust(region, 19, {1, 1.5, 8});
  const int v = 44;
  ASSERT_EQ(tissue.layers(v), 4) << "2 + 3 + 4.5 + 6.75 mm below edges of about 2 mm";
  double depth = 0;
  for (int level = 1; level <= 4; ++level) {
    depth += 19 / (1 + 1.5 + 2.25 + 3.375) * std::pow(1.5, level - 1);
    EXPECT_NEAR(tissue.mesh.vertices(tissue.column_node(v, level), 2), -depth, 1e-9);
  }
  EXPECT_EQ(tissue.column_node(v, 4), tissue.inner(v));
}

class Layers : public ::testing::TestWithParam<std::tuple<int, double>> {};

TEST_P(Layers, OfHardPatchesAreNeverInvertedAndBetterShaped) {
  const auto [kind, depth] = GetParam();
  for (unsigned seed = 0; seed < 6; ++seed) {
    const IntermediateMesh region = whole_region(hard_patch(kind, seed));
    const SoftTissueMesh one = robust(region, depth, kOneLayer);
    const SoftTissueMesh more = robust(region, depth, LayerOptions{});
    const TetQuality q = tet_quality(more.mesh), q_one = tet_quality(one.mesh);
    EXPECT_EQ(q.inverted, 0) << "seed " << seed;
    EXPECT_LT(q.median_aspect, q_one.median_aspect * 0.8) << "seed " << seed;
    EXPECT_EQ(more.depth, one.depth) << "thickness is kept";
    for (const Edge& edge : region.edges) {
      ASSERT_LE(std::abs(more.layers(edge.a) - more.layers(edge.b)), 1);
    }
    expect_conforming(region, more);
  }
}
INSTANTIATE_TEST_SUITE_P(HardPatches, Layers,
                         ::testing::Combine(::testing::Range(0, 4), ::testing::Values(5.0, 12.0)));

TEST(LayersOptions, CapTheNumberAndOneLayerIsTheDefaultOfTheGenerator) {
  const IntermediateMesh region = whole_region(testing::flat_disk(400, 76, 2));
  const auto most = [](const SoftTissueMesh& tissue) {
    int layers = 0;
    for (int v = 0; v < tissue.surface_count; ++v) layers = std::max(layers, tissue.layers(v));
    return layers;
  };
  EXPECT_EQ(most(robust(region, 40, {1, 1, 5})), 5);
  EXPECT_EQ(most(robust(region, 40, {0, 1, 5})), 1);
  EXPECT_EQ(most(robust(region, 40, {std::numeric_limits<double>::infinity(), 1, 5})), 1);
  EXPECT_EQ(most(robust(region, 40, RobustGeneratorOptions{}.layers)), 1);
}

}  // namespace
}  // namespace gnathion
