#include "app/case_controller.h"

#include <QCoreApplication>
#include <QFile>
#include <algorithm>
#include <cmath>
#include <numbers>
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

}  // namespace

CaseController::CaseController(QObject* parent) : QObject(parent) {
  rest_.setSingleShot(true);
  rest_.setInterval(200);
  connect(&rest_, &QTimer::timeout, this, &CaseController::check);
  connect_work(opening_);
  connect_work(exporting_);
  connect(&opening_, &BackgroundTask::noticed, this, &CaseController::noticed);
  connect(&checking_, &BackgroundTask::failed, this, &CaseController::failed);
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
  const JawMotion motion = within_limits(loaded->plan.motion);
  Response response = response_to(*loaded, motion);
  checking_.cancel();
  loaded_ = std::move(loaded);
  motion_ = motion;
  response_ = std::move(response);
  checked_.reset();
  emit case_opened();
  emit motion_changed();
  rest_.start();
  if (motion != loaded_->plan.motion) {
    emit noticed(tr("The case's motion is larger than this window can set (%1 mm, %2°) and was cut "
                    "to that.")
                     .arg(largest_shift_mm)
                     .arg(largest_turn_deg));
  }
}

void CaseController::export_face(const fs::path& folder) {
  if (!has_case() || is_exporting()) return;
  exporting_.start([this, loaded = loaded_, motion = motion_, folder](Progress& progress) {
    export_prediction(*loaded, motion, folder, progress);
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
  if (wanted != motion_) {
    try {
      response_ = response_to(*loaded_, wanted);
      motion_ = wanted;
      checked_.reset();
      checking_.cancel();
      rest_.start();
    } catch (const Error& error) {
      emit failed(failure_of(error));
    }
  }
  // Told even when nothing changed: a control may show a value that was cut or refused.
  emit motion_changed();
}

Response CaseController::response_to(const LoadedCase& loaded, const JawMotion& motion) const {
  Response response;
  response.pose = rigid_motion(motion, loaded.anatomy->pivot);
  loaded.model->predict(response.pose, response.face);
  const Points& rest = loaded.anatomy->face.mesh.surface.vertices;
  const std::vector<int>& moving = loaded.model->moving_vertices();
  Eigen::VectorXd moved_by(static_cast<Eigen::Index>(moving.size()));
  for (std::size_t i = 0; i < moving.size(); ++i) {
    moved_by(static_cast<Eigen::Index>(i)) =
        (response.face.row(moving[i]) - rest.row(moving[i])).norm();
  }
  response.displacement = distance_statistics(moved_by);
  response.landmarks = loaded.landmarks.responses(response.face, response.pose);
  return response;
}

void CaseController::check() {
  SurgicalCase plan = loaded_->plan;
  plan.motion = motion_;
  checking_.start([this, plan, loaded = loaded_](Progress& progress) {
    auto prediction = std::make_shared<const Prediction>(
        make_prediction(plan, *loaded->anatomy, *loaded->model, progress));
    return [this, prediction] {
      checked_ = prediction;
      emit checked_changed();
    };
  });
}

bool CaseController::is_beyond_trust() const {
  const Eigen::Vector3d shift(motion_.left_mm, motion_.forward_mm, motion_.up_mm);
  const double cosine = (response_.pose.rotation.trace() - 1) / 2;
  const double turn = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
  return shift.norm() > trusted_shift_mm + 1e-9 || turn > trusted_turn_deg + 1e-6;
}

}  // namespace gnathion
