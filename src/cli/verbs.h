#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "base/progress.h"
#include "prediction/settling.h"
#include "registration/registration.h"

namespace gnathion {

// One function a verb of gnathion-cli (docs/cli.md). Each reads its input, writes one new folder
// that appears whole or not at all, prints what it wrote to `out`, and throws gnathion::Error.

/// Lists the DICOM series of a folder: UID, modality, description, slices, spacing.
void list_series_verb(const std::filesystem::path& folder, std::ostream& out, Progress& progress);

/// Writes the embedded default case: CT, photograph, truth.json, case.json.
void demo_case_verb(unsigned seed, const std::filesystem::path& target, std::ostream& out,
                    Progress& progress);

/// Reads and checks a case file and says what it asks for; nothing is written.
void check_verb(const std::filesystem::path& case_file, std::ostream& out);

/// bone.ply, and face.obj with its textures (the photograph in its own frame, or the CT's skin).
void surfaces_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                   std::ostream& out, Progress& progress);

/// segment.ply and remainder.ply.
void segment_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                  std::ostream& out, Progress& progress);

/// region.ply, and region.txt with its vertices of the face.
void region_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                 std::ostream& out, Progress& progress);

/// tissue.vtu (the tetrahedra), and with displacement transfer tissue.inp, the same problem for
/// CalculiX.
void mesh_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
               std::ostream& out, Progress& progress);

/// All steps: predicted.obj with MTL and textures, pictures, tissue.vtu with displacements,
/// report.json.
void predict_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                  bool pictures, std::ostream& out, Progress& progress);

/// The damped motion from rest to the plan: settling.csv, a line a time step, and with `pictures`
/// frame_STEP.png, at most 25 of them. Says when the motion has not settled.
void settle_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                 const SettlingOptions& options, bool pictures, std::ostream& out,
                 Progress& progress);

/// How a photograph is to be registered.
struct RegisterChoices {
  bool from_case = false;  ///< begin at the case's transform; else anywhere, or at the landmarks
  std::optional<double> mm_per_unit;
  bool fit_scale = false;
  std::optional<std::filesystem::path> landmarks;  ///< name, photograph x y z, LPS x y z a line
  std::optional<std::filesystem::path> stable;     ///< vertices of the photograph, from 0
  bool accept_doubts = false;
};

/// Puts the case's photograph onto the skin of its CT: case.json with the new transform, and
/// registration.json, how well it fits. A doubtful one is an error unless doubts are accepted.
void register_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                   const RegisterChoices& choices, std::ostream& out, Progress& progress);

/// Ordinary photographs for the skin.
struct PhotographsChoices {
  std::vector<std::string> photos;  ///< PICTURE=LANDMARKS.json each, the first from the front
  std::optional<std::filesystem::path> landmarks;  ///< of the skin, beside those of the case
  std::optional<double> mm_per_pixel, inpaint_mm;
};

/// Paints the CT's skin with ordinary photographs: photograph.obj with its MTL and picture,
/// projection.json, and case.json, whose photograph that is.
void photographs_verb(const std::filesystem::path& case_file, const std::filesystem::path& target,
                      const PhotographsChoices& choices, std::ostream& out, Progress& progress);

/// Repairs of a scan, each asked for by name; lengths in the scan's unit.
struct ScanRepairChoices {
  bool merge_duplicates = false, drop_degenerate = false, drop_unreferenced = false, orient = false;
  std::optional<double> islands_below, fill_holes;

  bool any() const;
};

/// Says what a face scan holds: counts, materials, size, proposed unit and axes, what is wrong with
/// it. With a target: writes it there, repaired as asked, as `format` ("obj", "glb", "ply").
void scan_verb(const std::filesystem::path& file,
               const std::optional<std::filesystem::path>& target, const std::string& format,
               const ScanRepairChoices& choices, std::ostream& out, Progress& progress);

}  // namespace gnathion
