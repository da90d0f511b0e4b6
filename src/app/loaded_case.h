#pragma once

#include <filesystem>
#include <memory>

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
  Triangles coarse_skull;    ///< of the remainder, for frames while something moves
  Triangles coarse_segment;  ///< of the segment, likewise
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

/// Writes a new folder with the face predicted for `motion`: predicted.obj, which differs from the
/// photograph in its v lines only, its MTL files and textures, and report.json.
/// Throws Error(output) when the folder exists or cannot be written, as make_prediction otherwise.
void export_prediction(const LoadedCase& loaded, const JawMotion& motion,
                       const std::filesystem::path& folder, Progress& progress);

}  // namespace gnathion
