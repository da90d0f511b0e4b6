#include "app/loaded_case.h"

#include <future>
#include <string>

#include "base/error.h"
#include "demo/demo_case.h"
#include "io/case_file.h"
#include "io/files.h"
#include "scan/scan_export.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

}  // namespace

bool same_but_for_motions(const SurgicalCase& a, const SurgicalCase& b) {
  if (a.segments.size() != b.segments.size()) return false;
  SurgicalCase moved = b;
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    moved.segments[s].motion = a.segments[s].motion;
  }
  if (a.photograph && moved.photograph) {
    moved.photograph->landmarks = a.photograph->landmarks;
    moved.photograph->stable_vertices = a.photograph->stable_vertices;
  }
  moved.hinge = a.hinge;
  return a == moved;
}

namespace {

/// Whether the same model answers both: it is linear in the poses, whatever they turn about.
bool same_but_for_pivots(const SurgicalCase& a, const SurgicalCase& b) {
  if (a.segments.size() != b.segments.size()) return false;
  SurgicalCase told = b;
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    told.segments[s].pivot = a.segments[s].pivot;
  }
  return same_but_for_motions(a, told);
}

/// Whether both plans have the same bones and the same face: a stroke of the brush changes neither.
bool same_anatomy(const SurgicalCase& a, const SurgicalCase& b) {
  SurgicalCase other = b;
  other.region = a.region;
  other.tissue = a.tissue;
  other.landmarks = a.landmarks;
  other.name = a.name;
  return same_but_for_motions(a, other);
}

/// Reads and cuts. What cannot be shown is refused here, while the case on screen is whole.
std::shared_ptr<const ReadyFace> add_anatomy(LoadedCase& loaded, const LoadedCase* known,
                                             Progress& progress) {
  std::optional<KnownAnatomy> known_anatomy;
  if (known != nullptr) known_anatomy.emplace(KnownAnatomy{known->plan, *known->anatomy});
  loaded.anatomy = std::make_shared<const Anatomy>(
      build_anatomy(loaded.plan, progress, known_anatomy ? &*known_anatomy : nullptr));
  return ready_face_of(*loaded.anatomy);
}

/// What the face follows by, or why it cannot.
void add_model(LoadedCase& loaded, const LoadedCase* known, Progress& progress) {
  if (loaded.plan.segments.empty()) return;
  if (known != nullptr && known->model && same_but_for_pivots(known->plan, loaded.plan)) {
    loaded.model = known->model;
    return;
  }
  try {
    loaded.model = std::make_shared<const FaceModel>(*loaded.anatomy, loaded.plan.region,
                                                     loaded.plan.tissue, progress);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::anatomy && error.kind() != ErrorKind::numeric) throw;
    loaded.no_model = error;
  }
}

}  // namespace

std::shared_ptr<const LoadedCase> load_case(const SurgicalCase& plan, const LoadedCase* known,
                                            Progress& progress) {
  auto loaded = std::make_shared<LoadedCase>();
  loaded->plan = plan;
  // Its destructor waits for its thread.
  std::future<std::shared_ptr<const ReadyAnatomy>> ready;
  if (known != nullptr && same_anatomy(known->plan, plan)) {
    loaded->anatomy = known->anatomy;
    loaded->ready = known->ready;
  } else {
    const std::shared_ptr<const ReadyFace> face = add_anatomy(*loaded, known, progress);
    ready = std::async(std::launch::async, ready_anatomy, loaded->anatomy, face);
  }
  const std::shared_ptr<const Anatomy> anatomy = loaded->anatomy;
  add_model(*loaded, known, progress);
  loaded->landmarks =
      FaceLandmarks(loaded->plan.landmarks, anatomy->face.mesh.surface, anatomy->segments);
  const auto stage = progress.stage("bones for quick frames");
  if (ready.valid()) loaded->ready = ready.get();
  progress.check();
  return loaded;
}

fs::path cached_demo_case(const fs::path& cache, const fs::path& program, Progress& progress) {
  std::error_code none;
  const std::string prefix = "demo-case-";
  const auto build = fs::last_write_time(program, none).time_since_epoch().count();
  fs::path folder = cache / (prefix + GNATHION_VERSION + "-" + std::to_string(build));
  if (fs::exists(folder / "case.json", none)) return folder;
  fs::create_directories(cache, none);
  if (!fs::is_directory(cache, none)) {
    throw Error(ErrorKind::output, cache.string(), "the folder for the demo case cannot be made",
                "make it, or set XDG_CACHE_HOME to a folder that can be written");
  }
  for (const auto& entry : fs::directory_iterator(cache, none)) {
    // Another window may have made it by now.
    if (entry.path() == folder && fs::exists(folder / "case.json", none)) continue;
    if (entry.path().filename().string().rfind(prefix, 0) == 0) fs::remove_all(entry, none);
  }
  try {
    write_demo_case(1, folder, progress);
  } catch (const Error& error) {
    // Another window that began at the same time was sooner: its case is the same.
    const bool made = fs::exists(folder / "case.json", none);
    if (error.kind() != ErrorKind::output || !made) throw;
  }
  return folder;
}

void export_prediction(const LoadedCase& loaded, const SurgicalCase& plan,
                       std::shared_ptr<const Prediction> prediction, const std::string& format,
                       const fs::path& folder, Progress& progress) {
  NewFolder output(folder);
  const Anatomy& anatomy = *loaded.anatomy;
  if (!prediction) {
    prediction =
        std::make_shared<const Prediction>(make_prediction(plan, anatomy, *loaded.model, progress));
  }
  const auto stage = progress.stage("export");
  write_scan(anatomy.face.document, anatomy.face.file_vertices(prediction->face_points),
             output.path(), "predicted." + format);
  write_text_file(output.path() / "report.json", report_json(plan, anatomy, *prediction));
  progress.check();
  output.publish();
}

}  // namespace gnathion
