#include "app/camera_mouse.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

namespace gnathion {
namespace {

constexpr double wheel_step = 1.15;
constexpr int rest_ms = 300;
constexpr double nearest_mm = 30;
constexpr double farthest_mm = 5000;

/// The camera by the mouse alone: VTK's own letters would end the program, draw wire frames or
/// switch to stereo. Of the wheel it only tells: a frame in full detail after every notch, as VTK
/// has it, would lag behind the finger.
class TurntableStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static TurntableStyle* New();
  vtkTypeMacro(TurntableStyle, vtkInteractorStyleTrackballCamera);
  void OnChar() override {}
  void OnMouseWheelForward() override { on_wheel(wheel_step); }
  void OnMouseWheelBackward() override { on_wheel(1 / wheel_step); }

  std::function<void(double)> on_wheel;
};
vtkStandardNewMacro(TurntableStyle);

}  // namespace

CameraMouse::CameraMouse(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
                         QObject* parent)
    : QObject(parent), renderer_(renderer) {
  vtkNew<TurntableStyle> style;
  style->on_wheel = [this](double factor) { zoom(factor); };
  vtkNew<vtkCallbackCommand> turning;
  turning->SetClientData(this);
  turning->SetCallback([](vtkObject*, unsigned long event, void* self, void*) {
    emit static_cast<CameraMouse*>(self)->moving(event == vtkCommand::StartInteractionEvent);
  });
  style->AddObserver(vtkCommand::StartInteractionEvent, turning);
  style->AddObserver(vtkCommand::EndInteractionEvent, turning);
  interactor->SetInteractorStyle(style);
  rest_.setSingleShot(true);
  rest_.setInterval(rest_ms);
  connect(&rest_, &QTimer::timeout, this, [this] { emit moving(false); });
}

void CameraMouse::turn(double right_deg, double up_deg) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  camera->Azimuth(right_deg);
  camera->Elevation(up_deg);
  camera->OrthogonalizeViewUp();
  hurry();
  emit moved();
}

void CameraMouse::zoom(double factor) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const double distance = std::clamp(camera->GetDistance() / factor, nearest_mm, farthest_mm);
  camera->Dolly(camera->GetDistance() / distance);
  hurry();
  emit moved();
}

void CameraMouse::hurry() {
  rest_.start();
  emit moving(true);
}

}  // namespace gnathion
