#include "app/registration_editor.h"

#include <algorithm>
#include <utility>

#include "geometry/surface_distance.h"
#include "imaging/surfaces.h"
#include "registration/stable_region.h"

namespace gnathion {
namespace {

using Eigen::Vector3d;

constexpr double colour_reach = 15;  // mm: farther off is not measured
constexpr double sight_reach = 1e5;  // mm

std::vector<PickedLandmark> no_landmarks() {
  std::vector<PickedLandmark> landmarks;
  for (const char* name : {nasion_name, nose_tip_name, "canthus_outer_right", "canthus_inner_right",
                           "canthus_inner_left", "canthus_outer_left", "mouth_corner_right",
                           "mouth_corner_left", "pogonion"}) {
    landmarks.push_back({name, {}});
  }
  return landmarks;
}

Similarity moved_by(const RigidMotion& motion, const Similarity& place) {
  return {place.scale, motion.rotation * place.rotation, motion(place.translation)};
}

/// A place that is no good as a start of anything is no proposal.
const RegistrationDoubt* failure_in(const Registration& r) {
  const auto found =
      std::find_if(r.doubts.begin(), r.doubts.end(), [](const RegistrationDoubt& doubt) {
        return doubt.kind == RegistrationDoubt::Kind::nothing_found ||
               doubt.kind == RegistrationDoubt::Kind::too_little;
      });
  return found == r.doubts.end() ? nullptr : &*found;
}

}  // namespace

RegistrationEditor::Skin::Skin(TriangleMesh surface)
    : mesh(std::move(surface)), target(mesh), tree(mesh) {}

/// What a worker needs, and what it makes for others to use again.
struct RegistrationEditor::Job {
  std::shared_ptr<const LoadedCase> loaded;
  std::shared_ptr<const CtVolume> ct;
  SkinSurfaceOptions skin_options;
  std::shared_ptr<const Skin> skin;
  std::shared_ptr<const BspTree> photograph_tree;
  std::shared_ptr<const SurfaceBrush> brush;
  std::vector<LandmarkPair> landmarks;

  const TriangleMesh& photograph() const { return loaded->anatomy->face.document.mesh().surface; }
  void make_surfaces(Progress& progress) {
    if (!photograph_tree) photograph_tree = std::make_shared<const BspTree>(photograph());
    if (!brush) brush = std::make_shared<const SurfaceBrush>(photograph());
    if (skin) return;
    const auto stage = progress.stage("the CT's skin");
    skin = std::make_shared<const Skin>(skin_surface(*ct, skin_options, progress));
  }
  void measure(Placement& placement, Progress& progress) const {
    progress.check();
    RegistrationOptions options;
    options.landmarks = landmarks;
    RegistrationQuality all =
        registration_quality(photograph(), skin->target, placement.lps_from_photograph, options);
    // Of the whole photograph, whatever decided: only so are two places compared.
    all.iterations = placement.quality.iterations;
    all.converged = placement.quality.converged;
    all.grip = placement.quality.grip;
    placement.quality = all;
    progress.check();
    placement.distance_mm = signed_distances(
        moved(photograph().vertices, placement.lps_from_photograph), skin->mesh, colour_reach);
    placement.is_measured = true;
  }
};

RegistrationEditor::RegistrationEditor(CaseController& controller, QObject* parent)
    : QObject(parent), controller_(controller), landmarks_(no_landmarks()) {
  for (BackgroundTask* task : {&measuring_, &fitting_}) {
    connect(task, &BackgroundTask::failed, this, &RegistrationEditor::failed);
    connect(task, &BackgroundTask::failed, this, &RegistrationEditor::changed);
  }
  connect(&fitting_, &BackgroundTask::stage_began, this, &RegistrationEditor::stage_began);
  for (const auto ended : {&BackgroundTask::finished, &BackgroundTask::cancelled}) {
    connect(&fitting_, ended, this, [this] {
      measure();
      emit changed();
    });
  }
  connect(&controller_, &CaseController::case_opened, this, &RegistrationEditor::take_plan);
  connect(&controller_, &CaseController::case_changed, this, &RegistrationEditor::take_plan);
  connect(&controller_, &CaseController::history_changed, this,
          &RegistrationEditor::take_landmarks);
  connect(&controller_, &CaseController::work_began, this, &RegistrationEditor::changed);
  connect(&controller_, &CaseController::work_ended, this, &RegistrationEditor::changed);
}

void RegistrationEditor::set_active(bool active) {
  active_ = active;
  if (active_) {
    take_plan();
  } else {
    measuring_.cancel();
    fitting_.cancel();
  }
}

const TriangleMesh& RegistrationEditor::photograph() const {
  return photograph_->anatomy->face.document.mesh().surface;
}

void RegistrationEditor::drop_proposal() {
  fitting_.cancel();
  proposal_.reset();
  nudge_ = {};
  nudge_base_ = before_ = present_.lps_from_photograph;
}

void RegistrationEditor::take_plan() {
  const auto loaded = controller_.has_case() ? controller_.shared_case() : nullptr;
  if (!loaded || loaded->anatomy->ct != ct_ || loaded->plan.skin != skin_options_) {
    measuring_.cancel();
    skin_.reset();
    ct_ = loaded ? loaded->anatomy->ct : nullptr;
    skin_options_ = loaded ? loaded->plan.skin : SkinSurfaceOptions{};
  }
  const bool any = loaded && loaded->anatomy->face.is_photograph;
  const bool same =
      any && photograph_ && photograph_->plan.photograph->obj == loaded->plan.photograph->obj;
  if (!same) {
    photograph_tree_.reset();
    brush_.reset();
    drop_proposal();
  }
  photograph_ = any ? loaded : nullptr;
  take_landmarks();
  if (any && (!same || present_.lps_from_photograph != loaded->anatomy->face.lps_from_file)) {
    const Similarity place = loaded->anatomy->face.lps_from_file;
    present_ = proposal_ && proposal_->lps_from_photograph == place ? *proposal_ : Placement{place};
    drop_proposal();
  }
  measure();
  emit changed();
}

RegistrationEditor::Job RegistrationEditor::job() const {
  return {photograph_, ct_, skin_options_, skin_, photograph_tree_, brush_, pairs()};
}

/// What a worker has made is kept, where it still belongs to what is open.
void RegistrationEditor::keep(const Job& job) {
  if (job.ct == ct_ && job.skin_options == skin_options_) skin_ = job.skin;
  if (photograph_ && job.loaded->plan.photograph->obj == photograph_->plan.photograph->obj) {
    photograph_tree_ = job.photograph_tree;
    brush_ = job.brush;
  }
}

void RegistrationEditor::measure() {
  const bool wanted = !present_.is_measured || (proposal_ && !proposal_->is_measured) || !skin_;
  if (!active_ || !photograph_ || !wanted || is_fitting()) return;
  measuring_.start(
      [this, job = job(), present = present_, proposal = proposal_](Progress& progress) mutable {
        job.make_surfaces(progress);
        if (!present.is_measured) job.measure(present, progress);
        if (proposal && !proposal->is_measured) job.measure(*proposal, progress);
        return [this, job, present, proposal] {
          keep(job);
          if (present.lps_from_photograph == present_.lps_from_photograph) present_ = present;
          if (proposal && proposal_ &&
              proposal->lps_from_photograph == proposal_->lps_from_photograph) {
            proposal_ = proposal;
          }
          emit changed();
        };
      });
}

void RegistrationEditor::start(Fit fit) {
  emit fit_began();
  measuring_.cancel();
  fitting_.start([this, job = job(), fit = std::move(fit)](Progress& progress) mutable {
    job.make_surfaces(progress);
    Registration r;
    {
      const auto stage = progress.stage("fitting the photograph");
      r = fit(job, progress);
    }
    if (const RegistrationDoubt* doubt = failure_in(r)) {
      throw Error(ErrorKind::numeric, tr("The photograph was not fitted").toStdString(),
                  doubt->problem, doubt->remedy);
    }
    Placement placement{r.lps_from_photograph, false, r.quality, {}, true, r.doubts};
    job.measure(placement, progress);
    return [this, job, placement] {
      keep(job);
      propose(placement);
    };
  });
  emit changed();
}

void RegistrationEditor::propose(Placement placement) {
  before_ = shown().lps_from_photograph;
  proposal_ = std::move(placement);
  nudge_base_ = proposal_->lps_from_photograph;
  nudge_ = {};
}

/// What the plan says of the photograph that is shown; null: the plan has another by now.
const PhotographSource* RegistrationEditor::planned() const {
  if (!photograph_ || !controller_.has_case()) return nullptr;
  const std::optional<PhotographSource>& plan = controller_.plan().photograph;
  return plan && plan->obj == photograph_->plan.photograph->obj ? &*plan : nullptr;
}

/// Empty: nothing is painted.
std::vector<bool> RegistrationEditor::painted_flags() const {
  const PhotographSource* plan = planned();
  if (plan == nullptr || plan->stable_vertices.empty()) return {};
  return selection_of(plan->stable_vertices, photograph().vertices.rows());
}

Selection RegistrationEditor::proposed_region() const {
  if (!photograph_ || !skin_) return {};
  return upper_face(photograph().vertices, shown().lps_from_photograph, skin_->target, pairs());
}

void RegistrationEditor::fit_automatically(FitRegion region, bool scale) {
  RegistrationOptions options;
  if (region == FitRegion::stable) options.stable = painted_flags();
  options.landmarks = pairs();
  options.fit_scale = scale;
  options.mm_per_unit = present_.lps_from_photograph.scale;
  start([options](const Job& job, Progress& progress) {
    return register_photograph(job.photograph(), job.skin->target, options, progress);
  });
}

void RegistrationEditor::refine(FitRegion region, bool scale) {
  RegistrationOptions options;
  options.landmarks = pairs();
  options.fit_scale = scale;
  if (region == FitRegion::stable) options.stable = painted_flags();
  start([options, region, from = shown().lps_from_photograph](const Job& job,
                                                              Progress& progress) mutable {
    const SkinTarget& skin = job.skin->target;
    if (region == FitRegion::stable && options.stable.empty()) {
      options.stable = upper_face(job.photograph().vertices, from, skin, job.landmarks);
    }
    return register_photograph(job.photograph(), skin, from, options, progress);
  });
}

void RegistrationEditor::fit_to_landmarks(bool scale) {
  try {
    const double mm_per_unit = shown().lps_from_photograph.scale;
    const LandmarkFit fit = scale ? fit_landmarks(pairs()) : fit_landmarks(pairs(), mm_per_unit);
    propose(Placement{fit.lps_from_photograph});
    measure();
    emit changed();
  } catch (const Error& error) {
    emit failed(failure_of(error));
  }
}

void RegistrationEditor::set_nudge(const JawMotion& nudge) {
  if (nudge == nudge_ || is_fitting()) return;
  nudge_ = nudge;
  const Vector3d middle = nudge_base_(photograph().vertices.colwise().mean().transpose());
  const Similarity place =
      nudge == JawMotion{} ? nudge_base_ : moved_by(rigid_motion(nudge, middle), nudge_base_);
  before_ = nudge_base_;
  if (place == present_.lps_from_photograph) {
    proposal_.reset();
  } else {
    proposal_ = Placement{place};
  }
  measure();
  emit changed();
}

void RegistrationEditor::accept() {
  if (!proposal_ || controller_.is_editing()) return;
  SurgicalCase plan = controller_.plan();
  plan.photograph->lps_from_photograph = proposal_->lps_from_photograph;
  controller_.edit(tr("Fit the photograph"), std::move(plan));
}

void RegistrationEditor::reject() {
  drop_proposal();
  measure();
  emit changed();
}

void RegistrationEditor::cancel() {
  fitting_.cancel();
}

std::vector<LandmarkPair> RegistrationEditor::pairs() const {
  std::vector<LandmarkPair> pairs;
  for (const auto& [name, at] : landmarks_) {
    if (at.photograph && at.lps) pairs.push_back({name, *at.photograph, *at.lps});
  }
  return pairs;
}

void RegistrationEditor::take_landmarks() {
  std::vector<PickedLandmark> landmarks = no_landmarks();
  if (const PhotographSource* plan = planned()) {
    for (const auto& place : plan->landmarks) {
      const auto known =
          std::find_if(landmarks.begin(), landmarks.end(),
                       [&](const auto& landmark) { return landmark.name == place.first; });
      if (known == landmarks.end()) {
        landmarks.push_back({place.first, place.second});
      } else {
        known->at = place.second;
      }
    }
  }
  landmarks_ = std::move(landmarks);
  emit landmarks_changed();
}

void RegistrationEditor::keep_landmarks(const QString& step) {
  if (planned() == nullptr) return;
  SurgicalCase plan = controller_.plan();
  plan.photograph->landmarks.clear();
  for (const auto& [name, at] : landmarks_) {
    if (at.photograph || at.lps) plan.photograph->landmarks[name] = at;
  }
  if (plan != controller_.plan()) controller_.edit(step, std::move(plan));
}

void RegistrationEditor::set_landmark(std::size_t landmark, PickedSurface on, const Vector3d& lps) {
  PickedPlace& picked = landmarks_.at(landmark).at;
  if (on == PickedSurface::ct) {
    picked.lps = lps;
  } else {
    const Similarity& place = shown().lps_from_photograph;
    picked.photograph = place.displacement_to_source(lps - place.translation);
  }
  emit landmarks_changed();
}

void RegistrationEditor::clear_landmark(std::size_t landmark) {
  landmarks_.at(landmark).at = {};
  keep_landmarks(tr("Clear a landmark"));
  emit landmarks_changed();
}

std::map<std::string, double> RegistrationEditor::residuals() const {
  return landmark_residuals(pairs(), shown().lps_from_photograph);
}

std::map<std::string, double> RegistrationEditor::residuals_before() const {
  return landmark_residuals(pairs(), before_);
}

std::optional<Vector3d> RegistrationEditor::place_in_sight(PickedSurface on, const Vector3d& eye,
                                                           const Vector3d& direction) const {
  if (on == PickedSurface::ct) {
    if (!skin_) return {};
    const auto hit = skin_->tree.first_hit(eye, direction, sight_reach);
    if (!hit) return {};
    return eye + hit->distance * direction;
  }
  if (!photograph_tree_) return {};
  const Similarity& place = shown().lps_from_photograph;
  const auto hit = photograph_tree_->first_hit(
      place.displacement_to_source(eye - place.translation), place.rotation.transpose() * direction,
      sight_reach / place.scale);
  if (!hit) return {};
  return eye + hit->distance * place.scale * direction;
}

}  // namespace gnathion
