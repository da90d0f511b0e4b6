#include "render/segment_handle.h"

#include <algorithm>
#include <array>
#include <utility>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkHandleWidget.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereHandleRepresentation.h>

#include "render/grip_colours.h"
#include "render/pixel_ratio.h"
#include "render/turning_rings.h"

namespace gnathion {
namespace {

constexpr double stalk = 16;  // mm from the ball to a one-axis grip

struct GripKind {
  Eigen::Vector3d offset;  // from the ball, mm, LPS
  int axis;                // the only one it moves along, −1: free
  double pixels;           // size on the screen
  Eigen::Vector3d colour;
};

const std::array<GripKind, 4> grip_kinds{{
    {{0, 0, 0}, -1, 16, {0.98, 0.72, 0.15}},
    {{stalk, 0, 0}, 0, 10, axis_colour(0)},
    {{0, -stalk, 0}, 1, 10, axis_colour(1)},
    {{0, 0, stalk}, 2, 10, axis_colour(2)},
}};

void colour_grip(vtkProperty* property, const Eigen::Vector3d& rgb) {
  property->SetColor(rgb.x(), rgb.y(), rgb.z());
  property->SetAmbient(0.35);
  property->SetDiffuse(0.75);
  property->SetSpecular(0.2);
}

}  // namespace

struct SegmentHandle::Impl {
  struct Grip {
    vtkNew<vtkHandleWidget> widget;
    vtkNew<vtkSphereHandleRepresentation> ball;
    vtkNew<vtkLineSource> line;
    vtkNew<vtkActor> line_actor;
    vtkNew<vtkCallbackCommand> command;
    Impl* owner = nullptr;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    int axis = -1;
  };

  std::array<Grip, 4> grips;
  TurningRings rings;
  vtkRenderer* renderer = nullptr;
  bool visible = true;
  Eigen::Vector3d home = Eigen::Vector3d::Zero();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> pivot;
  std::optional<int> lock;
  std::function<void()> taken;
  Listener moved;
  Listener released;

  Impl() {
    for (size_t i = 0; i < grips.size(); ++i) set_up(grips[i], grip_kinds[i]);
    set_size(1);
    rings.on_released([this] {
      if (released) released(translation);
    });
    place();
  }

  void set_up(Grip& grip, const GripKind& kind) {
    grip.owner = this;
    grip.offset = kind.offset;
    grip.axis = kind.axis;
    grip.ball->SetTranslationAxis(kind.axis);
    colour_grip(grip.ball->GetProperty(), kind.colour);
    colour_grip(grip.ball->GetSelectedProperty(), Eigen::Vector3d::Ones());
    grip.widget->SetRepresentation(grip.ball);
    grip.widget->SetAllowHandleResize(0);
    grip.widget->SetEnableAxisConstraint(0);  // Shift belongs to the camera
    grip.command->SetClientData(&grip);
    grip.command->SetCallback(&Impl::hear);
    grip.widget->AddObserver(vtkCommand::StartInteractionEvent, grip.command);
    grip.widget->AddObserver(vtkCommand::InteractionEvent, grip.command);
    grip.widget->AddObserver(vtkCommand::EndInteractionEvent, grip.command);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(grip.line->GetOutputPort());
    grip.line_actor->SetMapper(mapper);
    grip.line_actor->PickableOff();
    colour_grip(grip.line_actor->GetProperty(), kind.colour);
    grip.line_actor->GetProperty()->LightingOff();
  }

  void set_size(double pixel_ratio) {
    for (size_t i = 0; i < grips.size(); ++i) {
      grips[i].ball->SetHandleSize(pixel_ratio * grip_kinds[i].pixels);
      grips[i].line_actor->GetProperty()->SetLineWidth(static_cast<float>(2 * pixel_ratio));
    }
  }

  static void hear(vtkObject*, unsigned long event, void* client, void*) {
    auto& grip = *static_cast<Grip*>(client);
    Impl& self = *grip.owner;
    if (event == vtkCommand::StartInteractionEvent) {
      if (self.taken) self.taken();
      return;
    }
    const Eigen::Vector3d at(grip.ball->GetWorldPosition());
    self.translation = at - grip.offset - self.home;
    self.place();
    const Listener& listener =
        event == vtkCommand::EndInteractionEvent ? self.released : self.moved;
    if (listener) listener(self.translation);
  }

  void place() {
    Eigen::Vector3d centre = home + translation;
    for (Grip& grip : grips) {
      Eigen::Vector3d tip = centre + grip.offset;
      grip.ball->SetWorldPosition(tip.data());
      grip.line->SetPoint1(centre.data());
      grip.line->SetPoint2(tip.data());
    }
    if (pivot) rings.set_centre(*pivot + translation);
  }

  bool is_there(const Grip& grip) const {
    return visible && (!lock || grip.axis == -1 || grip.axis == *lock);
  }

  void refresh() {
    if (!renderer) return;
    for (Grip& grip : grips) {
      grip.widget->SetEnabled(is_there(grip) ? 1 : 0);
      grip.line_actor->SetVisibility(is_there(grip));
    }
    rings.set_visible(visible && pivot);
  }
};

SegmentHandle::SegmentHandle() : impl_(std::make_unique<Impl>()) {}

SegmentHandle::~SegmentHandle() {
  detach();
}

void SegmentHandle::attach(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  impl_->set_size(pixel_ratio(renderer));
  for (Impl::Grip& grip : impl_->grips) {
    renderer->AddActor(grip.line_actor);
    grip.widget->SetInteractor(interactor);
    grip.widget->SetDefaultRenderer(renderer);
  }
  impl_->rings.attach(interactor, renderer);
  impl_->refresh();
}

void SegmentHandle::detach() {
  if (!impl_->renderer) return;
  impl_->rings.detach();
  for (Impl::Grip& grip : impl_->grips) {
    grip.widget->SetEnabled(0);
    grip.widget->SetInteractor(nullptr);
    impl_->renderer->RemoveActor(grip.line_actor);
  }
  impl_->renderer = nullptr;
}

bool SegmentHandle::is_attached() const {
  return impl_->renderer != nullptr;
}

void SegmentHandle::set_visible(bool visible) {
  impl_->visible = visible;
  impl_->refresh();
}

void SegmentHandle::set_home(const Eigen::Vector3d& position) {
  impl_->home = position;
  impl_->place();
}

void SegmentHandle::set_translation(const Eigen::Vector3d& translation) {
  impl_->translation = translation;
  impl_->place();
}

Eigen::Vector3d SegmentHandle::translation() const {
  return impl_->translation;
}

void SegmentHandle::set_pivot(const std::optional<Eigen::Vector3d>& pivot) {
  impl_->pivot = pivot;
  impl_->place();
  impl_->refresh();
}

void SegmentHandle::set_axis_lock(std::optional<int> axis) {
  impl_->lock = axis;
  impl_->grips[0].ball->SetTranslationAxis(axis.value_or(-1));
  impl_->rings.set_axis_lock(axis);
  impl_->refresh();
}

bool SegmentHandle::is_held() const {
  if (impl_->rings.is_held()) return true;
  return std::any_of(impl_->grips.begin(), impl_->grips.end(), [&](const Impl::Grip& grip) {
    return impl_->is_there(grip) &&
           grip.ball->GetInteractionState() != vtkHandleRepresentation::Outside;
  });
}

void SegmentHandle::on_taken(std::function<void()> listener) {
  impl_->taken = listener;
  impl_->rings.on_taken(std::move(listener));
}

void SegmentHandle::on_moved(Listener listener) {
  impl_->moved = std::move(listener);
}

void SegmentHandle::on_released(Listener listener) {
  impl_->released = std::move(listener);
}

void SegmentHandle::on_turned(std::function<void(int axis, double degrees)> listener) {
  impl_->rings.on_turned(std::move(listener));
}

}  // namespace gnathion
