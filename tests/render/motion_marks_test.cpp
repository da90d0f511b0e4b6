#include <gtest/gtest.h>

#include <cstdlib>

#include "render/collision_marks.h"
#include "render/ghost_bones.h"
#include "render/scene_fixture.h"
#include "support/solids.h"

namespace gnathion::test {
namespace {

using MotionMarks = SceneTest;

int differing(const Picture& a, const Picture& b) {
  int found = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    found += std::abs(a.rgb[i] - b.rgb[i]) + std::abs(a.rgb[i + 1] - b.rgb[i + 1]) > 20 ? 1 : 0;
  }
  return found;
}

bool is_red(const std::uint8_t* rgb) {
  return rgb[0] > 170 && rgb[1] < 60 && rgb[2] < 60;
}

int count_red(const Picture& picture) {
  int found = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) found += is_red(&picture.rgb[i]) ? 1 : 0;
  return found;
}

TEST_F(MotionMarks, GhostIsSeenOverBoneAndHiddenBySkinAsAsked) {
  const TriangleMesh bone = sphere({0, -40, -40}, 18, 4);
  scene.set_face(head);
  GhostBones ghost;
  ghost.attach(scene.renderer());
  ghost.set_bone(bone.vertices, bone.triangles);
  const Picture without = front();
  ghost.set_visible(true);
  ghost.set_in_front(false);
  EXPECT_EQ(differing(front(), without), 0);  // inside the head
  ghost.set_in_front(true);
  EXPECT_GT(differing(front(), without), 100);
  // Over bone that hides it by its depth, the head see-through.
  scene.set_bone("jaw", sphere({0, -45, -40}, 24, 4), segment_look);
  scene.set_face_opacity(0.4);
  const Picture with = front();
  ghost.set_visible(false);
  EXPECT_GT(differing(with, front()), 100);
}

TEST_F(MotionMarks, CollisionsAreSeenThroughTheHeadOnTheirSide) {
  scene.set_face(head);
  scene.set_face_textured(false);  // its paint has red, too
  CollisionMarks marks;
  marks.attach(scene.renderer());
  EXPECT_EQ(count_red(front()), 0);
  Points places(3, 3);
  places << 30, -30, 0, 31, -30, 0, 30, -30, 1;
  marks.show(places, {});
  const Picture picture = front();
  EXPECT_GT(count_red(picture), 10);
  EXPECT_GT(mean_column(picture, is_red), picture.width / 2 + 20);  // left is the picture's right
  marks.show(places, {{{30, -30, 0}, "1.8 mm"}});
  EXPECT_GT(count_red(front()), count_red(picture) + 20);
  marks.show({}, {});
  EXPECT_EQ(count_red(front()), 0);
}

}  // namespace
}  // namespace gnathion::test
