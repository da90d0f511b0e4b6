#include "app/case_controller.h"

#include <QCoreApplication>
#include <QFile>
#include <QStandardPaths>
#include <algorithm>
#include <utility>

#include "app/motion_words.h"
#include "io/case_file.h"
#include "io/own_inputs.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

JawMotion within_limits(JawMotion motion) {
  for (double* shift : {&motion.forward_mm, &motion.up_mm, &motion.left_mm}) {
    *shift = std::clamp(*shift, -largest_shift_mm, largest_shift_mm);
  }
  for (double* turn : {&motion.pitch_deg, &motion.roll_deg, &motion.yaw_deg}) {
    *turn = std::clamp(*turn, -largest_turn_deg, largest_turn_deg);
  }
  return motion;
}

std::vector<JawMotion> motions_of(const SurgicalCase& plan) {
  std::vector<JawMotion> motions;
  for (const PlannedSegment& segment : plan.segments) motions.push_back(segment.motion);
  return motions;
}

/// The answer of `model`; null: the bone moves alone. Throws as FaceModel::predict.
Response quick_response(const LoadedCase& loaded, const FaceModel* model,
                        std::span<const JawMotion> motions) {
  Response response;
  for (std::size_t s = 0; s < motions.size(); ++s) {
    response.poses.push_back(rigid_motion(motions[s], loaded.anatomy->segments[s].pivot));
  }
  const Points& rest = loaded.anatomy->face.mesh.surface.vertices;
  if (model == nullptr) {
    response.face = rest;
  } else {
    model->predict(response.poses, response.face);
    const std::vector<int>& moving = model->moving_vertices();
    const Points moved_by = response.face(moving, Eigen::all) - rest(moving, Eigen::all);
    response.displacement = distance_statistics(moved_by.rowwise().norm());
  }
  response.landmarks = loaded.landmarks.responses(response.face, response.poses);
  return response;
}

/// A name for the folder of a case's own images, not taken yet: "chin.gnathion.json" gives
/// "chin_images".
fs::path new_image_folder(const fs::path& file) {
  fs::path name = file.filename();
  while (name.has_extension()) name = name.stem();
  fs::path folder = file.parent_path() / (name.string() + "_images");
  std::error_code ignored;
  for (int i = 2; fs::exists(fs::symlink_status(folder, ignored)); ++i) {
    folder = file.parent_path() / (name.string() + "_images_" + std::to_string(i));
  }
  return folder;
}

}  // namespace

/// A case as it was read and computed.
struct CaseController::Opened {
  PlanHistory history;
  fs::path file;  ///< empty: it has none yet
  bool is_saved;  ///< whether the file says the same
  std::shared_ptr<const LoadedCase> loaded = {};
};

CaseController::CaseController(QObject* parent)
    : QObject(parent),
      demo_cache_(QFile::encodeName(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
                      .toStdString()) {
  rest_.setSingleShot(true);
  rest_.setInterval(200);
  connect(&rest_, &QTimer::timeout, this, &CaseController::rest);
  for (BackgroundTask* task : {&opening_, &editing_, &exporting_}) connect_work(*task);
  connect(&opening_, &BackgroundTask::noticed, this, &CaseController::noticed);
  connect(&editing_, &BackgroundTask::noticed, this, &CaseController::noticed);
  connect(&editing_, &BackgroundTask::cancelled, this, &CaseController::take_back_edit);
  connect(&editing_, &BackgroundTask::failed, this, &CaseController::take_back_edit);
  connect(&refining_, &BackgroundTask::stage_began, this, &CaseController::refinement_stage);
  connect(&refining_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    set_refinement(Refinement::refused);
    emit failed(failure);
  });
  // Without quadratic elements the drag goes on with linear ones, as before.
  connect(&sharpening_, &BackgroundTask::finished, this, &CaseController::refine);
  connect(&sharpening_, &BackgroundTask::failed, this, &CaseController::refine);
}

CaseController::~CaseController() {
  exporting_.wait();
}

void CaseController::connect_work(BackgroundTask& task) {
  connect(&task, &BackgroundTask::stage_began, this, &CaseController::work_stage);
  const auto ended = [this] {
    if (!is_working()) emit work_ended();
  };
  connect(&task, &BackgroundTask::finished, this, ended);
  connect(&task, &BackgroundTask::cancelled, this, ended);
  connect(&task, &BackgroundTask::failed, this, [this, ended](const Failure& failure) {
    ended();
    emit failed(failure);
  });
}

void CaseController::open_case(const fs::path& file) {
  open(tr("Opening %1").arg(QFile::decodeName(file.c_str())), [file](Progress&) {
    return Opened{read_case_history(file), fs::absolute(file), true};
  });
}

void CaseController::open_demo_case(const fs::path& cache) {
  demo_cache_ = cache;
  const fs::path program = QFile::encodeName(QCoreApplication::applicationFilePath()).toStdString();
  open(tr("Opening the demo case"), [cache, program](Progress& progress) {
    const fs::path file = cached_demo_case(cache, program, progress) / "case.json";
    // It has no file of its own: saving must not change the cache.
    return Opened{
        PlanHistory(tr("Open the demo case").toStdString(), read_case_file(file)), {}, true};
  });
}

void CaseController::import_ct(const CtSource& ct) {
  open(tr("Importing %1").arg(QFile::decodeName(ct.path.c_str())), [ct](Progress&) {
    SurgicalCase plan;
    plan.ct = ct;
    return Opened{PlanHistory(tr("Import the CT").toStdString(), std::move(plan)), {}, false};
  });
}

void CaseController::recover_case(const fs::path& file, const fs::path& saved_as) {
  open(tr("Recovering a case"), [file, saved_as](Progress&) {
    return Opened{read_case_history(file), saved_as, false};
  });
}

void CaseController::open(const QString& what, std::function<Opened(Progress&)> read) {
  opening_.start([this, read = std::move(read)](Progress& progress) {
    Opened opened = read(progress);
    opened.loaded = load_case(opened.history.plan(), nullptr, progress);
    return [this, opened] { publish(opened); };
  });
  emit work_began(what);
}

void CaseController::publish(const Opened& opened) {
  std::vector<JawMotion> motions = motions_of(opened.loaded->plan);
  for (JawMotion& motion : motions) motion = within_limits(motion);
  const bool cut = motions != motions_of(opened.loaded->plan);
  editing_.cancel();
  pending_.reset();
  held_ = false;
  active_ = 0;
  file_ = opened.file;
  history_ = opened.history;
  saved_plan_ = opened.is_saved ? history_->steps()[history_->position()].plan : nullptr;
  take(opened.loaded, std::move(motions));
  emit case_opened();
  emit motion_changed();
  emit history_changed();
  if (cut) {
    emit noticed(tr("The case's motion is larger than this window can set (%1 mm, %2°) and was cut "
                    "to that.")
                     .arg(largest_shift_mm)
                     .arg(largest_turn_deg));
  }
}

/// Shows what was computed, with these motions.
void CaseController::take(std::shared_ptr<const LoadedCase> loaded,
                          std::vector<JawMotion> motions) {
  Response response = quick_response(*loaded, loaded->model.get(), motions);
  sharpening_.cancel();
  sharp_.reset();
  loaded_ = std::move(loaded);
  motions_ = std::move(motions);
  active_ = std::min(active_, motions_.empty() ? 0 : motions_.size() - 1);
  response_ = std::move(response);
  await_rest();
}

bool CaseController::is_modified() const {
  return has_case() && (saved_plan_ == nullptr || plan_with_motions() != *saved_plan_);
}

void CaseController::save_case(const fs::path& file) {
  commit_motion();
  try {
    if (lies_within(plan().ct.path, demo_cache_)) keep_demo_images(fs::absolute(file));
    write_case_history(history(), file);
  } catch (const Error& error) {
    emit failed(failure_of(error));
    return;
  }
  file_ = fs::absolute(file);
  saved_plan_ = history().steps()[history().position()].plan;
  emit history_changed();
  emit saved(QFile::decodeName(file_.c_str()));
}

/// Copies the demo case's images beside the file, and names the copies from now on.
void CaseController::keep_demo_images(const fs::path& file) {
  const fs::path cached = plan().ct.path.parent_path();
  const fs::path copies = new_image_folder(file);
  copy_inputs(history(), cached, copies);
  history_ = with_copied_inputs(*history_, cached, copies);
  if (pending_) pending_ = with_copied_inputs(*pending_, cached, copies);
  auto loaded = std::make_shared<LoadedCase>(*loaded_);
  loaded->plan = with_copied_inputs(loaded->plan, cached, copies);
  loaded_ = std::move(loaded);
}

void CaseController::edit(const QString& step, SurgicalCase plan) {
  commit_motion();
  PlanHistory wanted = history();
  wanted.push(step.toStdString(), std::move(plan));
  go_to(std::move(wanted));
}

void CaseController::undo() {
  if (!has_case()) return;
  commit_motion();
  PlanHistory wanted = history();
  if (!wanted.can_undo()) return;
  wanted.undo();
  go_to(std::move(wanted));
}

void CaseController::redo() {
  if (!has_case()) return;
  commit_motion();
  PlanHistory wanted = history();
  if (!wanted.can_redo()) return;
  wanted.redo();
  go_to(std::move(wanted));
}

/// Makes another plan the present one: at once where nothing but the face's answer to the motions
/// follows from what differs, all else beside the window.
void CaseController::go_to(PlanHistory history) {
  if (same_but_for_motions(history.plan(), loaded_->plan)) {
    editing_.cancel();
    pending_.reset();
    history_ = std::move(history);
    if (motions_ != motions_of(history_->plan())) {
      take(loaded_, motions_of(history_->plan()));
      emit motion_changed();
    }
    emit history_changed();
    return;
  }
  const QString name = QString::fromStdString(history.steps()[history.position()].name);
  pending_ = std::move(history);
  editing_.start([this, plan = pending_->plan(), known = loaded_](Progress& progress) {
    auto loaded = load_case(plan, known.get(), progress);
    return [this, loaded] { finish_edit(loaded); };
  });
  emit history_changed();
  emit work_began(name);
}

void CaseController::finish_edit(std::shared_ptr<const LoadedCase> loaded) {
  history_ = std::move(*pending_);
  pending_.reset();
  std::vector<JawMotion> motions = motions_of(loaded->plan);
  take(std::move(loaded), std::move(motions));
  emit case_changed();
  emit motion_changed();
  emit history_changed();
}

void CaseController::take_back_edit() {
  if (!pending_) return;
  pending_.reset();
  emit history_changed();
}

void CaseController::export_face(const fs::path& folder, const std::string& format) {
  if (!has_model() || is_exporting()) return;
  exporting_.start([this, loaded = loaded_, plan = shown_plan(), prediction = refined_, folder,
                    format](Progress& progress) {
    export_prediction(*loaded, plan, prediction, format, folder, progress);
    return [this, folder] { emit exported(QFile::decodeName(folder.c_str())); };
  });
  emit work_began(tr("Exporting the predicted face"));
}

void CaseController::cancel() {
  opening_.cancel();
  editing_.cancel();
  exporting_.cancel();
}

void CaseController::set_motion(const JawMotion& motion) {
  const JawMotion wanted = within_limits(motion);
  if (wanted != motions_[active_]) {
    std::vector<JawMotion> motions = motions_;
    motions[active_] = wanted;
    try {
      response_ = quick_response(*loaded_, has_model() ? &quick_model() : nullptr, motions);
      motions_ = std::move(motions);
      await_rest();
    } catch (const Error& error) {
      emit failed(failure_of(error));
    }
  }
  // Told even when nothing changed: a control may show a value that was cut or refused.
  emit motion_changed();
}

void CaseController::hold_motion(bool held) {
  held_ = held;
  if (!held_) commit_motion();
}

/// The motions since the last step as a step.
void CaseController::commit_motion() {
  if (pending_ || !history_ || motions_ == motions_of(history_->plan())) return;
  history_->push(tr("Move %1: %2")
                     .arg(QString::fromStdString(loaded_->anatomy->segments[active_].name),
                          motion_words(motion()))
                     .toStdString(),
                 plan_with_motions());
  emit history_changed();
}

/// What is planned now, motions that are no step yet included.
SurgicalCase CaseController::plan_with_motions() const {
  return pending_ ? pending_->plan() : shown_plan();
}

/// The plan that loaded() was computed from, with the present motions: an edit that is still being
/// computed may have other segments.
SurgicalCase CaseController::shown_plan() const {
  SurgicalCase plan = history_->plan();
  for (std::size_t s = 0; s < motions_.size(); ++s) plan.segments[s].motion = motions_[s];
  return plan;
}

void CaseController::set_active_segment(std::size_t segment) {
  if (segment == active_) return;
  active_ = segment;
  emit active_segment_changed();
}

void CaseController::await_rest() {
  refining_.cancel();
  refined_.reset();
  refinement_ = has_model() ? Refinement::waiting : Refinement::none;
  rest_.start();
}

void CaseController::rest() {
  if (!held_) commit_motion();
  if (!has_model()) return;
  if (sharp_ || sharpening_.is_running()) {
    refine();
  } else {
    sharpen();
  }
}

/// Quadratic elements for the frames of a drag, which cost the same and err several times less.
void CaseController::sharpen() {
  const TissueModel& tissue = loaded_->plan.tissue;
  const bool wanted = tissue.elements == Elements::automatic &&
                      tissue.load == LoadModel::displacement &&
                      loaded_->model->problem().tissue.mesh.tets.rows() <= kMostQuadraticTets;
  if (!wanted) {
    refine();
    return;
  }
  sharpening_.start([this, loaded = loaded_](Progress& progress) {
    auto sharp = std::make_shared<const FaceModel>(loaded->model->on_quadratic_elements(progress));
    return [this, sharp] {
      sharp_ = sharp;
      if (refined_) return;
      response_ = quick_response(*loaded_, sharp_.get(), motions_);
      emit motion_changed();
    };
  });
  set_refinement(Refinement::running);
}

void CaseController::refine() {
  if (!has_model() || rest_.isActive() || refined_) return;
  refining_.start([this, plan = shown_plan(), loaded = loaded_,
                   quick = sharp_ ? sharp_ : loaded_->model](Progress& progress) {
    auto prediction = std::make_shared<const Prediction>(
        make_prediction(plan, *loaded->anatomy, *quick, progress));
    return [this, prediction] { publish(prediction); };
  });
  set_refinement(Refinement::running);
}

void CaseController::publish(std::shared_ptr<const Prediction> prediction) {
  refined_ = std::move(prediction);
  response_ = {refined_->motions, refined_->face_points, refined_->displacement,
               refined_->landmarks};
  set_refinement(Refinement::done);
}

void CaseController::stop_refining() {
  if (refinement_ != Refinement::waiting && refinement_ != Refinement::running) return;
  rest_.stop();
  sharpening_.cancel();
  refining_.cancel();
  set_refinement(Refinement::stopped);
}

void CaseController::set_refinement(Refinement refinement) {
  refinement_ = refinement;
  emit refinement_changed();
}

}  // namespace gnathion
