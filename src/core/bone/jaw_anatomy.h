#pragma once

#include <map>
#include <string>

#include "geometry/mesh_types.h"

namespace gnathion {

/// What a planner looks for on the jaws before the first cut. mm, LPS.
struct JawAnatomy {
  double midline_x = 0;      ///< of the chin
  Eigen::Vector3d pogonion;  ///< the most forward place of the chin
  double menton_z = 0;       ///< the chin's lowest place
  /// Between the upper and the lower teeth, at the front ones, and how that plane rises to the
  /// back, mm per mm.
  Eigen::Vector3d bite;
  double bite_rise = 0;
  double nasal_floor_z = 0;  ///< where the opening of the nose begins
  double half_width = 0;     ///< of the lower jaw behind its teeth, from the midline
};

/// Finds it on the bone of a head that looks along −y with its top towards +z (some 20° do no
/// harm). landmarks: of the case, on the skin, LPS mm, as far as there are any: "stomion",
/// "upper_lip" and "lower_lip" tell where to look for the bite.
/// Throws Error(anatomy) that names what was not found.
JawAnatomy find_jaw(const TriangleMesh& bone,
                    const std::map<std::string, Eigen::Vector3d>& landmarks);

}  // namespace gnathion
