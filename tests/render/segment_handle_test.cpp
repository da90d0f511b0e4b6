#include "render/segment_handle.h"

#include <vector>

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "offscreen/osmesa_window.h"
#include "render/scene_fixture.h"

namespace gnathion::test {
namespace {

constexpr int side = 400;

/// A window in memory with mouse events, the head from its left side, and a handle before its chin.
class HandleTest : public SceneTest {
 protected:
  HandleTest() {
    scene.set_face(head);
    scene.look_from(CameraPreset::left, 1);
    window->SetSize(side, side);
    window->AddRenderer(scene.renderer());
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(style);
    interactor->Initialize();
    handle.set_home(home);
    handle.attach(interactor, scene.renderer());
    handle.on_moved([this](const Eigen::Vector3d& t) { moved.push_back(t); });
    handle.on_released([this](const Eigen::Vector3d& t) { released.push_back(t); });
    window->Render();
  }
  ~HandleTest() override {
    handle.detach();
    window->RemoveRenderer(scene.renderer());
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

  void drag(const Eigen::Vector3d& from, const Eigen::Vector2i& by) {
    const Eigen::Vector2i start = pixel_of(from);
    mouse(vtkCommand::MouseMoveEvent, start);
    mouse(vtkCommand::LeftButtonPressEvent, start);
    for (int step = 1; step <= 10; ++step) {
      mouse(vtkCommand::MouseMoveEvent, start + by * step / 10);
    }
    mouse(vtkCommand::LeftButtonReleaseEvent, start + by);
  }

  const Eigen::Vector3d home{0, -120, -60};
  vtkNew<OsmesaWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  SegmentHandle handle;
  std::vector<Eigen::Vector3d> moved, released;
};

TEST_F(HandleTest, BallFollowsTheMouseInThePicturesPlane) {
  // The left profile: forward is the picture's left, up is up.
  const Eigen::Vector2i ten = pixel_of(home + Eigen::Vector3d(0, -10, 5)) - pixel_of(home);
  drag(home, ten);
  ASSERT_FALSE(moved.empty());
  ASSERT_EQ(released.size(), 1u);
  EXPECT_EQ(released[0], handle.translation());
  EXPECT_NEAR(released[0].x(), 0, 0.1);
  EXPECT_NEAR(released[0].y(), -10, 1);
  EXPECT_NEAR(released[0].z(), 5, 1);
}

TEST_F(HandleTest, OneAxisGripKeepsToItsAxis) {
  const Eigen::Vector2i ten = pixel_of(home + Eigen::Vector3d(0, -10, 5)) - pixel_of(home);
  drag(home + Eigen::Vector3d(0, -16, 0), ten);  // the forward grip
  ASSERT_EQ(released.size(), 1u);
  EXPECT_NEAR(released[0].x(), 0, 1e-6);
  EXPECT_NEAR(released[0].y(), -10, 1);
  EXPECT_NEAR(released[0].z(), 0, 1e-6);
}

TEST_F(HandleTest, SecondDragGoesOnFromTheFirst) {
  const Eigen::Vector2i up = pixel_of(home + Eigen::Vector3d(0, 0, 6)) - pixel_of(home);
  drag(home, up);
  window->Render();
  drag(home + handle.translation(), up);
  EXPECT_NEAR(handle.translation().z(), 12, 1.5);
  EXPECT_EQ(released.size(), 2u);
}

TEST_F(HandleTest, SettingTheTranslationCallsNobody) {
  handle.set_translation({1, 2, 3});
  handle.set_home({0, -130, -60});
  EXPECT_EQ(handle.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(moved.empty());
  EXPECT_TRUE(released.empty());
}

TEST_F(HandleTest, MouseBesideTheHandleTurnsTheCameraOnly) {
  drag(Eigen::Vector3d(0, 0, 40), {40, 10});
  EXPECT_TRUE(moved.empty());
  EXPECT_EQ(handle.translation(), Eigen::Vector3d::Zero());
}

TEST_F(HandleTest, HiddenOrDetachedHandleTakesNoEvents) {
  handle.set_visible(false);
  drag(home, {30, 0});
  handle.set_visible(true);
  handle.detach();
  EXPECT_FALSE(handle.is_attached());
  drag(home, {30, 0});
  EXPECT_TRUE(moved.empty());
}

}  // namespace
}  // namespace gnathion::test
