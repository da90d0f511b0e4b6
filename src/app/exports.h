#pragma once

#include <QObject>
#include <filesystem>

#include "app/background_task.h"
#include "app/turntable_export.h"

class QProgressDialog;
class QWidget;

namespace gnathion {

class CaseController;
class FaceView;

/// Writes a new folder with the bones as binary STL, mm, LPS: segment_<name>.stl in its pose, one a
/// segment, and remainder.stl. Nothing says who the patient is.
/// Throws Error(output) when the folder exists or cannot be written, Error(cancelled).
void export_bones(const LoadedCase& loaded, const std::vector<RigidMotion>& poses,
                  const std::filesystem::path& folder, Progress& progress);

/// What the File menu exports besides face and picture: asks where to, shows the progress, and
/// tells how it ended. One export of its own at a time.
class Exports : public QObject {
  Q_OBJECT
 public:
  /// All must outlive this object. window: of the dialogs.
  Exports(CaseController& controller, FaceView& view, QWidget* window);
  ~Exports() override;

  void ask_bones();      ///< \pre the controller has a case
  void ask_turntable();  ///< likewise
  void save_bones(const std::filesystem::path& folder);
  void save_turntable(const TurntableWish& wish);
  bool is_running() const { return writing_.is_running() || turntable_.is_running(); }

 signals:
  void exported(const QString& words);
  void failed(const gnathion::Failure& failure);

 private:
  void begin(const QString& words, int steps);
  void end();

  CaseController& controller_;
  FaceView& view_;
  QWidget* window_;
  QProgressDialog* progress_ = nullptr;  ///< while an export runs
  BackgroundTask writing_;
  TurntableExport turntable_;
};

}  // namespace gnathion
