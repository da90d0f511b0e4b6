#pragma once

#include <QObject>

#include "app/registration_editor.h"
#include "app/view_tool.h"

namespace gnathion {

/// Picks the chosen landmark on the surface that is shown: a click puts it, a drag moves it along
/// the surface; beside the surface the camera turns.
class LandmarkTool : public QObject, public ViewTool {
  Q_OBJECT
 public:
  /// The editor must outlive the tool.
  explicit LandmarkTool(RegistrationEditor& editor, QObject* parent = nullptr);

  /// false: every press turns the camera.
  void set_picking(bool picking) { picking_ = picking; }
  void set_surface(PickedSurface surface) { surface_ = surface; }
  /// One of the editor's landmarks.
  void set_landmark(std::size_t landmark) { landmark_ = landmark; }
  std::size_t landmark() const { return landmark_; }

  bool pressed(const ViewPoint& at) override;
  void dragged(const ViewPoint& at) override;
  void released(const ViewPoint& at) override;
  void hovered(const ViewPoint&) override {}

 signals:
  void picked();  ///< the button was let go

 private:
  bool pick(const ViewPoint& at);

  RegistrationEditor& editor_;
  bool picking_ = false;
  PickedSurface surface_ = PickedSurface::photograph;
  std::size_t landmark_ = 0;
};

}  // namespace gnathion
