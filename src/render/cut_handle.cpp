#include "render/cut_handle.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCubeSource.h>
#include <vtkHandleWidget.h>
#include <vtkLineSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereHandleRepresentation.h>

#include "bone/cut_box.h"
#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

constexpr double stalk = 14;             // mm from the front side to the ball that moves
constexpr double least_half_extent = 1;  // mm

enum class GripKind { move, resize, turn };

struct Grip {
  GripKind kind = GripKind::move;
  int axis = 0;     // of a side: the box's axis
  double sign = 1;  // and its direction; of a corner: which side of the front
};

double pixels(GripKind kind) {
  return kind == GripKind::move ? 16 : 11;
}

Eigen::Vector3d colour(GripKind kind) {
  switch (kind) {
    case GripKind::move:
      return {0.98, 0.72, 0.15};
    case GripKind::resize:
      return {0.95, 0.95, 0.97};
    case GripKind::turn:
      return {0.20, 0.62, 0.30};
  }
  return Eigen::Vector3d::Ones();
}

/// The side that looks forward, and the one of the others that looks to the left.
struct Facing {
  int front = 1;
  double front_sign = -1;
  int across = 0;
  double across_sign = 1;
};

Facing facing_of(const BoxCut& box, int axes) {
  Facing facing;
  Eigen::RowVectorXd forward = -box.axes.row(1).head(axes);
  Eigen::Index front = 0;
  forward.cwiseAbs().maxCoeff(&front);
  facing.front = static_cast<int>(front);
  facing.front_sign = forward(front) > 0 ? 1 : -1;
  double best = -1;
  for (int a = 0; a < axes; ++a) {
    if (a == facing.front || std::abs(box.axes(0, a)) <= best) continue;
    best = std::abs(box.axes(0, a));
    facing.across = a;
    facing.across_sign = box.axes(0, a) > 0 ? 1 : -1;
  }
  return facing;
}

}  // namespace

struct CutHandle::Impl {
  struct Ball {
    vtkNew<vtkHandleWidget> widget;
    vtkNew<vtkSphereHandleRepresentation> shape;
    vtkNew<vtkCallbackCommand> command;
    Impl* owner = nullptr;
    Grip grip;
  };

  std::vector<std::unique_ptr<Ball>> balls;
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkActor> sides, edges;
  vtkNew<vtkOutlineSource> outline;
  vtkNew<vtkLineSource> line;
  vtkNew<vtkActor> line_actor;
  vtkRenderer* renderer = nullptr;
  BoundedCut cut = BoxCut{};
  BoxCut box;
  Facing facing;
  bool held = false;  // the facing stays while a ball is in the hand
  Listener changed, released;

  Impl() {
    add_ball({GripKind::move, 0, 1});
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) add_ball({GripKind::resize, axis, sign});
    }
    for (const double sign : {-1.0, 1.0}) add_ball({GripKind::turn, 0, sign});
    set_up_shape();
    set_size(1);
    place();
  }

  bool is_blade() const { return std::holds_alternative<PlateCut>(cut); }

  void add_ball(const Grip& grip) {
    auto ball = std::make_unique<Ball>();
    ball->owner = this;
    ball->grip = grip;
    vtkProperty* property = ball->shape->GetProperty();
    const Eigen::Vector3d rgb = colour(grip.kind);
    property->SetColor(rgb.x(), rgb.y(), rgb.z());
    property->SetAmbient(0.35);
    property->SetDiffuse(0.75);
    ball->shape->GetSelectedProperty()->SetColor(1, 1, 1);
    ball->shape->GetSelectedProperty()->SetAmbient(0.6);
    ball->widget->SetRepresentation(ball->shape);
    ball->widget->SetAllowHandleResize(0);
    ball->widget->SetEnableAxisConstraint(0);  // Shift belongs to the camera
    ball->command->SetClientData(ball.get());
    ball->command->SetCallback(&Impl::hear);
    ball->widget->AddObserver(vtkCommand::InteractionEvent, ball->command);
    ball->widget->AddObserver(vtkCommand::EndInteractionEvent, ball->command);
    balls.push_back(std::move(ball));
  }

  void set_size(double pixel_ratio) {
    for (const auto& ball : balls)
      ball->shape->SetHandleSize(pixel_ratio * pixels(ball->grip.kind));
    for (vtkActor* actor : {edges.Get(), line_actor.Get()}) {
      actor->GetProperty()->SetLineWidth(static_cast<float>(2 * pixel_ratio));
    }
  }

  void set_up_shape() {
    const auto show = [](vtkActor* actor, vtkAlgorithm* source) {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(source->GetOutputPort());
      actor->SetMapper(mapper);
      actor->PickableOff();
    };
    show(sides, cube);
    show(edges, outline);
    show(line_actor, line);
    sides->GetProperty()->SetAmbient(0.5);
    sides->ForceTranslucentOn();
    for (vtkActor* actor : {edges.Get(), line_actor.Get()}) {
      actor->GetProperty()->LightingOff();
    }
    line_actor->GetProperty()->SetColor(colour(GripKind::move).data());
    set_colour({0.18, 0.42, 0.78});
  }

  void set_colour(const Eigen::Vector3d& rgb) {
    sides->GetProperty()->SetColor(rgb.x(), rgb.y(), rgb.z());
    const Eigen::Vector3d dark = 0.7 * rgb;
    edges->GetProperty()->SetColor(dark.x(), dark.y(), dark.z());
  }

  /// From the box's own coordinates, each −1..1 from side to side.
  Eigen::Vector3d at(const Eigen::Vector3d& share) const {
    return box.centre + box.axes * share.cwiseProduct(box.half_extents);
  }

  Eigen::Vector3d home(const Grip& grip) const {
    Eigen::Vector3d share = Eigen::Vector3d::Zero();
    share(facing.front) = facing.front_sign;
    if (grip.kind == GripKind::move) {
      return at(share) + stalk * facing.front_sign * box.axes.col(facing.front);
    }
    if (grip.kind == GripKind::turn) {
      share(facing.across) = grip.sign;
      // Behind the corner: in a profile the ball of the front side stands before it.
      share(facing.front) *= 0.7;
      // Of a box the upper corners: the lower ones may be hidden by the neck.
      const int third = 3 - facing.front - facing.across;
      if (!is_blade()) share(third) = box.axes(2, third) > 0 ? 1 : -1;
      return at(share);
    }
    const bool at_front = grip.axis == facing.front && grip.sign == facing.front_sign;
    const bool at_back = grip.axis == facing.front && !at_front;
    if (at_back) share(facing.across) = facing.across_sign;
    // Of a blade the sides' middles: its front corners turn it.
    if (is_blade() && grip.axis == facing.across) share(facing.front) = 0;
    share(grip.axis) = grip.sign;
    return at(share);
  }

  void place() {
    if (!held) facing = facing_of(box, is_blade() ? 2 : 3);
    for (const auto& ball : balls) {
      Eigen::Vector3d place = home(ball->grip);
      ball->shape->SetWorldPosition(place.data());
      if (ball->grip.kind == GripKind::move) {
        Eigen::Vector3d foot = place - stalk * facing.front_sign * box.axes.col(facing.front);
        line->SetPoint1(foot.data());
        line->SetPoint2(place.data());
      }
    }
    // The bone is seen through two sides of a box.
    sides->GetProperty()->SetOpacity(is_blade() ? 0.28 : 0.16);
    const Eigen::Vector3d size = 2 * box.half_extents;
    cube->SetXLength(size.x());
    cube->SetYLength(size.y());
    cube->SetZLength(size.z());
    const Eigen::Vector3d h = box.half_extents;
    outline->SetBounds(-h.x(), h.x(), -h.y(), h.y(), -h.z(), h.z());
    vtkNew<vtkMatrix4x4> matrix;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) matrix->SetElement(r, c, box.axes(r, c));
      matrix->SetElement(r, 3, box.centre(r));
    }
    sides->SetUserMatrix(matrix);
    edges->SetUserMatrix(matrix);
  }

  void refresh() {
    if (!renderer) return;
    for (const auto& ball : balls) {
      const bool of_kerf =
          is_blade() && ball->grip.kind == GripKind::resize && ball->grip.axis == 2;
      const bool enabled = ball->widget->GetEnabled() != 0;
      if (enabled == of_kerf) ball->widget->SetEnabled(of_kerf ? 0 : 1);
    }
  }

  static void hear(vtkObject*, unsigned long event, void* client, void*) {
    auto& ball = *static_cast<Ball*>(client);
    Impl& self = *ball.owner;
    self.held = true;
    self.pull(ball.grip, Eigen::Vector3d(ball.shape->GetWorldPosition()));
    const bool ends = event == vtkCommand::EndInteractionEvent;
    self.held = !ends;
    self.place();
    const Listener& listener = ends ? self.released : self.changed;
    if (listener) listener(self.cut);
  }

  /// A ball was pulled from its home to another place.
  void pull(const Grip& grip, const Eigen::Vector3d& to) {
    const Eigen::Vector3d from = home(grip);
    const BoxCut before = box;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (grip.kind == GripKind::move) {
      box.centre += to - from;
    } else if (grip.kind == GripKind::turn) {
      turn =
          Eigen::Quaterniond::FromTwoVectors(from - box.centre, to - box.centre).toRotationMatrix();
      box.axes = (turn * box.axes).eval();
      orthonormalise();
    } else {
      const Eigen::Vector3d outward = grip.sign * box.axes.col(grip.axis);
      const double least = least_half_extent - box.half_extents(grip.axis);
      const double by = std::max(0.5 * (to - from).dot(outward), least);
      box.half_extents(grip.axis) += by;
      box.centre += by * outward;
    }
    write_back(before, turn, grip.kind == GripKind::resize);
  }

  /// Many small turns would otherwise make the axes skew.
  void orthonormalise() {
    box.axes.col(0).normalize();
    box.axes.col(1) =
        (box.axes.col(1) - box.axes.col(1).dot(box.axes.col(0)) * box.axes.col(0)).normalized();
    const double hand = box.axes.col(0).cross(box.axes.col(1)).dot(box.axes.col(2));
    box.axes.col(2) = (hand > 0 ? 1 : -1) * box.axes.col(0).cross(box.axes.col(1));
  }

  void write_back(const BoxCut& before, const Eigen::Matrix3d& turn, bool seed_stays) {
    auto* blade = std::get_if<PlateCut>(&cut);
    if (blade == nullptr) {
      cut = box;
      return;
    }
    if (!seed_stays) blade->seed = box.centre + turn * (blade->seed - before.centre);
    blade->centre = box.centre;
    blade->in_plane = box.axes.col(0);
    blade->normal = box.axes.col(2);
    blade->half_width = box.half_extents.x();
    blade->half_height = box.half_extents.y();
  }
};

CutHandle::CutHandle() : impl_(std::make_unique<Impl>()) {}

CutHandle::~CutHandle() {
  detach();
}

void CutHandle::attach(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer) {
  detach();
  impl_->renderer = renderer;
  impl_->set_size(pixel_ratio(renderer));
  for (vtkActor* actor : {impl_->sides.Get(), impl_->edges.Get(), impl_->line_actor.Get()}) {
    renderer->AddActor(actor);
  }
  for (const auto& ball : impl_->balls) {
    ball->widget->SetInteractor(interactor);
    ball->widget->SetDefaultRenderer(renderer);
  }
  impl_->refresh();
}

void CutHandle::detach() {
  if (!impl_->renderer) return;
  for (const auto& ball : impl_->balls) {
    ball->widget->SetEnabled(0);
    ball->widget->SetInteractor(nullptr);
  }
  for (vtkActor* actor : {impl_->sides.Get(), impl_->edges.Get(), impl_->line_actor.Get()}) {
    impl_->renderer->RemoveActor(actor);
  }
  impl_->renderer = nullptr;
}

bool CutHandle::is_attached() const {
  return impl_->renderer != nullptr;
}

void CutHandle::set_cut(const BoundedCut& cut) {
  impl_->box = box_of(cut);
  impl_->cut = cut;
  impl_->place();
  impl_->refresh();
}

const BoundedCut& CutHandle::cut() const {
  return impl_->cut;
}

void CutHandle::set_colour(const Eigen::Vector3d& colour) {
  impl_->set_colour(colour);
}

void CutHandle::on_changed(Listener listener) {
  impl_->changed = std::move(listener);
}

void CutHandle::on_released(Listener listener) {
  impl_->released = std::move(listener);
}

}  // namespace gnathion
