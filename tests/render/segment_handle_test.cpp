#include "render/segment_handle.h"

#include <cmath>
#include <utility>
#include <vector>

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "offscreen/osmesa_window.h"
#include "render/scene_fixture.h"
#include "render/turning_rings.h"

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
    handle.on_taken([this] { ++taken; });
    handle.on_moved([this](const Eigen::Vector3d& t) { moved.push_back(t); });
    handle.on_released([this](const Eigen::Vector3d& t) { released.push_back(t); });
    handle.on_turned([this](int axis, double degrees) { turned.emplace_back(axis, degrees); });
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
    interactor->SetEventInformation(at.x(), at.y(), 0, shift ? 1 : 0);
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
  std::vector<std::pair<int, double>> turned;
  int taken = 0;
  bool shift = false;
};

TEST_F(HandleTest, BallFollowsTheMouseInThePicturesPlane) {
  // The left profile: forward is the picture's left, up is up.
  const Eigen::Vector2i ten = pixel_of(home + Eigen::Vector3d(0, -10, 5)) - pixel_of(home);
  drag(home, ten);
  ASSERT_FALSE(moved.empty());
  ASSERT_EQ(released.size(), 1u);
  EXPECT_EQ(taken, 1);
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
  EXPECT_EQ(taken, 0);
  EXPECT_EQ(handle.translation(), Eigen::Vector3d::Zero());
}

TEST_F(HandleTest, BallIsAsLargeToTheEyeOnAScreenOfTwiceTheDots) {
  const auto yellow_pixels = [this] {
    window->Render();
    vtkNew<vtkUnsignedCharArray> rgb;
    constexpr int back_buffer = 0;
    window->GetPixelData(0, 0, side - 1, side - 1, back_buffer, rgb, 0);
    int count = 0;
    for (vtkIdType i = 0; i < rgb->GetNumberOfValues(); i += 3) {
      const unsigned char* p = rgb->GetPointer(i);
      count += p[0] > 150 && p[1] > 90 && p[2] < 60 ? 1 : 0;
    }
    return count;
  };
  const int plain = yellow_pixels();
  ASSERT_GT(plain, 50);
  handle.detach();
  window->SetDPI(144);
  handle.attach(interactor, scene.renderer());
  EXPECT_NEAR(yellow_pixels(), 4 * plain, 0.25 * 4 * plain);
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

// Inside the head, where only what is drawn in front can be seen and taken.
const Eigen::Vector3d pivot(0, -40, -40);

Eigen::Vector3d on_ring(int axis, double degrees) {
  const double angle = degrees * 3.14159265358979 / 180;
  Eigen::Vector3d p = pivot;
  p[(axis + 1) % 3] += TurningRings::radius * std::cos(angle);
  p[(axis + 2) % 3] += TurningRings::radius * std::sin(angle);
  return p;
}

TEST_F(HandleTest, RingSeenFromItsAxisTurnsWithTheMouse) {
  handle.set_pivot(pivot);
  window->Render();
  // The left profile looks along the pitch ring's axis.
  drag(on_ring(0, 145), pixel_of(on_ring(0, 175)) - pixel_of(on_ring(0, 145)));
  ASSERT_EQ(turned.size(), 10U);
  for (const auto& [axis, degrees] : turned) EXPECT_EQ(axis, 0);
  EXPECT_NEAR(turned.back().second, 30, 1);
  EXPECT_TRUE(moved.empty());
  ASSERT_EQ(released.size(), 1U);
  EXPECT_EQ(released[0], Eigen::Vector3d::Zero());
}

TEST_F(HandleTest, RingSeenFromItsEdgeTurnsAsItsPointUnderTheMouse) {
  handle.set_pivot(pivot);
  window->Render();
  // The yaw ring is a level line, its left side nearest to the eye: there back is the picture's
  // right. Away from the roll ring, which crosses it in the middle.
  const Eigen::Vector2i back = pixel_of(on_ring(2, 45)) - pixel_of(on_ring(2, 35));
  drag(on_ring(2, 35), back);
  ASSERT_FALSE(turned.empty());
  EXPECT_EQ(turned.back().first, 2);
  EXPECT_NEAR(turned.back().second, 9.3, 1.5);
}

TEST_F(HandleTest, RingsStayTakenForMoreThanAHalfTurn) {
  handle.set_pivot(pivot);
  window->Render();
  mouse(vtkCommand::MouseMoveEvent, pixel_of(on_ring(0, 200)));
  mouse(vtkCommand::LeftButtonPressEvent, pixel_of(on_ring(0, 200)));
  for (int degrees = 200; degrees <= 200 + 270; degrees += 15) {
    mouse(vtkCommand::MouseMoveEvent, pixel_of(on_ring(0, degrees)));
  }
  EXPECT_TRUE(handle.is_held());
  mouse(vtkCommand::LeftButtonReleaseEvent, pixel_of(on_ring(0, 470)));
  EXPECT_FALSE(handle.is_held());
  EXPECT_NEAR(turned.back().second, 270, 1.5);
}

TEST_F(HandleTest, RingsAreSeenThroughTheHeadAndGoWithTheSegment) {
  const auto ring_pixels = [&](const Eigen::Vector3d& at) {
    window->Render();
    return pixel_of(at);
  };
  handle.set_pivot(pivot);
  handle.set_translation({0, -8, 0});
  drag(on_ring(0, 145) + Eigen::Vector3d(0, -8, 0),
       ring_pixels(on_ring(0, 165)) - ring_pixels(on_ring(0, 145)));
  ASSERT_FALSE(turned.empty());
  EXPECT_NEAR(turned.back().second, 20, 1);
  // Where it was there is none any more.
  turned.clear();
  drag(on_ring(0, 145), {10, 0});
  EXPECT_TRUE(turned.empty());
}

TEST_F(HandleTest, LockKeepsBallAndRingsToOneAxis) {
  handle.set_pivot(pivot);
  handle.set_axis_lock(2);
  const Eigen::Vector2i ten = pixel_of(home + Eigen::Vector3d(0, -10, 5)) - pixel_of(home);
  drag(home, ten);
  ASSERT_EQ(released.size(), 1U);
  EXPECT_NEAR(released[0].y(), 0, 1e-6);
  EXPECT_NEAR(released[0].z(), 5, 1);
  // Neither the pitch ring nor the forward grip is there.
  const std::size_t moves = moved.size();
  drag(on_ring(0, 135) + handle.translation(), {10, 0});
  drag(home + handle.translation() + Eigen::Vector3d(0, -16, 0), {10, 0});
  EXPECT_TRUE(turned.empty());
  EXPECT_EQ(moved.size(), moves);
  handle.set_axis_lock({});
  drag(home + handle.translation(), ten);
  EXPECT_LT(released.back().y(), -5);
}

TEST_F(HandleTest, ModifiersLeaveTheRingsToTheCamera) {
  handle.set_pivot(pivot);
  window->Render();
  shift = true;
  drag(on_ring(0, 145), {10, 10});
  shift = false;
  EXPECT_TRUE(turned.empty());
  scene.look_from(CameraPreset::left, 1);  // the drag has moved the camera
  handle.set_pivot({});
  drag(on_ring(0, 145), {10, 10});
  EXPECT_TRUE(turned.empty());
}

}  // namespace
}  // namespace gnathion::test
