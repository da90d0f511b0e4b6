#pragma once

#include <QObject>
#include <QTimer>

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace gnathion {

/// The camera of the 3D view by mouse and keys: left button turns (Ctrl: about the line of sight,
/// Shift: shifts), middle shifts, right and wheel zoom.
class CameraMouse : public QObject {
  Q_OBJECT
 public:
  /// Takes the interactor's style. Both must outlive this.
  CameraMouse(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer,
              QObject* parent = nullptr);

  /// The eye goes round what it looks at, degrees: to the picture's right, and up.
  void turn(double right_deg, double up_deg);
  /// Above 1: nearer, so that things look that much larger, within sensible distances.
  void zoom(double factor);
  /// Frames are quick for a while, as if the camera moved: something else follows the mouse.
  void hurry();

 signals:
  /// The camera begins to move, or rests again: frames should be quick meanwhile.
  void moving(bool moves);
  /// Moved by turn(), zoom() or the wheel: a frame is due. (VTK draws those of a drag itself.)
  void moved();

 private:
  vtkRenderer* renderer_;
  QTimer rest_;  ///< runs out when neither wheel nor keys have moved the camera for a while
};

}  // namespace gnathion
