#include "app/exports.h"

#include <QFile>
#include <QFileDialog>
#include <QProgressDialog>
#include <algorithm>
#include <string>

#include "app/answer_words.h"
#include "app/case_controller.h"
#include "app/face_view.h"
#include "app/file_dialogs.h"
#include "app/turntable_dialog.h"
#include "io/files.h"
#include "io/mesh_files.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

/// A name of a segment as a part of a file's name.
std::string file_part(const std::string& name) {
  std::string part = name;
  std::replace_if(
      part.begin(), part.end(),
      [](char c) { return c == '/' || c == '\\' || c == ':' || c == '.' || (c >= 0 && c < 33); },
      '_');
  return part;
}

}  // namespace

void export_bones(const LoadedCase& loaded, const std::vector<RigidMotion>& poses,
                  const fs::path& folder, Progress& progress) {
  NewFolder output(folder);
  const auto stage = progress.stage("bones as STL");
  const Anatomy& anatomy = *loaded.anatomy;
  for (std::size_t s = 0; s < anatomy.segments.size(); ++s) {
    const BoneSegment& segment = anatomy.segments[s];
    write_stl({moved(segment.mesh.vertices, poses[s]), segment.mesh.triangles}, "planned segment",
              output.path() / ("segment_" + file_part(segment.name) + ".stl"));
    progress.check();
  }
  write_stl(anatomy.remainder, "remainder", output.path() / "remainder.stl");
  progress.check();
  output.publish();
}

Exports::Exports(CaseController& controller, FaceView& view, QWidget* window)
    : QObject(window), controller_(controller), view_(view), window_(window) {
  connect(&writing_, &BackgroundTask::finished, this, &Exports::end);
  connect(&writing_, &BackgroundTask::cancelled, this, &Exports::end);
  connect(&writing_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    end();
    emit failed(failure);
  });
  connect(&turntable_, &TurntableExport::picture_written, this, [this](int count) {
    if (progress_ != nullptr) progress_->setValue(count);
  });
  connect(&turntable_, &TurntableExport::cancelled, this, &Exports::end);
  connect(&turntable_, &TurntableExport::failed, this, [this](const Failure& failure) {
    end();
    emit failed(failure);
  });
  connect(&turntable_, &TurntableExport::finished, this, [this](const QString& target) {
    end();
    emit exported(tr("The turning face is %1").arg(target));
  });
}

Exports::~Exports() = default;

/// steps: 0 where nobody knows how many.
void Exports::begin(const QString& words, int steps) {
  progress_ = new QProgressDialog(words, tr("Cancel"), 0, steps, window_);
  progress_->setObjectName("export_progress");
  progress_->setWindowTitle(tr("Export"));
  progress_->setWindowModality(Qt::NonModal);
  progress_->setAutoReset(false);
  progress_->setMinimumDuration(400);
  progress_->setValue(0);
  connect(progress_, &QProgressDialog::canceled, this, [this] {
    writing_.cancel();
    turntable_.cancel();
  });
}

void Exports::end() {
  if (progress_ == nullptr) return;
  progress_->disconnect(this);
  progress_->hide();
  progress_->deleteLater();
  progress_ = nullptr;
}

void Exports::ask_bones() {
  QFileDialog* dialog = new_folder_dialog(
      window_, "bones_dialog", tr("Export the bones into a new folder"), "planned_bones");
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& folder) { save_bones(QFile::encodeName(folder).toStdString()); });
  dialog->open();
}

void Exports::save_bones(const fs::path& folder) {
  if (is_running()) return;
  begin(tr("Writing the bones as STL"), 0);
  writing_.start([this, loaded = controller_.shared_case(), poses = controller_.response().poses,
                  folder](Progress& progress) {
    export_bones(*loaded, poses, folder, progress);
    return [this, folder] {
      emit exported(tr("The segments in their planned places and the remaining bone (STL, mm, LPS) "
                       "are in %1")
                        .arg(QFile::decodeName(folder.c_str())));
    };
  });
}

void Exports::ask_turntable() {
  auto* dialog = new TurntableDialog(window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { save_turntable(dialog->wish()); });
  dialog->open();
}

void Exports::save_turntable(const TurntableWish& wish) {
  if (is_running()) return;
  TurntableWish seen = wish;
  const FaceScene& scene = view_.scene();
  seen.bones = scene.bone_names();
  std::erase_if(seen.bones, [&](const std::string& bone) { return !scene.is_bone_visible(bone); });
  seen.textured = scene.is_face_textured();
  begin(tr("Drawing the turning face"), wish.pictures);
  const QString words = predicted_words(controller_) + "\n" + answer_words(controller_, {}).caption;
  turntable_.start(controller_.shared_case(), controller_.response(), words, seen);
}

}  // namespace gnathion
