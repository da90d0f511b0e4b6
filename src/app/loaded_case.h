#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/ready_anatomy.h"
#include "base/error.h"
#include "plan/history.h"
#include "prediction/report.h"

namespace gnathion {

/// A case that is open: what was planned and what was computed from it. Immutable, so that workers
/// may hold it while the window goes on.
struct LoadedCase {
  SurgicalCase plan;
  std::shared_ptr<const Anatomy> anatomy;
  std::shared_ptr<const FaceModel> model;  ///< null: the face cannot follow yet
  std::optional<Error> no_model;           ///< why; none with a model, or without segments
  FaceLandmarks landmarks;
  std::shared_ptr<const ReadyAnatomy> ready;  ///< of the anatomy, for the views
};

/// Computes all that a drag needs, on the calling thread and one helper; what the plan has in
/// common with that of `known` (null: none) is taken from there. A region that has no tissue, or
/// one that the bone does not drive, is no_model, not an error: the surgeon is about to paint it.
/// Throws as build_anatomy, and Error(input) for a texture that cannot be shown.
std::shared_ptr<const LoadedCase> load_case(const SurgicalCase& plan, const LoadedCase* known,
                                            Progress& progress);

/// The folder of the embedded default case in `cache`, written there when this build of the
/// program (`program`: its file) has not done so yet; those of other builds are removed.
/// Throws Error(output), Error(cancelled).
std::filesystem::path cached_demo_case(const std::filesystem::path& cache,
                                       const std::filesystem::path& program, Progress& progress);

/// Whether two plans differ at most in the motions of their segments and in what the photograph's
/// place was found by (its landmarks, its stable region), from which nothing is computed.
bool same_but_for_motions(const SurgicalCase& a, const SurgicalCase& b);

/// Writes a new folder with the face predicted for `plan` and report.json. format: "obj":
/// predicted.obj, which differs from the photograph in its v lines only, its MTL files and
/// textures; "glb" or "ply": that one file (scan/scan_export.h). `prediction`: that of the plan,
/// where it is known already; null: it is made. \pre loaded.model Throws Error(output) when the
/// folder exists or cannot be written, as make_prediction otherwise.
void export_prediction(const LoadedCase& loaded, const SurgicalCase& plan,
                       std::shared_ptr<const Prediction> prediction, const std::string& format,
                       const std::filesystem::path& folder, Progress& progress);

}  // namespace gnathion
