#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/mesh_types.h"

namespace gnathion {

/// Where the lips seem to meet.
struct LipLineProposal {
  /// On the face, mm, LPS, from the patient's right corner of the mouth to the left one, a point
  /// about every 3 mm; empty when nothing like a mouth was found.
  std::vector<Eigen::Vector3d> line;
  /// Why the proposal should be looked at before it is used, each a sentence in a surgeon's words;
  /// when the line is empty, why. None: the shape is clear.
  std::vector<std::string> doubts;
};

/// Proposes the line between the lips from the relief of the face seen from the front: the groove
/// that runs from corner to corner. Landmarks "stomion", "mouth_corner_right" and
/// "mouth_corner_left" (mm, LPS) tie it where they are given; without stomion the mouth is looked
/// for below the nose tip, the farthest forward point of the face.
/// face: the whole face, upright and facing forward (−y), mm, LPS.
LipLineProposal propose_lip_line(const TriangleMesh& face,
                                 const std::map<std::string, Eigen::Vector3d>& landmarks);

}  // namespace gnathion
