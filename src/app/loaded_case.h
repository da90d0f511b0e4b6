#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "prediction/report.h"

namespace gnathion {

/// A case that is open: what its file says and what was computed from it. Immutable, so that
/// workers may hold it while the window goes on.
struct LoadedCase {
  std::filesystem::path file;
  SurgicalCase plan;
  std::shared_ptr<const Anatomy> anatomy;
  std::shared_ptr<const FaceModel> model;
  FaceLandmarks landmarks;
  Triangles coarse_skull;                  ///< of the remainder, for frames while something moves
  std::vector<Triangles> coarse_segments;  ///< of the segments, likewise
};

/// Reads a case file and computes all that a drag needs, on the calling thread and one helper.
/// Throws as read_case_file, build_anatomy and FaceModel, and Error(input) for a texture that
/// cannot be shown.
std::shared_ptr<const LoadedCase> load_case(const std::filesystem::path& file, Progress& progress);

/// The folder of the embedded default case in `cache`, written there when this build of the
/// program (`program`: its file) has not done so yet; those of other builds are removed.
/// Throws Error(output), Error(cancelled).
std::filesystem::path cached_demo_case(const std::filesystem::path& cache,
                                       const std::filesystem::path& program, Progress& progress);

/// The case's plan with other motions, one a segment.
SurgicalCase plan_with(const LoadedCase& loaded, std::span<const JawMotion> motions);

/// Writes a new folder with the face predicted for `plan`: predicted.obj, which differs from the
/// photograph in its v lines only, its MTL files and textures, and report.json. `prediction`: that
/// of the plan, where it is known already; null: it is made.
/// Throws Error(output) when the folder exists or cannot be written, as make_prediction otherwise.
void export_prediction(const LoadedCase& loaded, const SurgicalCase& plan,
                       std::shared_ptr<const Prediction> prediction,
                       const std::filesystem::path& folder, Progress& progress);

}  // namespace gnathion
