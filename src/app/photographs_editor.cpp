#include "app/photographs_editor.h"

#include <algorithm>
#include <utility>

#include "geometry/surface_point.h"
#include "io/files.h"

namespace gnathion {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The painted skin, and how it is shown before it is written.
struct PhotographsEditor::Preview {
  ProjectedPhotographs projected;
  ObjDocument document;
};

std::shared_ptr<const PhotographsEditor::Preview> PhotographsEditor::painted_preview(
    const SkinSight& sight, const std::vector<MarkedPhoto>& photos, Progress& progress) {
  ProjectedPhotographs projected = project_photographs(photos, sight, {}, progress);
  const auto stage = progress.stage("showing the painted skin");
  ObjDocument document =
      ObjDocument::of_scan("photograph.obj", scan_of(projected.painted, sight.mesh()));
  return std::make_shared<const Preview>(Preview{std::move(projected), std::move(document)});
}

const ObjDocument* PhotographsEditor::preview() const {
  return preview_ ? &preview_->document : nullptr;
}

const PaintedSkin* PhotographsEditor::painted() const {
  return preview_ ? &preview_->projected.painted : nullptr;
}

const std::vector<std::string>& PhotographsEditor::landmarks() {
  static const std::vector<std::string> names{"nasion",
                                              "nose_tip",
                                              "subnasale",
                                              "canthus_outer_right",
                                              "canthus_inner_right",
                                              "canthus_inner_left",
                                              "canthus_outer_left",
                                              "mouth_corner_right",
                                              "mouth_corner_left",
                                              "pogonion",
                                              "tragus_right",
                                              "tragus_left"};
  return names;
}

PhotographsEditor::PhotographsEditor(CaseController& controller, QObject* parent)
    : QObject(parent), controller_(controller) {
  for (BackgroundTask* task : {&reading_, &fitting_, &projecting_}) {
    connect(task, &BackgroundTask::failed, this, &PhotographsEditor::failed);
    for (const auto ended : {&BackgroundTask::finished, &BackgroundTask::cancelled}) {
      connect(task, ended, this, &PhotographsEditor::changed);
    }
    connect(task, &BackgroundTask::failed, this, &PhotographsEditor::changed);
  }
  connect(&projecting_, &BackgroundTask::stage_began, this, &PhotographsEditor::stage_began);
  connect(&controller_, &CaseController::case_opened, this, &PhotographsEditor::take_case);
  connect(&controller_, &CaseController::case_changed, this, &PhotographsEditor::take_case);
  connect(&controller_, &CaseController::work_began, this, &PhotographsEditor::changed);
  connect(&controller_, &CaseController::work_ended, this, &PhotographsEditor::changed);
  take_case();
}

/// Another CT is another patient: what was picked goes. Otherwise it stays, also while the face is
/// a photograph, so that an undone projection can be mended.
void PhotographsEditor::take_case() {
  const auto loaded = controller_.has_case() ? controller_.shared_case() : nullptr;
  if (!loaded || loaded->anatomy->ct != ct_ || loaded->plan.skin != skin_options_) {
    cancel();
    reading_.cancel();
    fitting_.cancel();
    ct_ = loaded ? loaded->anatomy->ct : nullptr;
    skin_options_ = loaded ? loaded->plan.skin : SkinSurfaceOptions{};
    photos_.clear();
    places_.clear();
    preview_.reset();
    sight_.reset();
  }
  skin_ = loaded && !loaded->anatomy->face.is_photograph ? loaded : nullptr;
  if (active_ && skin_ && !sight_) fit();
  emit changed();
}

void PhotographsEditor::set_active(bool active) {
  active_ = active;
  if (active_) {
    if (skin_ && !sight_) fit();
  } else {
    cancel();
  }
}

const TriangleMesh& PhotographsEditor::skin() const {
  return skin_->anatomy->face.mesh.surface;
}

void PhotographsEditor::add(const std::filesystem::path& file) {
  reading_.start([this, file](Progress& progress) {
    const auto photo = std::make_shared<const Photo>(read_photo(file));
    progress.check();
    return [this, file, photo] {
      photos_.push_back({file, photo, {}, {}, {}, {}});
      changed_picks();
      emit photo_added();
    };
  });
}

void PhotographsEditor::remove(std::size_t photo) {
  photos_.erase(photos_.begin() + static_cast<std::ptrdiff_t>(photo));
  changed_picks();
}

std::optional<Vector3d> PhotographsEditor::place(const std::string& landmark) const {
  const auto found = places_.find(landmark);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

void PhotographsEditor::set_place(const std::string& landmark, const Vector3d& lps) {
  places_[landmark] = lps;
  changed_picks();
}

void PhotographsEditor::set_pixel(std::size_t photo, const std::string& landmark,
                                  const Vector2d& pixel) {
  photos_.at(photo).pixels[landmark] = pixel;
  changed_picks();
}

void PhotographsEditor::clear_place(const std::string& landmark) {
  places_.erase(landmark);
  changed_picks();
}

void PhotographsEditor::clear_pixel(std::size_t photo, const std::string& landmark) {
  photos_.at(photo).pixels.erase(landmark);
  changed_picks();
}

void PhotographsEditor::set_focal(std::size_t photo, std::optional<double> focal_35mm) {
  if (photos_.at(photo).camera.focal_35mm == focal_35mm) return;
  photos_.at(photo).camera.focal_35mm = focal_35mm;
  changed_picks();
}

std::optional<Vector3d> PhotographsEditor::place_in_sight(const Vector3d& eye,
                                                          const Vector3d& direction) const {
  if (!sight_ || !skin_) return {};
  const auto hit = point_in_sight(sight_->tree(), eye, direction);
  if (!hit) return {};
  return hit->position(sight_->mesh().triangles, sight_->mesh().vertices);
}

std::vector<PhotoLandmark> PhotographsEditor::paired(const EditedPhoto& photo) const {
  std::vector<PhotoLandmark> pairs;
  for (const auto& [name, pixel] : photo.pixels) {
    if (const auto lps = place(name)) pairs.push_back({name, *lps, pixel});
  }
  return pairs;
}

std::size_t PhotographsEditor::pairs(std::size_t photo) const {
  return paired(photos_.at(photo)).size();
}

bool PhotographsEditor::is_ready() const {
  return skin_ && sight_ && !photos_.empty() && !is_fitting() &&
         std::all_of(photos_.begin(), photos_.end(),
                     [](const EditedPhoto& photo) { return photo.fit.has_value(); });
}

void PhotographsEditor::changed_picks() {
  projecting_.cancel();
  preview_.reset();
  fit();
  emit changed();
}

std::vector<MarkedPhoto> PhotographsEditor::marked() const {
  std::vector<MarkedPhoto> photos;
  for (const EditedPhoto& photo : photos_) {
    photos.push_back({photo.file.filename().string(), photo.photo, paired(photo), photo.camera});
  }
  return photos;
}

/// The cameras of all photographs that have enough landmarks.
void PhotographsEditor::fit() {
  if (!skin_) return;
  struct Found {
    std::optional<CameraFit> fit;
    std::optional<Failure> problem;
  };
  fitting_.start([this, skin = skin_, known = sight_, photos = marked()](Progress& progress) {
    const auto sight =
        known ? known : std::make_shared<const SkinSight>(skin->anatomy->face.mesh.surface);
    std::vector<Found> found(photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
      progress.check();
      const MarkedPhoto& photo = photos[i];
      if (photo.landmarks.size() < static_cast<std::size_t>(least_landmarks(photo.camera)))
        continue;
      try {
        found[i].fit = fit_camera(photo.landmarks, photo.photo->width, photo.photo->height, *sight,
                                  photo.camera);
      } catch (const Error& error) {
        found[i].problem = failure_of(error);
      }
    }
    return [this, sight, found] {
      sight_ = sight;
      for (std::size_t i = 0; i < found.size(); ++i) {
        photos_[i].fit = found[i].fit;
        photos_[i].problem = found[i].problem;
      }
    };
  });
}

void PhotographsEditor::project() {
  projecting_.start([this, sight = sight_, photos = marked()](Progress& progress) {
    auto preview = painted_preview(*sight, photos, progress);
    return [this, preview] { preview_ = preview; };
  });
  emit changed();
}

void PhotographsEditor::apply(const std::filesystem::path& folder) {
  projecting_.start(
      [this, sight = sight_, photos = marked(), known = preview_, folder](Progress& progress) {
        NewFolder target(folder);
        const auto preview = known ? known : painted_preview(*sight, photos, progress);
        const auto stage = progress.stage("writing the photograph");
        write_projection(preview->projected, sight->mesh(), target.path());
        progress.check();
        target.publish();
        return [this, preview, folder] {
          preview_ = preview;
          controller_.edit(tr("Project photographs"), with_projection(controller_.plan(), folder));
          emit applied();
        };
      });
  emit changed();
}

void PhotographsEditor::cancel() {
  projecting_.cancel();
}

}  // namespace gnathion
