#include "render/split_surface.h"

#include <functional>
#include <limits>

#include "base/error.h"
#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

TEST_F(SceneTest, SplitKeepsEveryCorner) {
  const std::vector<SurfacePart> parts = split_by_corner(head);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_FALSE(parts[0].uv.empty());
  EXPECT_TRUE(parts[1].uv.empty());
  Eigen::Index next[2] = {0, 0};
  for (Eigen::Index t = 0; t < head.surface.triangles.rows(); ++t) {
    const auto material = static_cast<size_t>(head.triangle_material[static_cast<size_t>(t)]);
    const SurfacePart& part = parts[material];
    const Eigen::Index row = next[material]++;
    ASSERT_LT(row, part.triangles.rows());
    for (int c = 0; c < 3; ++c) {
      const auto shown = static_cast<size_t>(part.triangles(row, c));
      ASSERT_EQ(part.face_vertex[shown], head.surface.triangles(t, c));
      if (part.uv.empty()) continue;
      ASSERT_EQ(part.uv[shown],
                head.texture_coordinates.row(head.corner_texture(t, c)).transpose());
    }
  }
  EXPECT_EQ(next[0] + next[1], head.surface.triangles.rows());
}

TEST(SplitSurface, OnlySeamVerticesAreDoubled) {
  TexturedMesh two;  // two triangles on one edge, the edge's coordinates differing at vertex 1
  two.surface.vertices.setRandom(4, 3);
  two.surface.triangles.resize(2, 3);
  two.surface.triangles << 0, 1, 2, 2, 1, 3;
  two.texture_coordinates.setRandom(5, 2);
  two.corner_texture.resize(2, 3);
  two.corner_texture << 0, 1, 2, 2, 4, 3;
  two.triangle_material = {0, 0};
  two.materials.resize(1);
  two.materials[0].texture = "any.png";
  const auto parts = split_by_corner(two);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].face_vertex, (std::vector<int>{0, 1, 2, 1, 3}));
  two.corner_texture(1, 0) = -1;  // a corner without a coordinate
  EXPECT_EQ(split_by_corner(two).size(), 2u);
}

TEST_F(SceneTest, BrokenMeshesAreRefusedByName) {
  const std::function<void(TexturedMesh&)> breaks[] = {
      [](TexturedMesh& m) { m.surface.triangles.resize(0, 3); },
      [](TexturedMesh& m) { m.surface.vertices(0, 0) = std::numeric_limits<double>::infinity(); },
      [](TexturedMesh& m) {
        m.surface.triangles(0, 0) = static_cast<int>(m.surface.vertices.rows());
      },
      [](TexturedMesh& m) { m.surface.triangles(0, 0) = -1; },
      [](TexturedMesh& m) { m.triangle_material.pop_back(); },
      [](TexturedMesh& m) { m.triangle_material[0] = 2; },
      [](TexturedMesh& m) {
        m.corner_texture(4, 2) = static_cast<int>(m.texture_coordinates.rows());
      },
      [](TexturedMesh& m) {
        m.texture_coordinates(0, 1) = std::numeric_limits<double>::quiet_NaN();
      },
  };
  EXPECT_NO_THROW(check_face(head, "face"));
  for (const auto& damage : breaks) {
    TexturedMesh broken = head;
    damage(broken);
    try {
      check_face(broken, "photo.obj");
      ADD_FAILURE() << "accepted, case " << &damage - breaks;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_EQ(error.subject(), "photo.obj");
    }
  }
}

}  // namespace
}  // namespace gnathion::test
