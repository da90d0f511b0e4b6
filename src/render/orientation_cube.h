#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "render/overlay.h"

namespace gnathion {

/// A face of the orientation cube as it is seen.
struct CubeFace {
  char letter;                             ///< the patient's side, one of "LRPASI"
  std::array<Eigen::Vector2d, 4> corners;  ///< x right, y up; the cube's half side is 1
  Eigen::Vector2d centre;
  double facing;  ///< cosine between its normal and the line to the eye, > 0
};

/// The faces that can be seen, most averted first, of a cube whose faces lie along the patient's
/// axes, drawn without perspective. right, up, away: the picture's axes, orthonormal, LPS.
std::vector<CubeFace> visible_cube_faces(const Eigen::Vector3d& right, const Eigen::Vector3d& up,
                                         const Eigen::Vector3d& away);

/// A small cube in the picture's lower left corner that turns with the camera; its faces carry the
/// letters of the patient's sides.
class OrientationCube : public Overlay {
 public:
  OrientationCube();
  ~OrientationCube() override;

 private:
  void prepare(vtkRenderer& renderer) override;

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gnathion
