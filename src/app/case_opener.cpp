#include "app/case_opener.h"

#include <QDir>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QMimeData>
#include <QStandardPaths>
#include <QUrl>
#include <algorithm>

#include "app/case_controller.h"
#include "app/case_saver.h"
#include "app/file_dialogs.h"
#include "app/photograph_dialog.h"
#include "app/recent_cases.h"
#include "app/series_dialog.h"
#include "io/input_kind.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

fs::path path_of(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

QFileDialog* existing_file_dialog(QWidget& window, const QString& title, const char* name) {
  QFileDialog* dialog = new_file_dialog(&window, name, title);
  dialog->setFileMode(QFileDialog::ExistingFile);
  return dialog;
}

bool has_files(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return !urls.isEmpty() &&
         std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
}

}  // namespace

CaseOpener::CaseOpener(CaseController& controller, CaseSaver& saver, RecentCases& recent,
                       QWidget& window)
    : controller_(controller), saver_(saver), recent_(recent), window_(window) {
  window_.setAcceptDrops(true);
  window_.installEventFilter(this);
  const auto remember = [this] {
    if (!controller_.file().empty()) recent_.add(QFile::decodeName(controller_.file().c_str()));
  };
  connect(&controller_, &CaseController::case_opened, this, remember);
  connect(&controller_, &CaseController::saved, this, remember);
}

fs::path CaseOpener::demo_cache() {
  return path_of(QStandardPaths::writableLocation(QStandardPaths::CacheLocation));
}

void CaseOpener::ask_case() {
  QFileDialog* dialog = existing_file_dialog(window_, tr("Open case"), "open_dialog");
  dialog->setNameFilters({tr("Case files (*.json)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, &CaseOpener::take);
  dialog->open();
}

void CaseOpener::ask_dicom_folder() {
  QFileDialog* dialog = existing_file_dialog(
      window_, tr("Import a CT: the folder with its DICOM files"), "folder_dialog");
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::fileSelected, this, &CaseOpener::take);
  dialog->open();
}

void CaseOpener::ask_volume() {
  QFileDialog* dialog = existing_file_dialog(
      window_, tr("Import a CT: an image volume in Hounsfield units"), "volume_dialog");
  dialog->setNameFilters(
      {tr("Image volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz)"), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, &CaseOpener::take);
  dialog->open();
}

void CaseOpener::ask_photograph_file() {
  QFileDialog* dialog =
      existing_file_dialog(window_, tr("Add a photograph"), "photograph_file_dialog");
  QStringList patterns;
  for (const char* ending : scan_endings) patterns << "*" + QString(ending);
  dialog->setNameFilters({tr("Face scans (%1)").arg(patterns.join(' ')), tr("All files (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, &CaseOpener::take);
  dialog->open();
}

void CaseOpener::open_demo() {
  saver_.before_leaving([this] { controller_.open_demo_case(demo_cache()); });
}

void CaseOpener::take(const QString& path) {
  try {
    take_path(path_of(QDir::cleanPath(QFileInfo(path).absoluteFilePath())));
  } catch (const Error& error) {
    emit failed(failure_of(error));
  }
}

void CaseOpener::take_path(const fs::path& path) {
  switch (input_kind(path)) {
    case InputKind::dicom_folder:
      list_series(path);
      return;
    case InputKind::volume:
      saver_.before_leaving([this, path] { controller_.import_ct({path, {}}); });
      return;
    case InputKind::photograph:
      ask_photograph(path);
      return;
    case InputKind::case_file:
      saver_.before_leaving([this, path] { controller_.open_case(path); });
      return;
  }
}

void CaseOpener::list_series(const fs::path& folder) {
  auto* dialog = new SeriesDialog(folder, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &SeriesDialog::failed, this, &CaseOpener::failed);
  connect(dialog, &SeriesDialog::ct_chosen, this, [this](const CtSource& ct) {
    saver_.before_leaving([this, ct] { controller_.import_ct(ct); });
  });
  dialog->open();
}

void CaseOpener::ask_photograph(const fs::path& obj) {
  if (!controller_.has_case()) {
    throw Error(ErrorKind::input, obj.string(), "is a photograph, and no case is open to add it to",
                "open a case or import a CT first, then drop the photograph again");
  }
  auto* dialog =
      new PhotographDialog(obj, controller_.loaded().anatomy->face.mesh.surface.vertices, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PhotographDialog::photograph_chosen, this,
          [this](const PhotographSource& photograph, bool to_be_fitted) {
            if (!controller_.has_case()) return;
            SurgicalCase plan = controller_.plan();
            plan.photograph = photograph;
            plan.region.vertices.clear();  // they count the vertices of the face before
            plan.tissue.sliding_vertices.clear();
            controller_.edit(tr("Add the photograph"), std::move(plan));
            emit photograph_added(photograph.obj, to_be_fitted);
          });
  dialog->open();
}

void CaseOpener::drop(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  if (urls.size() == 1) {
    take(urls.first().toLocalFile());
    return;
  }
  emit failed({tr("%1 files at once").arg(urls.size()), tr("only one can be opened at a time"),
               tr("drop one file, or the folder that holds the series")});
}

bool CaseOpener::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_) return QObject::eventFilter(watched, event);
  const bool drops = event->type() == QEvent::Drop;
  if (drops || event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
    auto* over = static_cast<QDropEvent*>(event);  // the base of all three
    if (!has_files(*over->mimeData())) return QObject::eventFilter(watched, event);
    over->setDropAction(Qt::CopyAction);
    over->accept();
    emit drop_hovers(!drops);
    if (drops) drop(*over->mimeData());
    return true;
  }
  if (event->type() == QEvent::DragLeave) emit drop_hovers(false);
  return QObject::eventFilter(watched, event);
}

}  // namespace gnathion
