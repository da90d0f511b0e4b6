#include "app/case_controller.h"

#include <QCoreApplication>
#include <QFile>
#include <algorithm>
#include <utility>

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

/// The linear model's answer. Throws as FaceModel::predict.
Response quick_response(const LoadedCase& loaded, std::span<const JawMotion> motions) {
  Response response;
  for (std::size_t s = 0; s < motions.size(); ++s) {
    response.poses.push_back(rigid_motion(motions[s], loaded.anatomy->segments[s].pivot));
  }
  loaded.model->predict(response.poses, response.face);
  const std::vector<int>& moving = loaded.model->moving_vertices();
  const Points& rest = loaded.anatomy->face.mesh.surface.vertices;
  const Points moved_by = response.face(moving, Eigen::all) - rest(moving, Eigen::all);
  response.displacement = distance_statistics(moved_by.rowwise().norm());
  response.landmarks = loaded.landmarks.responses(response.face, response.poses);
  return response;
}

}  // namespace

CaseController::CaseController(QObject* parent) : QObject(parent) {
  rest_.setSingleShot(true);
  rest_.setInterval(200);
  connect(&rest_, &QTimer::timeout, this, &CaseController::refine);
  connect_work(opening_);
  connect_work(exporting_);
  connect(&opening_, &BackgroundTask::noticed, this, &CaseController::noticed);
  connect(&refining_, &BackgroundTask::stage_began, this, &CaseController::refinement_stage);
  connect(&refining_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    set_refinement(Refinement::refused);
    emit failed(failure);
  });
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
  const QString name = QFile::decodeName(file.c_str());
  open(tr("Opening %1").arg(name), [file](Progress&) { return file; });
}

void CaseController::open_demo_case(const fs::path& cache) {
  const fs::path program = QFile::encodeName(QCoreApplication::applicationFilePath()).toStdString();
  open(tr("Opening the demo case"), [cache, program](Progress& progress) {
    return cached_demo_case(cache, program, progress) / "case.json";
  });
}

void CaseController::open(const QString& what, std::function<fs::path(Progress&)> case_file) {
  opening_.start([this, case_file = std::move(case_file)](Progress& progress) {
    auto loaded = load_case(case_file(progress), progress);
    return [this, loaded] { publish(loaded); };
  });
  emit work_began(what);
}

void CaseController::publish(std::shared_ptr<const LoadedCase> loaded) {
  std::vector<JawMotion> motions;
  bool cut = false;
  for (const PlannedSegment& segment : loaded->plan.segments) {
    motions.push_back(within_limits(segment.motion));
    cut = cut || motions.back() != segment.motion;
  }
  Response response = quick_response(*loaded, motions);
  loaded_ = std::move(loaded);
  motions_ = std::move(motions);
  active_ = 0;
  response_ = std::move(response);
  await_rest();
  emit case_opened();
  emit motion_changed();
  if (cut) {
    emit noticed(tr("The case's motion is larger than this window can set (%1 mm, %2°) and was cut "
                    "to that.")
                     .arg(largest_shift_mm)
                     .arg(largest_turn_deg));
  }
}

void CaseController::export_face(const fs::path& folder) {
  if (!has_case() || is_exporting()) return;
  exporting_.start([this, loaded = loaded_, plan = plan_with(*loaded_, motions_),
                    prediction = refined_, folder](Progress& progress) {
    export_prediction(*loaded, plan, prediction, folder, progress);
    return [this, folder] { emit exported(QFile::decodeName(folder.c_str())); };
  });
  emit work_began(tr("Exporting the predicted face"));
}

void CaseController::cancel() {
  opening_.cancel();
  exporting_.cancel();
}

void CaseController::set_motion(const JawMotion& motion) {
  const JawMotion wanted = within_limits(motion);
  if (wanted != motions_[active_]) {
    std::vector<JawMotion> motions = motions_;
    motions[active_] = wanted;
    try {
      response_ = quick_response(*loaded_, motions);
      motions_ = std::move(motions);
      await_rest();
    } catch (const Error& error) {
      emit failed(failure_of(error));
    }
  }
  // Told even when nothing changed: a control may show a value that was cut or refused.
  emit motion_changed();
}

void CaseController::set_active_segment(std::size_t segment) {
  if (segment == active_) return;
  active_ = segment;
  emit active_segment_changed();
}

void CaseController::await_rest() {
  refining_.cancel();
  refined_.reset();
  refinement_ = Refinement::waiting;
  rest_.start();
}

void CaseController::refine() {
  refining_.start(
      [this, plan = plan_with(*loaded_, motions_), loaded = loaded_](Progress& progress) {
        auto prediction = std::make_shared<const Prediction>(
            make_prediction(plan, *loaded->anatomy, *loaded->model, progress));
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
  refining_.cancel();
  set_refinement(Refinement::stopped);
}

void CaseController::set_refinement(Refinement refinement) {
  refinement_ = refinement;
  emit refinement_changed();
}

}  // namespace gnathion
