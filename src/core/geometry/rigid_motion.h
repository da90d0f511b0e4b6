#pragma once

#include <Eigen/Core>

#include "geometry/mesh_types.h"

namespace gnathion {

/// x' = rotation · x + translation, mm, LPS.
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return rotation * x + translation; }

  bool operator==(const RigidMotion&) const = default;
};

/// x' = scale · rotation · x + translation: from a photograph's own frame and unit to LPS mm.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const {
    return scale * (rotation * x) + translation;
  }
  /// An LPS displacement (mm) in the frame and unit that this maps from.
  Eigen::Vector3d displacement_to_source(const Eigen::Vector3d& u) const {
    return rotation.transpose() * u / scale;
  }

  bool operator==(const Similarity&) const = default;
};

/// Every row moved. points: n×3, mm, LPS.
Points moved(const Points& points, const RigidMotion& motion);
Points moved(const Points& points, const Similarity& similarity);

}  // namespace gnathion
