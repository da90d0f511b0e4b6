#include "bone/cut_presets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"

namespace gnathion {
namespace {

/// Axes along the bite: left, back and up.
Eigen::Matrix3d bite_axes(const JawAnatomy& jaw) {
  Eigen::Matrix3d axes;
  axes.col(0) = Eigen::Vector3d::UnitX();
  axes.col(1) = Eigen::Vector3d(0, 1, jaw.bite_rise).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// A box whose sides are given from the bite's place at the front teeth, along the bite's axes.
BoxCut box_at_bite(const JawAnatomy& jaw, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  BoxCut box;
  box.axes = bite_axes(jaw);
  box.centre = jaw.bite + box.axes * (0.5 * (min + max));
  box.half_extents = 0.5 * (max - min);
  return box;
}

/// Blades that leave the front of the chin at a share of its height and slope down to the back.
std::vector<BoundedCut> chin_cuts(const JawAnatomy& jaw) {
  std::vector<BoundedCut> cuts;
  const double height = jaw.bite.z() - jaw.menton_z;
  for (const double share : {0.40, 0.36, 0.44, 0.32}) {
    for (const double slope : {12.0, 18.0, 25.0, 6.0}) {      // degrees
      for (const double length : {60.0, 50.0, 70.0, 80.0}) {  // mm
        const double angle = slope * std::numbers::pi / 180;
        const Eigen::Vector3d back(0, std::cos(angle), -std::sin(angle));
        PlateCut blade;
        const Eigen::Vector3d front(jaw.midline_x, jaw.pogonion.y() - 8,
                                    jaw.menton_z + share * height);
        blade.centre = front + 0.5 * length * back;
        blade.in_plane = Eigen::Vector3d::UnitX();
        blade.normal = blade.in_plane.cross(back);
        blade.half_width = std::max(30.0, jaw.half_width + 5);
        blade.half_height = 0.5 * length;
        blade.seed = {jaw.midline_x, jaw.pogonion.y() + 5, jaw.menton_z + 0.15 * height};
        cuts.emplace_back(blade);
      }
    }
  }
  return cuts;
}

std::vector<BoundedCut> mandible_cuts(const JawAnatomy& jaw) {
  std::vector<BoundedCut> cuts;
  const double depth = jaw.bite.z() - jaw.menton_z + 12;
  const double front = std::min(0.0, jaw.pogonion.y() - jaw.bite.y()) - 10;
  for (const double back : {56.0, 60.0, 52.0, 64.0}) {
    for (const double roof : {0.0, -1.5, -3.0, 1.5}) {
      const double width = jaw.half_width + 6;
      cuts.emplace_back(box_at_bite(jaw, {-width, front, -depth}, {width, back, roof}));
    }
  }
  return cuts;
}

std::vector<BoundedCut> maxilla_cuts(const JawAnatomy& jaw) {
  std::vector<BoundedCut> cuts;
  const double roof = jaw.nasal_floor_z - jaw.bite.z() + 4;
  for (const double back : {52.0, 48.0, 56.0, 44.0}) {
    for (const double width : {38.0, 35.0, 41.0, 32.0}) {
      for (const double floor : {0.0, 1.5}) {
        cuts.emplace_back(box_at_bite(jaw, {-width, -12, floor}, {width, back, roof}));
      }
    }
  }
  return cuts;
}

}  // namespace

PresetCut preset_cut(CutPreset preset, const JawAnatomy& jaw, const CutPreviewer& bone,
                     Progress& progress) {
  const auto stage = progress.stage("place the cut");
  const bool chin = preset == CutPreset::chin, lower = preset == CutPreset::mandible_body;
  const std::string name = chin ? "chin" : lower ? "mandible body" : "maxilla";
  const std::vector<BoundedCut> cuts = chin    ? chin_cuts(jaw)
                                       : lower ? mandible_cuts(jaw)
                                               : maxilla_cuts(jaw);
  std::string reason;
  for (const BoundedCut& cut : cuts) {
    progress.check();
    const CutPreview preview = bone.preview(cut);
    if (!preview.refusal) return {name, cut};
    if (reason.empty()) reason = preview.refusal->problem();
  }
  throw Error(ErrorKind::anatomy, name, "no such cut was found on this bone: " + reason,
              "place a blade or a box by hand");
}

}  // namespace gnathion
