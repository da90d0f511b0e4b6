#include "app/recent_cases.h"

#include <QDir>
#include <QFileInfo>

#include "app/settings.h"

namespace gnathion {
namespace {

constexpr const char* key = "recent_cases";

}  // namespace

QStringList RecentCases::files() const {
  return window_settings().value(key).toStringList();
}

void RecentCases::add(const QString& file) {
  const QString path = QDir::cleanPath(QFileInfo(file).absoluteFilePath());
  QStringList files = this->files();
  files.removeAll(path);
  files.prepend(path);
  store(files.mid(0, most));
}

void RecentCases::forget(const QString& file) {
  QStringList files = this->files();
  files.removeAll(file);
  store(files);
}

void RecentCases::clear() {
  store({});
}

QString RecentCases::problem_of(const QString& file) {
  const QFileInfo info(file);
  if (!info.dir().exists()) return tr("its folder is gone, or its disk is not connected");
  if (!info.exists()) return tr("the file was moved or deleted");
  if (!info.isReadable()) return tr("you may not read it");
  return {};
}

void RecentCases::store(const QStringList& files) {
  window_settings().setValue(key, files);
  emit changed();
}

}  // namespace gnathion
