#pragma once

#include <optional>

#include "geometry/histogram.h"
#include "prediction/report.h"

namespace gnathion {

/// What is said of a predicted face against the face before, over the region: the vertices that a
/// motion can move. All in mm and mm³.
struct FaceChange {
  Eigen::VectorXd displacement;  ///< length of each vertex's, ≥ 0
  Eigen::VectorXd signed_mm;     ///< distance to the face before, + is bulge; empty: not measured
  DistanceStatistics displacement_size;
  DistanceStatistics signed_size;           ///< of the distances without their sign
  double volume_mm3 = 0;                    ///< what the face gains
  double area_mm2 = 0;                      ///< of the triangles that have a vertex in the region
  std::optional<DistanceStatistics> error;  ///< estimated, of the answer; none: not known

  /// A bound of the volume's error from the mean of the face's, mm³. \pre error
  double volume_error_mm3() const { return area_mm2 * error->mean; }
};

/// moving: vertices of the face, ascending. after: n×3, mm, LPS. refined: the prediction that
/// `after` is of, whose measures are taken; null: a quick answer, of which signed distances and
/// error are not known.
FaceChange face_change(const TriangleMesh& before, const std::vector<int>& moving,
                       const Points& after, const Prediction* refined);

}  // namespace gnathion
