#include "render/turntable.h"

#include <algorithm>
#include <cmath>

#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace gnathion {

Turntable::Turntable(FaceScene& scene, double aspect_ratio) : scene_(scene) {
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  Eigen::Vector3d front, left;
  scene.look_from(CameraPreset::left, aspect_ratio);
  left = Eigen::Vector3d(camera->GetFocalPoint());
  distance_ = camera->GetDistance();
  scene.look_from(CameraPreset::front, aspect_ratio);
  front = Eigen::Vector3d(camera->GetFocalPoint());
  distance_ = std::max(distance_, camera->GetDistance());
  focus_ = (front + left) / 2;
}

void Turntable::turn_to(double degrees) {
  const double turn = degrees * 3.14159265358979323846 / 180;
  const Eigen::Vector3d eye =
      focus_ + distance_ * Eigen::Vector3d(std::sin(turn), -std::cos(turn), 0);
  vtkCamera* camera = scene_.renderer()->GetActiveCamera();
  camera->SetFocalPoint(focus_.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0, 0, 1);
  scene_.renderer()->ResetCameraClippingRange();
}

}  // namespace gnathion
