#include "render/orientation_cube.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <Eigen/Geometry>

#include "render/crosshair_mark.h"
#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

using Eigen::Vector3d;

std::string letters(const Vector3d& right, const Vector3d& up, const Vector3d& away) {
  std::string text;
  for (const CubeFace& face : visible_cube_faces(right, up, away)) text += face.letter;
  return text;
}

TEST(OrientationCube, ShowsTheSideThatIsTurnedToTheEye) {
  const Vector3d left(1, 0, 0), back(0, 1, 0), up(0, 0, 1);
  EXPECT_EQ(letters(left, up, back), "A");    // from the front
  EXPECT_EQ(letters(-left, up, -back), "P");  // from behind
  EXPECT_EQ(letters(back, up, -left), "L");   // the left profile
  EXPECT_EQ(letters(-back, up, left), "R");   // the right profile
  EXPECT_EQ(letters(left, -back, -up), "S");  // from above
  EXPECT_EQ(letters(left, back, up), "I");    // from below
}

TEST(OrientationCube, FacesStandWhereTheSidesAre) {
  // From the front, the patient's left and above: A, L and S are seen, L to the right, S above.
  const Vector3d away = Vector3d(-1, 2, -1).normalized();
  const Vector3d right = away.cross(Vector3d(0, 0, 1)).normalized();
  const std::vector<CubeFace> faces = visible_cube_faces(right, right.cross(away), away);
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces[2].letter, 'A') << "the most frontal last";
  for (const CubeFace& face : faces) {
    if (face.letter == 'L') {
      EXPECT_GT(face.centre.x(), 0.3);
    }
    if (face.letter == 'S') {
      EXPECT_GT(face.centre.y(), 0.3);
    }
    if (face.letter == 'A') {
      EXPECT_LT(face.centre.x(), 0);
    }
    const Eigen::Vector2d mean =
        (face.corners[0] + face.corners[1] + face.corners[2] + face.corners[3]) / 4;
    EXPECT_LT((mean - face.centre).norm(), 1e-12);
  }
}

/// Pixels of the corner where the cube lies that are not the background's.
int marked(const Picture& with, const Picture& without, int x0, int y0, int x1, int y1) {
  int count = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const std::uint8_t *p = with.at(x, y), *q = without.at(x, y);
      if (std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) > 30) ++count;
    }
  }
  return count;
}

TEST_F(SceneTest, CubeIsInTheLowerLeftCornerOnly) {
  scene.set_face(head);
  const Picture without = front();
  OrientationCube cube;
  cube.attach(scene.renderer());
  const Picture with = front();
  EXPECT_GT(marked(with, without, 0, 190, 100, 300), 400);
  EXPECT_EQ(marked(with, without, 100, 0, 320, 320), 0);
  EXPECT_EQ(marked(with, without, 0, 0, 100, 190), 0);
  cube.set_visible(false);
  EXPECT_EQ(front(), without);
  cube.set_visible(true);
  cube.detach();
  EXPECT_EQ(front(), without);
}

TEST_F(SceneTest, CrosshairIsSeenThroughTheFaceAtItsPlace) {
  scene.set_face(head);
  const Picture without = front();
  CrosshairMark mark;
  mark.set_place({40, 0, 30});  // inside the head, to the patient's left, high
  mark.attach(scene.renderer());
  const Picture with = front();
  double x = 0, y = 0;
  int count = 0;
  for (int row = 0; row < 320; ++row) {
    for (int column = 0; column < 320; ++column) {
      if (std::abs(with.at(column, row)[0] - without.at(column, row)[0]) < 30) continue;
      x += column;
      y += row;
      ++count;
    }
  }
  ASSERT_GT(count, 20);
  scene.renderer()->SetWorldPoint(40, 0, 30, 1);
  scene.renderer()->WorldToView();
  double* view = scene.renderer()->GetViewPoint();
  EXPECT_NEAR(x / count, 160 * (1 + view[0]), 3);
  EXPECT_NEAR(y / count, 160 * (1 - view[1]), 3);
  EXPECT_GT(x / count, 170) << "the patient's left is on the picture's right";
}

}  // namespace
}  // namespace gnathion::test
