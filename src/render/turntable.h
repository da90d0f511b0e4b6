#pragma once

#include <Eigen/Core>

#include "render/face_scene.h"

namespace gnathion {

/// Turns the view of a scene round the patient's vertical axis, at a distance from which everything
/// is in the picture all the way round.
class Turntable {
 public:
  /// scene: outlives this object; what it shows now is what must fit. aspect_ratio: width / height
  /// of its part of the picture.
  Turntable(FaceScene& scene, double aspect_ratio);
  /// 0: from the front; positive: round to the patient's left, degrees.
  void turn_to(double degrees);

 private:
  FaceScene& scene_;
  Eigen::Vector3d focus_ = Eigen::Vector3d::Zero();
  double distance_ = 1;
};

}  // namespace gnathion
