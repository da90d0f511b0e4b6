#include "render/cut_handle.h"

#include <vector>

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "bone/cut_box.h"
#include "offscreen/osmesa_window.h"
#include "render/cut_preview.h"
#include "render/scene_fixture.h"
#include "support/solids.h"

namespace gnathion::test {
namespace {

constexpr int side = 400;

/// A window in memory with mouse events, a bone from its left side, and a cut placed on it.
class CutHandleTest : public SceneTest {
 protected:
  CutHandleTest() {
    scene.set_bone("bone", bone, skull_look);
    scene.look_from(CameraPreset::left, 1);
    window->SetSize(side, side);
    window->AddRenderer(scene.renderer());
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(style);
    interactor->Initialize();
    handle.on_changed([this](const BoundedCut& cut) { changed.push_back(box_of(cut)); });
    handle.on_released([this](const BoundedCut&) { ++released; });
  }
  ~CutHandleTest() override {
    handle.detach();
    layer.detach();
    window->RemoveRenderer(scene.renderer());
  }

  void show(const BoundedCut& cut) {
    handle.set_cut(cut);
    handle.attach(interactor, scene.renderer());
    window->Render();
  }
  Eigen::Vector2i pixel_of(const Eigen::Vector3d& point) {
    vtkRenderer* renderer = scene.renderer();
    renderer->SetWorldPoint(point.x(), point.y(), point.z(), 1);
    renderer->WorldToDisplay();
    const double* display = renderer->GetDisplayPoint();
    return {static_cast<int>(display[0]), static_cast<int>(display[1])};
  }
  void mouse(unsigned long event, const Eigen::Vector2i& at) {
    interactor->SetEventInformation(at.x(), at.y());
    interactor->InvokeEvent(event);
  }
  void drag(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector2i start = pixel_of(from), end = pixel_of(to);
    mouse(vtkCommand::MouseMoveEvent, start);
    mouse(vtkCommand::LeftButtonPressEvent, start);
    for (int step = 1; step <= 10; ++step) {
      mouse(vtkCommand::MouseMoveEvent, start + (end - start) * step / 10);
    }
    mouse(vtkCommand::LeftButtonReleaseEvent, end);
  }

  const TriangleMesh bone = box({0, 0, 0}, {40, 60, 60}, 12);
  vtkNew<OsmesaWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  CutHandle handle;
  CutPreviewLayer layer;
  std::vector<BoxCut> changed;
  int released = 0;
};

TEST_F(CutHandleTest, YellowBallMovesTheBox) {
  show(box_between({-30, -40, -20}, {30, 40, 20}));
  const Eigen::Vector3d ball(0, -40 - 14, 0);
  drag(ball, ball + Eigen::Vector3d(0, -8, 6));
  ASSERT_FALSE(changed.empty());
  EXPECT_EQ(released, 1);
  EXPECT_LT((changed.back().centre - Eigen::Vector3d(0, -8, 6)).norm(), 1.5);
  EXPECT_EQ(changed.back().half_extents, Eigen::Vector3d(30, 40, 20));
  EXPECT_EQ(box_of(handle.cut()), changed.back());
}

TEST_F(CutHandleTest, WhiteBallMovesOneSideOnly) {
  show(box_between({-30, -40, -20}, {30, 40, 20}));
  const Eigen::Vector3d top(0, -40, 20);  // at the front edge of the upper side
  drag(top, top + Eigen::Vector3d(0, 5, 10));
  ASSERT_FALSE(changed.empty());
  const BoxCut& box = changed.back();
  EXPECT_NEAR(box.centre.z() - box.half_extents.z(), -20, 1e-9);
  EXPECT_NEAR(box.centre.z() + box.half_extents.z(), 30, 1.5);
  EXPECT_EQ(box.half_extents.head<2>(), Eigen::Vector2d(30, 40));
  // It cannot be pushed through the other side.
  drag({0, -40, box.centre.z() + box.half_extents.z()}, {0, -40, -55});
  EXPECT_NEAR(changed.back().half_extents.z(), 1, 1e-9);
}

TEST_F(CutHandleTest, GreenBallTurnsTheBladeWithItsSeed) {
  PlateCut blade;
  blade.half_width = 30;
  blade.half_height = 50;
  blade.seed = {0, 0, -10};
  show(blade);
  const Eigen::Vector3d corner(30, -35, 0);  // the left one, behind the front
  drag(corner, corner + Eigen::Vector3d(0, 0, 12));
  ASSERT_FALSE(changed.empty());
  const auto turned = std::get<PlateCut>(handle.cut());
  EXPECT_LT(turned.centre.norm(), 1e-9);
  EXPECT_LT(turned.normal.normalized().z(), 0.995);
  EXPECT_LT(
      (changed.back().axes.transpose() * changed.back().axes - Eigen::Matrix3d::Identity()).norm(),
      1e-9);
  EXPECT_NEAR(turned.seed.dot(turned.normal.normalized()), -10, 1e-9);
}

TEST_F(CutHandleTest, SettingTheCutCallsNobodyAndDetachedBallsHearNothing) {
  show(box_between({-30, -40, -20}, {30, 40, 20}));
  handle.set_cut(box_between({-20, -40, -20}, {20, 40, 20}));
  EXPECT_TRUE(changed.empty());
  handle.detach();
  EXPECT_FALSE(handle.is_attached());
  drag({0, -54, 0}, {0, -54, 20});
  EXPECT_TRUE(changed.empty());
}

TEST_F(CutHandleTest, PreviewColoursThePartsOfTheBone) {
  scene.set_orientation_letters(false);
  layer.attach(scene.renderer());
  layer.set_bone(bone, {});
  scene.set_bone_drawn("bone", false);
  std::vector<std::uint8_t> part(static_cast<std::size_t>(bone.triangles.rows()), 0);
  for (std::size_t t = 0; t < part.size(); ++t) {
    const auto corners = bone.triangles.row(static_cast<Eigen::Index>(t));
    if (bone.vertices(corners, 1).mean() < -20) part[t] = 1;
  }
  Points colours(2, 3);
  colours << 0.9, 0.9, 0.9, 0.9, 0.1, 0.1;
  layer.set_parts(part, colours);
  OffscreenRenderer renderer;
  window->RemoveRenderer(scene.renderer());
  scene.look_from(CameraPreset::left, 1);
  const Picture picture = renderer.render(scene, 200, 200);
  window->AddRenderer(scene.renderer());
  const auto is_red = [](const std::uint8_t* p) { return p[0] > 90 && p[1] < 60; };
  const auto is_white = [](const std::uint8_t* p) {
    return p[0] > 90 && p[1] > 90 && std::abs(p[0] - p[2]) < 12;
  };
  // In the left profile the front is at the picture's left.
  EXPECT_LT(mean_column(picture, is_red), mean_column(picture, is_white));
  EXPECT_TRUE(is_red(picture.at(40, 100)));
}

}  // namespace
}  // namespace gnathion::test
