#include "render/overlay.h"

#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkRenderWindow.h>
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

double Overlay::pixel_ratio(vtkRenderer& renderer) {
  constexpr double logical_dpi = 72;  // VTK's, at which a font's size is its height in pixels
  vtkRenderWindow* window = renderer.GetRenderWindow();
  return window == nullptr ? 1 : window->GetDPI() / logical_dpi;
}

}  // namespace gnathion
