#pragma once

#include <array>
#include <map>
#include <span>
#include <string>

#include "prediction/anatomy.h"

namespace gnathion {

/// How a point of the face follows the bone.
struct LandmarkResponse {
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();  ///< mm, LPS, of the nearest skin point
  double skin_gap = 0;  ///< mm from the landmark as given to that point
  double bone_mm = 0;   ///< how far bone fixed to the nearest segment would move there
  double ratio = 0;     ///< displacement along the bone's, over bone_mm; 0 without motion
};

/// Named points tied to the face once, so that they can be asked for every frame of a drag.
class FaceLandmarks {
 public:
  FaceLandmarks() = default;
  /// places: mm, LPS; each is tied to the nearest point of `face`, the face before any motion.
  /// segments: the bones that move.
  FaceLandmarks(const std::map<std::string, Eigen::Vector3d>& places, const TriangleMesh& face,
                std::span<const BoneSegment> segments);

  /// points: n×3, mm, LPS, the vertices of the same face moved by the segments' `motions`.
  std::map<std::string, LandmarkResponse> responses(const Points& points,
                                                    std::span<const RigidMotion> motions) const;

 private:
  struct Anchor {
    std::array<int, 3> vertex{};  ///< of the face
    Eigen::Vector3d weight = Eigen::Vector3d::Zero();
    Eigen::Matrix3d rest = Eigen::Matrix3d::Zero();  ///< the vertices' places, a row each
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    double skin_gap = 0;
    int segment = 0;  ///< the nearest one
  };
  std::map<std::string, Anchor> anchors_;
};

}  // namespace gnathion
