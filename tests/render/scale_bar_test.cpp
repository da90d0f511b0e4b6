#include "render/scale_bar.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <cmath>

#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

TEST(ScaleBar, IsTheLongestRoundLengthThatFits) {
  EXPECT_EQ(scale_bar_mm(1, 100), 100);
  EXPECT_EQ(scale_bar_mm(1, 99), 50);
  EXPECT_EQ(scale_bar_mm(2, 99), 20);
  EXPECT_EQ(scale_bar_mm(10, 99), 5);
  EXPECT_NEAR(scale_bar_mm(100, 70), 0.5, 1e-12);
  for (double scale = 0.1; scale < 100; scale *= 1.07) {
    const double pixels = scale * scale_bar_mm(scale, 80);
    EXPECT_LE(pixels, 80 + 1e-9);
    EXPECT_GT(pixels, 80 / 2.5 - 1e-9);
  }
  EXPECT_EQ(scale_bar_words(50), "50 mm");
  EXPECT_EQ(scale_bar_words(0.5), "0.5 mm");
}

/// Columns of the bar, which is darker than what it lies on, in the rows of its line.
int bar_length(const Picture& with, const Picture& without) {
  int longest = 0;
  for (int y = with.height - 30; y < with.height; ++y) {
    int run = 0;
    for (int x = 0; x < with.width; ++x) {
      run = with.at(x, y)[0] + 40 < without.at(x, y)[0] ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

TEST_F(SceneTest, BarIsAsLongAsItSaysAtTheDepthOfTheFocus) {
  scene.set_face(head);
  const Picture without = front();
  ScaleBar bar;
  bar.attach(scene.renderer());
  const Picture with = front();
  // How far apart two points at the focus, a mm from each other, fall on the picture.
  const Eigen::Vector3d focus(scene.renderer()->GetActiveCamera()->GetFocalPoint());
  double columns[2];
  for (int end = 0; end < 2; ++end) {
    scene.renderer()->SetWorldPoint(focus.x() + end, focus.y(), focus.z(), 1);
    scene.renderer()->WorldToView();
    columns[end] = 160 * (1 + scene.renderer()->GetViewPoint()[0]);
  }
  const double pixels = columns[1] - columns[0];
  EXPECT_NEAR(bar_length(with, without), pixels * scale_bar_mm(pixels, 0.25 * 320), 3);
  bar.detach();
  EXPECT_EQ(front(), without);
}

}  // namespace
}  // namespace gnathion::test
