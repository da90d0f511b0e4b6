#pragma once

#include <QObject>
#include <memory>

#include "app/background_task.h"
#include "app/case_controller.h"

namespace gnathion {

class FaceView;

/// The bone's surface at another level, in voxels of some 1.7 mm, shown in place of the bones while
/// the level is chosen.
class LevelPreview : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  LevelPreview(CaseController& controller, FaceView& view, QObject* parent = nullptr);

  /// Made beside the window; a later level takes an earlier one's place. \pre has_case()
  void show(double hu);
  /// The bones as they are.
  void hide();
  bool is_shown() const { return shown_; }
  /// Waits for the worker; what it made is shown when the event loop comes round.
  bool is_working() const { return contouring_.is_running(); }

 signals:
  void shown(double hu);
  void failed(const gnathion::Failure& failure);

 private:
  void show(const TriangleMesh& bone, double hu);
  void set_bones_drawn(bool drawn);

  CaseController& controller_;
  FaceView& view_;
  std::shared_ptr<const CtVolume> full_;  ///< the volume that `coarse_` was made of
  std::shared_ptr<const CtVolume> coarse_;
  bool shown_ = false;
  BackgroundTask contouring_;
};

}  // namespace gnathion
