#include "render/turning_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <Eigen/Geometry>

#include "render/grip_colours.h"
#include "render/in_front.h"
#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int corners = 96;           // of a ring
constexpr double near_pixels = 7;     // of the mouse to a ring, at 96 dots per inch
constexpr float priority = 0.3F;      // after the balls (0.5), before the camera (0)
constexpr double least_facing = 0.3;  // below, a ring is seen too much from its edge to be traced

Vector3d ring_point(int axis, double angle) {
  Vector3d p = Vector3d::Zero();
  p[(axis + 1) % 3] = TurningRings::radius * std::cos(angle);
  p[(axis + 2) % 3] = TurningRings::radius * std::sin(angle);
  return p;
}

double corner_angle(int corner) {
  return 2 * std::numbers::pi * corner / corners;
}

void draw_ring(int axis, vtkPolyData* data) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(corners + 1);
  for (int i = 0; i < corners; ++i) {
    points->InsertNextPoint(ring_point(axis, corner_angle(i)).data());
    line->InsertCellPoint(i);
  }
  line->InsertCellPoint(0);
  data->SetPoints(points);
  data->SetLines(line);
}

}  // namespace

struct TurningRings::Impl {
  struct Ring {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkActor> actor;
  };
  /// A place on a ring.
  struct Hold {
    int axis;
    double angle;  ///< radians
  };

  std::array<Ring, 3> rings;
  vtkNew<vtkCallbackCommand> command;
  vtkRenderWindowInteractor* interactor = nullptr;
  vtkRenderer* renderer = nullptr;
  double ratio = 1;  ///< pixels a logical one
  bool visible = true;
  std::optional<int> lock;
  Vector3d centre = Vector3d::Zero();
  std::optional<int> hovered;
  std::optional<Hold> held;
  Vector2d press = Vector2d::Zero();
  double turned = 0;      // radians since the press
  double last_angle = 0;  // of the mouse on the ring's plane
  Listener on_turned;
  std::function<void()> on_taken, on_released;

  Impl() {
    for (int axis = 0; axis < 3; ++axis) {
      Ring& ring = rings[static_cast<std::size_t>(axis)];
      draw_ring(axis, ring.data);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(ring.data);
      ring.actor->SetMapper(mapper);
      ring.actor->PickableOff();
      ring.actor->GetProperty()->LightingOff();
      allow_in_front(ring.actor);
    }
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long event, void* client, void*) {
      static_cast<Impl*>(client)->hear(event);
    });
    show();
  }

  bool is_there(int axis) const { return visible && (!lock || *lock == axis); }

  void show() {
    for (int axis = 0; axis < 3; ++axis) {
      Ring& ring = rings[static_cast<std::size_t>(axis)];
      const bool bright = held ? held->axis == axis : hovered == axis;
      const Vector3d colour = bright ? Vector3d(1, 1, 1) : axis_colour(axis);
      ring.actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
      ring.actor->GetProperty()->SetLineWidth(static_cast<float>(ratio * (bright ? 5 : 3)));
      ring.actor->SetVisibility(is_there(axis) && (!held || held->axis == axis));
      ring.actor->SetPosition(centre.x(), centre.y(), centre.z());
    }
  }

  Vector2d mouse() const {
    return {interactor->GetEventPosition()[0], interactor->GetEventPosition()[1]};
  }

  /// Pixels and depth of a point in the picture.
  Vector3d display(const Vector3d& point) const {
    renderer->SetWorldPoint(point.x(), point.y(), point.z(), 1);
    renderer->WorldToDisplay();
    return Vector3d(renderer->GetDisplayPoint());
  }

  Vector3d world(const Vector2d& pixel, double depth) const {
    renderer->SetDisplayPoint(pixel.x(), pixel.y(), depth);
    renderer->DisplayToWorld();
    const double* p = renderer->GetWorldPoint();
    return Vector3d(p[0], p[1], p[2]) / p[3];
  }

  /// The ring under the mouse; of several the nearest to the eye.
  std::optional<Hold> ring_at(const Vector2d& pixel) const {
    const double reach = near_pixels * ratio;
    std::optional<Hold> best;
    double depth = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      if (!is_there(axis)) continue;
      // Corners are a few pixels apart.
      for (int i = 0; i < corners; ++i) {
        const Vector3d at = display(centre + ring_point(axis, corner_angle(i)));
        if ((at.head<2>() - pixel).norm() > reach || at.z() >= depth) continue;
        depth = at.z();
        best = Hold{axis, corner_angle(i)};
      }
    }
    return best;
  }

  Vector3d line_of_sight() const {
    return Vector3d(renderer->GetActiveCamera()->GetDirectionOfProjection());
  }
  bool is_traced() const { return std::abs(line_of_sight()[held->axis]) > least_facing; }

  /// Where on the held ring's plane the mouse points to.
  double angle_on_plane(const Vector2d& pixel) const {
    const int axis = held->axis;
    const Vector3d near = world(pixel, 0), far = world(pixel, 1);
    const double t = (centre[axis] - near[axis]) / (far[axis] - near[axis]);
    const Vector3d at = near + t * (far - near) - centre;
    return std::atan2(at[(axis + 2) % 3], at[(axis + 1) % 3]);
  }

  /// A ring seen from its edge turns by as much as its point under the mouse would move along.
  double angle_along_edge(const Vector2d& pixel) const {
    constexpr double small = 0.01;  // radians
    const Vector3d from = display(centre + ring_point(held->axis, held->angle - small));
    const Vector3d to = display(centre + ring_point(held->axis, held->angle + small));
    const Vector2d pixels_a_radian = (to - from).head<2>() / (2 * small);
    return (pixel - press).dot(pixels_a_radian) / std::max(pixels_a_radian.squaredNorm(), 1.0);
  }

  void drag() {
    if (is_traced()) {
      const double angle = angle_on_plane(mouse());
      turned += std::remainder(angle - last_angle, 2 * std::numbers::pi);
      last_angle = angle;
    } else {
      turned = angle_along_edge(mouse());
    }
    if (on_turned) on_turned(held->axis, turned * 180 / std::numbers::pi);
    interactor->Render();
  }

  void hear(unsigned long event) {
    command->SetAbortFlag(0);
    if (!visible) return;
    if (event == vtkCommand::LeftButtonPressEvent) {
      take();
    } else if (event == vtkCommand::LeftButtonReleaseEvent) {
      release();
    } else if (held) {
      command->SetAbortFlag(1);
      drag();
    } else {
      hover();
    }
  }

  void take() {
    // With a modifier the left button is the camera's.
    if (interactor->GetShiftKey() || interactor->GetControlKey()) return;
    held = ring_at(mouse());
    if (!held) return;
    command->SetAbortFlag(1);
    press = mouse();
    turned = 0;
    last_angle = is_traced() ? angle_on_plane(press) : 0;
    show();
    if (on_taken) on_taken();
    interactor->Render();
  }

  void release() {
    if (!held) return;
    command->SetAbortFlag(1);
    held.reset();
    show();
    if (on_released) on_released();
    interactor->Render();
  }

  void hover() {
    const std::optional<Hold> ring = ring_at(mouse());
    const std::optional<int> axis = ring ? std::optional<int>(ring->axis) : std::nullopt;
    if (axis == hovered) return;
    hovered = axis;
    show();
    interactor->Render();
  }
};

TurningRings::TurningRings() : impl_(std::make_unique<Impl>()) {}

TurningRings::~TurningRings() {
  detach();
}

void TurningRings::attach(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer) {
  detach();
  impl_->interactor = interactor;
  impl_->renderer = renderer;
  impl_->ratio = pixel_ratio(renderer);
  impl_->show();
  for (Impl::Ring& ring : impl_->rings) renderer->AddActor(ring.actor);
  for (const auto event : {vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
                           vtkCommand::MouseMoveEvent}) {
    interactor->AddObserver(event, impl_->command, priority);
  }
}

void TurningRings::detach() {
  if (impl_->interactor == nullptr) return;
  impl_->interactor->RemoveObserver(impl_->command);
  for (Impl::Ring& ring : impl_->rings) impl_->renderer->RemoveActor(ring.actor);
  impl_->interactor = nullptr;
  impl_->renderer = nullptr;
  impl_->held.reset();
  impl_->hovered.reset();
}

void TurningRings::set_visible(bool visible) {
  if (!visible) {
    impl_->held.reset();
    impl_->hovered.reset();
  }
  impl_->visible = visible;
  impl_->show();
}

void TurningRings::set_centre(const Vector3d& centre) {
  impl_->centre = centre;
  impl_->show();
}

void TurningRings::set_axis_lock(std::optional<int> axis) {
  impl_->lock = axis;
  impl_->show();
}

bool TurningRings::is_held() const {
  return impl_->held.has_value();
}

void TurningRings::on_taken(std::function<void()> listener) {
  impl_->on_taken = std::move(listener);
}

void TurningRings::on_turned(Listener listener) {
  impl_->on_turned = std::move(listener);
}

void TurningRings::on_released(std::function<void()> listener) {
  impl_->on_released = std::move(listener);
}

}  // namespace gnathion
