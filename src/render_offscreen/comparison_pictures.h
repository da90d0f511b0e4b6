#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "offscreen/offscreen.h"

namespace gnathion {

/// What the pictures of a prediction show and how large they are.
struct ComparisonOptions {
  CameraPreset view = CameraPreset::three_quarter;  ///< of before.png, after.png and colour_map.png
  int width = 900;                                  ///< pixels
  int height = 900;
  std::vector<CameraPreset> summary_views = {CameraPreset::front, CameraPreset::left};  ///< rows
  int summary_side = 480;  ///< pixels of each picture in summary.png
  double half_range = 0;   ///< mm at the colour map's ends; 0: a round one that fits the values
  std::string before_caption = "Before";
  std::string after_caption = "Predicted";
  std::string map_caption = "Change";
  std::string plan_caption = "Plan";
};

/// The files that were written.
struct ComparisonFiles {
  std::filesystem::path before;
  std::filesystem::path after;
  std::filesystem::path colour_map;
  std::filesystem::path summary;
  std::filesystem::path plan;  ///< empty when the scene has no bone
};

/// Writes before.png, after.png, colour_map.png (signed, with a scale bar) and, when the scene has
/// bones, plan.png (bones in their poses under a translucent predicted face) into an existing
/// folder, and summary.png: before | after | colour map | plan for each of summary_views.
/// All pictures of one view have the camera of the face before, so that they can be laid over each
/// other. The scene holds the face; before and after are n×3, mm, LPS; change is n, mm, positive =
/// outward. Afterwards the scene shows the face `after`, opaque, without caption and colour map.
/// Errors as FaceScene::set_face_points(), FaceScene::show_colour_map() and OffscreenRenderer.
ComparisonFiles write_comparison(FaceScene& scene, const Points& before, const Points& after,
                                 const Eigen::VectorXd& change, const std::filesystem::path& folder,
                                 const ComparisonOptions& options = {});

}  // namespace gnathion
