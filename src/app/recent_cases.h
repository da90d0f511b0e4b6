#pragma once

#include <QObject>
#include <QStringList>

namespace gnathion {

/// The case files that were opened or saved last, the latest first, remembered between two starts.
/// A path may carry a patient's name: each can be forgotten, and all of them.
class RecentCases : public QObject {
  Q_OBJECT
 public:
  static constexpr int most = 10;

  using QObject::QObject;

  /// Absolute paths, also of files that are gone by now.
  QStringList files() const;
  void add(const QString& file);
  void forget(const QString& file);
  void clear();
  /// Why the file cannot be opened, in a few words; empty when it can.
  static QString problem_of(const QString& file);

 signals:
  void changed();

 private:
  void store(const QStringList& files);
};

}  // namespace gnathion
