#include "offscreen/offscreen.h"

#include "base/error.h"
#include "offscreen/comparison_pictures.h"
#include "render/baseline.h"
#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

ErrorKind kind_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return ErrorKind::usage;
}

TEST_F(SceneTest, SamePixelsEveryTime) {
  scene.set_face(head);
  scene.set_label("Before");
  const Picture first = front();
  EXPECT_EQ(front(), first);  // a new window
  OffscreenRenderer renderer;
  EXPECT_EQ(renderer.render(scene, 320, 320), first);
  FaceScene again;
  again.set_face(head);
  again.set_label("Before");
  EXPECT_EQ(render_picture(again, CameraPreset::front, 320, 320), first);
}

TEST_F(SceneTest, OneRendererDrawsManyScenesAndSizes) {
  scene.set_face(head);
  FaceScene bone;
  bone.set_bone("skull", ellipsoid({0, 0, 0}, {60, 60, 60}), skull_look);
  OffscreenRenderer renderer;
  scene.look_from(CameraPreset::front, 1);
  bone.look_from(CameraPreset::front, 1);
  const Picture first = renderer.render(scene, 160, 160);
  const Picture other = renderer.render(bone, 200, 120);
  EXPECT_EQ(other.width, 200);
  EXPECT_EQ(other.height, 120);
  EXPECT_EQ(other.rgb.size(), 3u * 200 * 120);
  EXPECT_EQ(renderer.render(scene, 160, 160), first);
}

TEST_F(SceneTest, PngHoldsThePixels) {
  scene.set_face(head);
  write_png(scene, CameraPreset::front, 320, 320, folder / "out.png");
  EXPECT_EQ(read_picture_file(folder / "out.png"), front());
}

TEST_F(SceneTest, PictureThatCannotBeWrittenIsAnOutputErrorWithItsName) {
  scene.set_face(head);
  const auto path = folder / "no such folder" / "out.png";
  try {
    write_png(scene, CameraPreset::front, 32, 32, path);
    FAIL() << "written into a folder that does not exist";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::output);
    EXPECT_EQ(error.subject(), path.string());
  }
}

TEST_F(SceneTest, SizesOutOfRangeAreRefused) {
  OffscreenRenderer renderer;
  EXPECT_EQ(kind_of([&] { renderer.render(scene, 0, 10); }), ErrorKind::output);
  EXPECT_EQ(kind_of([&] { renderer.render(scene, 10, 100000); }), ErrorKind::output);
}

TEST_F(SceneTest, ComparisonWritesEveryPictureAndLeavesThePredictedFace) {
  scene.set_face(head);
  scene.set_bone("skull", ellipsoid({0, 8, 25}, {62, 78, 78}), skull_look);
  scene.set_bone("segment", ellipsoid({0, -35, -62}, {38, 36, 18}), segment_look);
  Points after = head.surface.vertices;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(after.rows());
  for (Eigen::Index i = 0; i < after.rows(); ++i) {
    const Eigen::RowVector3d from_chin = after.row(i) - Eigen::RowVector3d(0, -75, -60);
    change(i) = 10 * std::exp(-from_chin.squaredNorm() / 1500);
    after(i, 1) -= change(i);
  }
  ComparisonOptions options;
  options.width = options.height = 240;
  options.summary_side = 160;
  options.summary_views = {CameraPreset::left};
  const ComparisonFiles files =
      write_comparison(scene, head.surface.vertices, after, change, folder, options);
  const Picture before = read_picture_file(files.before),
                predicted = read_picture_file(files.after);
  EXPECT_EQ(before.width, 240);
  EXPECT_GT(difference(before, predicted).mean, 0.2);
  EXPECT_GT(difference(predicted, read_picture_file(files.colour_map)).mean, 2);
  EXPECT_GT(difference(predicted, read_picture_file(files.plan)).mean, 2);
  const Picture summary = read_picture_file(files.summary);
  EXPECT_EQ(summary.width, 4 * 160 + 3 * 2);
  EXPECT_EQ(summary.height, 160);
  EXPECT_TRUE(matches_baseline(summary, "summary_left"));

  scene.remove_bones();
  FaceScene fresh;
  TexturedMesh moved = head;
  moved.surface.vertices = after;
  fresh.set_face(moved);
  EXPECT_EQ(front(), render_picture(fresh, CameraPreset::front, 320, 320));
}

TEST(Tiled, RefusesRaggedRowsAndOtherSizes) {
  const Picture a{2, 1, std::vector<std::uint8_t>(6, 7)}, b{1, 2, std::vector<std::uint8_t>(6, 7)};
  EXPECT_THROW(tiled({}), std::invalid_argument);
  EXPECT_THROW(tiled({{a, a}, {a}}), std::invalid_argument);
  EXPECT_THROW(tiled({{a, b}}), std::invalid_argument);
  const Picture two = tiled({{a}, {a}}, 1);
  EXPECT_EQ(two.width, 2);
  EXPECT_EQ(two.height, 3);
  EXPECT_EQ(two.at(0, 0)[0], 7);
  EXPECT_EQ(two.at(0, 1)[0], 255);
  EXPECT_EQ(two.at(1, 2)[2], 7);
}

}  // namespace
}  // namespace gnathion::test
