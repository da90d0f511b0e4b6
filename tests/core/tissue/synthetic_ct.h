#pragma once

#include <cmath>
#include <functional>

#include "imaging/ct_volume.h"

namespace gnathion::testing {

/// A CT whose value at the LPS point x is hu(x), rounded.
inline CtVolume synthetic_ct(const Eigen::Vector3i& dims, const Eigen::Matrix4d& lps_from_ijk,
                             const std::function<double(const Eigen::Vector3d&)>& hu) {
  std::vector<std::int16_t> values;
  for (int k = 0; k < dims.z(); ++k) {
    for (int j = 0; j < dims.y(); ++j) {
      for (int i = 0; i < dims.x(); ++i) {
        const Eigen::Vector3d x = lps_from_ijk.topLeftCorner<3, 3>() * Eigen::Vector3d(i, j, k) +
                                  lps_from_ijk.topRightCorner<3, 1>();
        values.push_back(static_cast<std::int16_t>(std::lround(hu(x))));
      }
    }
  }
  return CtVolume(dims, std::move(values), lps_from_ijk, "synthetic");
}

/// Voxels of these steps along LPS, the first at `origin`.
inline Eigen::Matrix4d grid(const Eigen::Vector3d& steps, const Eigen::Vector3d& origin) {
  Eigen::Matrix4d affine = Eigen::Matrix4d::Identity();
  affine.topLeftCorner<3, 3>() = steps.asDiagonal();
  affine.topRightCorner<3, 1>() = origin;
  return affine;
}

}  // namespace gnathion::testing
