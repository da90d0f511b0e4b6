#pragma once

#include <Eigen/Core>

#include "render/overlay.h"

namespace gnathion {

/// Three short lines along the patient's axes that cross at a point of the 3D picture, seen through
/// everything.
class CrosshairMark : public Overlay {
 public:
  CrosshairMark();
  ~CrosshairMark() override;

  /// mm, LPS.
  void set_place(const Eigen::Vector3d& lps);

 private:
  void prepare(vtkRenderer& renderer) override;

  OverlayLines lines_;
};

}  // namespace gnathion
