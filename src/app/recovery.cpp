#include "app/recovery.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/case_controller.h"
#include "io/case_file.h"
#include "io/files.h"

namespace gnathion {
namespace {

namespace fs = std::filesystem;

constexpr int soon_ms = 2000;
constexpr int pause_ms = 20000;
constexpr const char* case_name = "case.json";
constexpr const char* about_name = "about.json";

fs::path path_of(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

/// A lock that dies with its process, and never by age.
std::unique_ptr<QLockFile> lock_of(const QString& folder) {
  auto lock = std::make_unique<QLockFile>(folder + ".lock");
  lock->setStaleLockTime(0);
  return lock;
}

/// A new copy in `folder`/`number`, whole or not at all; those before it go.
void write_copy(const PlanHistory& history, const QString& file, const fs::path& folder,
                int number) {
  NewFolder copy(folder / std::to_string(number));
  write_case_history(history, copy.path() / case_name);
  const QJsonObject about{{"name", QString::fromStdString(history.plan().name)},
                          {"file", file},
                          {"kept", QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}};
  write_text_file(copy.path() / about_name, QJsonDocument(about).toJson().toStdString());
  copy.publish();
  std::error_code ignored;
  for (int old = 1; old < number; ++old) fs::remove_all(folder / std::to_string(old), ignored);
}

/// The latest copy in a folder; key is empty when there is none.
LeftBehind latest_copy(const QString& folder) {
  int latest = 0;
  for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    latest = std::max(latest, name.toInt());  // 0 for what is no number
  }
  const QDir copy(QString("%1/%2").arg(folder).arg(latest));
  if (latest == 0 || !copy.exists(case_name)) return {};
  QFile file(copy.filePath(about_name));
  QJsonObject about;
  if (file.open(QIODevice::ReadOnly)) about = QJsonDocument::fromJson(file.readAll()).object();
  const QDateTime kept = QDateTime::fromString(about["kept"].toString(), Qt::ISODate);
  return {QFileInfo(folder).fileName(), about["name"].toString(), about["file"].toString(),
          copy.filePath(case_name), kept.toLocalTime()};
}

}  // namespace

Recovery::Recovery(CaseController& controller, QString root, QObject* parent)
    : QObject(parent),
      controller_(controller),
      root_(std::move(root)),
      key_(QUuid::createUuid().toString(QUuid::WithoutBraces)) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Recovery::keep);
  connect(&controller_, &CaseController::case_opened, this, [this] {
    drop();
    if (recovered_) discard(std::exchange(recovering_, QString()));  // the user gave it up
    recovered_ = !recovering_.isEmpty();
    if (!recovered_) remind();
  });
  connect(&controller_, &CaseController::history_changed, this, &Recovery::consider);
  // Another opening takes the place of the recovery, which then stays to be offered.
  connect(&controller_, &CaseController::work_began, this, [this] {
    if (!recovered_) recovering_.clear();
  });
  connect(&keeping_, &BackgroundTask::finished, this, [this] {
    if (recovered_) discard(std::exchange(recovering_, QString()));
    recovered_ = false;
  });
  connect(&keeping_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    kept_plan_.reset();
    if (std::exchange(complained_, true)) return;
    emit noticed(tr("Changes cannot be kept for the case of a crash: %1: %2. %3. Save often.")
                     .arg(failure.subject, failure.problem, failure.remedy));
  });
  find_left_behind();
}

Recovery::~Recovery() {
  drop();
  if (recovered_) discard(recovering_);
}

QString Recovery::default_root() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/recovery";
}

void Recovery::find_left_behind() {
  for (const QString& key : QDir(root_).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QString folder = root_ + "/" + key;
    std::unique_ptr<QLockFile> lock = lock_of(folder);
    if (!lock->tryLock(0)) continue;  // of a window that is open
    LeftBehind found = latest_copy(folder);
    if (found.key.isEmpty()) {
      QDir(folder).removeRecursively();
      continue;
    }
    left_behind_.push_back(std::move(found));
    claims_[key] = std::move(lock);
  }
  std::sort(left_behind_.begin(), left_behind_.end(),
            [](const LeftBehind& a, const LeftBehind& b) { return a.kept > b.kept; });
}

void Recovery::recover(const QString& key) {
  for (const LeftBehind& found : left_behind_) {
    if (found.key != key) continue;
    recovered_ = false;
    controller_.recover_case(path_of(found.copy), path_of(found.file));
    recovering_ = key;
    return;
  }
}

void Recovery::discard(const QString& key) {
  if (claims_.count(key) == 0) return;
  QDir(root_ + "/" + key).removeRecursively();
  claims_.erase(key);
  left_behind_.erase(std::remove_if(left_behind_.begin(), left_behind_.end(),
                                    [&key](const LeftBehind& found) { return found.key == key; }),
                     left_behind_.end());
  emit left_behind_changed();
}

/// A window that was started on a case has shown no welcome page.
void Recovery::remind() {
  if (left_behind_.empty() || std::exchange(reminded_, true)) return;
  emit noticed(
      tr("A case that was not saved was kept when Gnathion ended unexpectedly. Start Gnathion "
         "without a case to recover or to discard it."));
}

bool Recovery::is_kept() const {
  const PlanHistory& history = controller_.history();
  return kept_plan_ == history.steps()[history.position()].plan;
}

/// Keeps the case soon where it has changed; drops what was kept where that is saved by now.
void Recovery::consider() {
  if (!controller_.has_case()) return;
  if (!controller_.is_modified()) {
    drop();
    if (recovered_) discard(std::exchange(recovering_, QString()));  // saved before it was kept
    recovered_ = false;
    return;
  }
  if (is_kept() || timer_.isActive()) return;
  const qint64 left = since_copy_.isValid() ? pause_ms - since_copy_.elapsed() : 0;
  timer_.start(static_cast<int>(std::max<qint64>(soon_ms, left)));
}

void Recovery::keep() {
  if (!controller_.has_case() || !controller_.is_modified() || is_kept()) return;
  const QString folder = root_ + "/" + key_;
  const PlanHistory& history = controller_.history();
  kept_plan_ = history.steps()[history.position()].plan;
  since_copy_.start();
  ++copies_;
  QDir().mkpath(folder);
  if (!lock_) {
    lock_ = lock_of(folder);
    lock_->tryLock(0);  // where that fails, so does the writing, which says why
  }
  const QString file = QFile::decodeName(controller_.file().c_str());
  keeping_.start([history, file, folder = path_of(folder), number = copies_](Progress&) {
    write_copy(history, file, folder, number);
    return [] {};
  });
}

void Recovery::drop() {
  timer_.stop();
  keeping_.cancel();
  keeping_.wait();
  kept_plan_.reset();
  if (!lock_) return;
  QDir(root_ + "/" + key_).removeRecursively();
  lock_.reset();
}

}  // namespace gnathion
