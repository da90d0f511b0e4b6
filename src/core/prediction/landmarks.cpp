#include "prediction/landmarks.h"

#include <Eigen/Geometry>

#include "geometry/bsp_tree.h"

namespace gnathion {

FaceLandmarks::FaceLandmarks(const std::map<std::string, Eigen::Vector3d>& places,
                             const TriangleMesh& face, std::span<const BoneSegment> segments) {
  if (places.empty()) return;
  std::vector<BspTree> bones;
  for (const BoneSegment& segment : segments) bones.emplace_back(segment.mesh);
  const BspTree tree(face);
  for (const auto& [name, place] : places) {
    const auto nearest = tree.nearest(place, 1e6);
    if (!nearest) continue;
    Anchor anchor;
    anchor.point = nearest->point;
    anchor.skin_gap = nearest->distance;
    for (int k = 0; k < 3; ++k) {
      anchor.vertex[k] = face.triangles(nearest->triangle, k);
      anchor.rest.row(k) = face.vertices.row(anchor.vertex[k]);
    }
    // Barycentric weights of the nearest point from its areas.
    const Eigen::Matrix3d corners = anchor.rest.transpose();
    const Eigen::Vector3d n =
        (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    if (n.isZero(0)) anchor.weight[0] = 1;  // a triangle without area: its corner is as near
    for (int k = 0; k < 3 && !n.isZero(0); ++k) {
      const Eigen::Vector3d a = corners.col((k + 1) % 3), b = corners.col((k + 2) % 3);
      anchor.weight[k] = (a - anchor.point).cross(b - anchor.point).dot(n) / n.squaredNorm();
    }
    double reach = 1e6;
    for (std::size_t b = 0; b < bones.size(); ++b) {
      const auto bone = bones[b].nearest(anchor.point, reach);
      if (!bone) continue;
      reach = bone->distance;
      anchor.segment = static_cast<int>(b);
    }
    anchors_.emplace(name, anchor);
  }
}

std::map<std::string, LandmarkResponse> FaceLandmarks::responses(
    const Points& points, std::span<const RigidMotion> motions) const {
  std::map<std::string, LandmarkResponse> responses;
  for (const auto& [name, anchor] : anchors_) {
    LandmarkResponse response;
    response.skin_gap = anchor.skin_gap;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d u = (points.row(anchor.vertex[k]) - anchor.rest.row(k)).transpose();
      response.displacement += anchor.weight[k] * u;
    }
    // Without segments no bone moves.
    const Eigen::Vector3d bone = motions.empty()
                                     ? Eigen::Vector3d::Zero().eval()
                                     : motions[anchor.segment](anchor.point) - anchor.point;
    response.bone_mm = bone.norm();
    if (response.bone_mm > 0) {
      response.ratio = response.displacement.dot(bone) / bone.squaredNorm();
    }
    responses.emplace(name, response);
  }
  return responses;
}

}  // namespace gnathion
