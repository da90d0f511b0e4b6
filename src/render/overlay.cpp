#include "render/overlay.h"

#include <vector>

#include <vtkActor2D.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProp.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace gnathion {

struct Overlay::Impl {
  vtkNew<vtkCallbackCommand> before_render;
  std::vector<vtkSmartPointer<vtkProp>> props;
  vtkRenderer* renderer = nullptr;
  bool visible = true;
};

Overlay::Overlay() : impl_(std::make_unique<Impl>()) {
  impl_->before_render->SetClientData(this);
  impl_->before_render->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    auto* overlay = static_cast<Overlay*>(self);
    if (overlay->impl_->visible) overlay->prepare(*overlay->impl_->renderer);
  });
}

Overlay::~Overlay() {
  detach();
}

void Overlay::attach(vtkRenderer* renderer) {
  if (renderer == impl_->renderer) return;
  detach();
  impl_->renderer = renderer;
  for (vtkProp* prop : impl_->props) renderer->AddViewProp(prop);
  renderer->AddObserver(vtkCommand::StartEvent, impl_->before_render);
}

void Overlay::detach() {
  if (impl_->renderer == nullptr) return;
  impl_->renderer->RemoveObserver(impl_->before_render);
  for (vtkProp* prop : impl_->props) impl_->renderer->RemoveViewProp(prop);
  impl_->renderer = nullptr;
}

void Overlay::set_visible(bool visible) {
  impl_->visible = visible;
  for (vtkProp* prop : impl_->props) prop->SetVisibility(visible);
}

void Overlay::add(vtkProp* prop) {
  prop->PickableOff();
  impl_->props.emplace_back(prop);
  if (impl_->renderer != nullptr) impl_->renderer->AddViewProp(prop);
}

struct OverlayLines::Impl {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor2D> actor;
};

OverlayLines::OverlayLines(Place place, const Eigen::Vector3d& colour)
    : impl_(std::make_unique<Impl>()) {
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(impl_->data);
  if (place == Place::patient) {
    vtkNew<vtkCoordinate> world;
    world->SetCoordinateSystemToWorld();
    mapper->SetTransformCoordinate(world);
  }
  impl_->actor->SetMapper(mapper);
  impl_->actor->GetProperty()->SetColor(colour.x(), colour.y(), colour.z());
}

OverlayLines::~OverlayLines() = default;

vtkActor2D* OverlayLines::prop() const {
  return impl_->actor;
}

void OverlayLines::set_lines(const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& ends) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& [from, to] : ends) {
    const vtkIdType line[] = {points->InsertNextPoint(from.data()),
                              points->InsertNextPoint(to.data())};
    lines->InsertNextCell(2, line);
  }
  impl_->data->SetPoints(points);
  impl_->data->SetLines(lines);
}

void OverlayLines::set_width(double pixels) {
  impl_->actor->GetProperty()->SetLineWidth(static_cast<float>(pixels));
}

}  // namespace gnathion
