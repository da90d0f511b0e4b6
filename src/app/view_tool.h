#pragma once

#include <Eigen/Core>
#include <QPoint>
#include <Qt>

namespace gnathion {

/// A place of the mouse in the 3D view, and the line of sight through it.
struct ViewPoint {
  QPoint pixel;               ///< logical, from the canvas' upper left corner
  Eigen::Vector3d eye;        ///< where the line begins, mm, LPS
  Eigen::Vector3d direction;  ///< of unit length, into the picture
  Qt::KeyboardModifiers modifiers;
};

/// What the left mouse button does in the 3D view in place of turning the camera, while the tool
/// is FaceView's. Called on the window's thread.
class ViewTool {
 public:
  virtual ~ViewTool() = default;
  /// Returns whether the tool takes the press: then it is told of the moves and of the release,
  /// and the camera stays. Otherwise the camera turns.
  virtual bool pressed(const ViewPoint& at) = 0;
  virtual void dragged(const ViewPoint& at) = 0;
  virtual void released(const ViewPoint& at) = 0;
  /// The mouse moves with no button down.
  virtual void hovered(const ViewPoint& at) = 0;
  /// The mouse has left the view, or another tool takes this one's place.
  virtual void left() {}
};

}  // namespace gnathion
