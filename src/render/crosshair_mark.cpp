#include "render/crosshair_mark.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>

#include "render/pixel_ratio.h"

namespace gnathion {
namespace {

constexpr double arm_mm = 8;

}  // namespace

CrosshairMark::CrosshairMark() : lines_(OverlayLines::Place::patient, {0.05, 0.45, 0.15}) {
  add(lines_.prop());
  set_place(Eigen::Vector3d::Zero());
}

CrosshairMark::~CrosshairMark() {
  detach();
}

void CrosshairMark::set_place(const Eigen::Vector3d& lps) {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> arms;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d arm = arm_mm * Eigen::Vector3d::Unit(axis);
    arms.emplace_back(lps - arm, lps + arm);
  }
  lines_.set_lines(arms);
}

void CrosshairMark::prepare(vtkRenderer& renderer) {
  lines_.set_width(2 * pixel_ratio(&renderer));
}

}  // namespace gnathion
