#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>
#include <map>
#include <memory>
#include <vector>

#include "app/background_task.h"
#include "plan/history.h"

namespace gnathion {

class CaseController;

/// A case whose window ended without being closed, as it was last kept.
struct LeftBehind {
  QString key;     ///< of its folder
  QString name;    ///< of the plan; may be empty
  QString file;    ///< where the case was last saved; empty: nowhere
  QString copy;    ///< the case file that was kept
  QDateTime kept;  ///< when, local time
};

/// Keeps what is not saved where a crash does not reach it: a changed case is written beside the
/// window into a folder of its own, two seconds after the change and at most every twenty. It is
/// removed when the case is saved, replaced or its window closed; what is still there when nobody
/// holds its lock was left behind by a crash.
class Recovery : public QObject {
  Q_OBJECT
 public:
  /// `root`: of all windows' folders, made when needed; one that cannot be written is noticed()
  /// once. The controller must outlive this.
  Recovery(CaseController& controller, QString root, QObject* parent = nullptr);
  /// The window closes as it should.
  ~Recovery() override;
  /// In the user's folder of local data.
  static QString default_root();

  /// The latest first. They belong to this window from now on: no other one offers them.
  const std::vector<LeftBehind>& left_behind() const { return left_behind_; }
  /// Opens it as a case that is not saved. What was kept goes once this window keeps it itself.
  void recover(const QString& key);
  void discard(const QString& key);

 signals:
  void left_behind_changed();
  void noticed(const QString& notice);

 private:
  void find_left_behind();
  void remind();
  void consider();
  void keep();
  void drop();
  bool is_kept() const;

  CaseController& controller_;
  QString root_;
  QString key_;                      ///< of this window's folder
  std::unique_ptr<QLockFile> lock_;  ///< null: nothing was kept yet
  std::vector<LeftBehind> left_behind_;
  std::map<QString, std::unique_ptr<QLockFile>> claims_;  ///< of what is left behind
  QString recovering_;      ///< key of what is being opened, or is open and not kept anew yet
  bool recovered_ = false;  ///< it is open
  std::shared_ptr<const SurgicalCase> kept_plan_;
  int copies_ = 0;  ///< so far: each has a number of its own
  bool complained_ = false;
  bool reminded_ = false;
  QElapsedTimer since_copy_;
  QTimer timer_;
  BackgroundTask keeping_;
};

}  // namespace gnathion
