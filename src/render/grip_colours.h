#pragma once

#include <Eigen/Core>

namespace gnathion {

/// RGB, 0..1, of what moves along or turns about one of the patient's axes: 0 left–right (red),
/// 1 front–back (green), 2 up–down (blue).
inline Eigen::Vector3d axis_colour(int axis) {
  if (axis == 0) return {0.80, 0.27, 0.24};
  if (axis == 1) return {0.20, 0.58, 0.30};
  return {0.18, 0.42, 0.78};
}

}  // namespace gnathion
