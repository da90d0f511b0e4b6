#pragma once

#include <string>

#include "base/progress.h"
#include "geometry/surface_distance.h"
#include "prediction/answer.h"
#include "prediction/landmarks.h"

namespace gnathion {

/// A prediction and what can be said of it.
struct Prediction {
  std::vector<RigidMotion> motions;  ///< of the segments
  Answer answer;                     ///< the model that was chosen, and its estimated error
  Points face_points;                ///< n×3, mm, LPS
  double quick_mm = 0;  ///< by which the face shown while dragging differs: 95 % of the region
  Eigen::VectorXd signed_distance;  ///< n, mm, predicted face to the face before; + is bulge
  DistanceStatistics displacement;  ///< of the vertices of the region
  double relative_residual = 0;     ///< of the direct solve on linear elements
  double basis_error = 0;  ///< ‖u_basis − u_direct‖ / ‖u_direct‖ on its elements; 0 at rest
  long inverted_after = 0;  ///< tets turned inside out by the motion: 0 with large strain
  std::map<std::string, LandmarkResponse> landmarks;
  std::vector<StageTime> stage_times;  ///< of all that led to it on the same Progress
};

/// Predicts the face for the motions of a case's segments with the model that the case asks for or
/// that keeps its tolerance, checks it by a direct solve and measures it.
/// Throws as choose_answer.
Prediction make_prediction(const SurgicalCase& plan, const Anatomy& anatomy, const FaceModel& model,
                           Progress& progress);

/// The report of a prediction (docs/report.md says what is in it) as JSON text: numbers, hashes and
/// versions, no path and no patient identity.
std::string report_json(const SurgicalCase& plan, const Anatomy& anatomy,
                        const Prediction& prediction);

}  // namespace gnathion
