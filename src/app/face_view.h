#pragma once

#include <Eigen/Core>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/case_controller.h"
#include "app/view_tool.h"
#include "render/face_scene.h"
#include "render/picture.h"
#include "render/segment_handle.h"

class QVTKOpenGLNativeWidget;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace gnathion {

class CameraMouse;

/// The 3D view: textured face, skull, the segments in their poses, and the grips that move one. It
/// shows what it is given and reports what the mouse does; it holds no model.
class FaceView : public QWidget {
  Q_OBJECT
 public:
  explicit FaceView(QWidget* parent = nullptr);
  ~FaceView() override;

  /// Replaces everything shown by what was made ready beside the window.
  void show_case(const LoadedCase& loaded);
  /// The segment that the grips belong to: one of the case's.
  void set_active_segment(std::size_t segment);
  /// The segments moved and the face with them. translation: of the active one, mm, LPS.
  void show_response(const Response& response, const Eigen::Vector3d& translation);
  void set_caption(const QString& caption);
  /// A frame of a film in place of the response and its caption, until end_film(). face: n×3, mm,
  /// LPS.
  void show_film(const Points& face, const QString& caption);
  void end_film();
  /// Colours for the signed change of the face, n values in mm; they stay until others come.
  void set_change(const Eigen::VectorXd& signed_mm);
  /// The colours no longer belong to the motion shown; the caption says so.
  void mark_change_outdated();

  void look_from(CameraPreset view);
  /// For turning and zooming other than by the mouse.
  CameraMouse& camera_mouse() { return *camera_mouse_; }
  void set_face_opacity(double opacity);
  double face_opacity() const { return face_opacity_; }
  void set_face_textured(bool textured);
  void set_bone_visible(bool visible);
  void set_colour_map_visible(bool visible);
  bool is_colour_map_visible() const { return colour_map_; }
  /// mm at the ends of the colour map; 0: a round number that fits what is shown.
  void set_change_range(double half_range_mm);
  /// true: face and segments where they were before any motion, until it is switched off.
  void set_before_visible(bool visible);
  bool is_before_visible() const { return before_; }

  /// About which the rings turn the active segment, mm, LPS, where it is without any motion; none:
  /// there are no rings.
  void set_pivot(const std::optional<Eigen::Vector3d>& pivot) { handle_.set_pivot(pivot); }
  /// The grips keep to one of the patient's axes (0 left–right, 1 front–back, 2 up–down).
  void set_axis_lock(std::optional<int> axis) { handle_.set_axis_lock(axis); }
  bool is_grip_held() const { return handle_.is_held(); }

  /// The left button goes to `tool` first, until another is set; null: the camera only. The tool
  /// must outlive the view or be unset. The grips of the segment are hidden meanwhile.
  void set_tool(ViewTool* tool);
  ViewTool* tool() const { return tool_; }
  /// The line of sight through a place of the canvas (logical pixels).
  ViewPoint view_point(QPoint pixel, Qt::KeyboardModifiers modifiers = {}) const;
  /// Where the surface lies that is seen at a place of the canvas (logical pixels), skin or bone,
  /// mm, LPS, as in the frame drawn last; none beside the patient and on a grip.
  std::optional<Eigen::Vector3d> place_at(QPoint pixel) const;
  /// Draws a frame when the event loop comes round: for whoever adds actors to renderer().
  void render_soon();

  /// What is shown, without the grips, in the screen's own pixels or (scale 2, 3…) so many times as
  /// many each way.
  Picture picture(int scale = 1);
  vtkRenderer* renderer() const { return scene_.renderer(); }
  vtkRenderWindowInteractor* interactor() const;
  FaceScene& scene() { return scene_; }
  /// The face as it is shown: at rest, moved, or a frame of a film. n×3, mm, LPS.
  const Points& face_points() const;
  /// The words in the picture's corner.
  const QString& caption() const { return shown_caption_; }
  /// The widget that receives the mouse.
  QWidget* canvas() const;

 signals:
  /// translation: of the segment, mm, LPS, while the mouse moves.
  void segment_dragged(const Eigen::Vector3d& translation);
  /// A ring was turned about one of the patient's axes, degrees since it was taken, right-handed.
  void segment_turned(int axis, double degrees);
  void drag_ended();
  /// The face's opacity, or whether the state before the motion is shown.
  void look_changed();
  void colour_map_switched(bool visible);
  /// After show_case(): whoever adds to the scene sets its parts up anew.
  void case_shown();
  void face_points_changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void set_up_camera_mouse();
  void set_quick(bool quick);
  bool is_film() const { return film_face_.rows() > 0; }
  void draw_larger(int scale, Picture& picture);
  void show_anatomy(const LoadedCase& loaded);
  void show_points();
  void show_caption();
  void show_change();
  void update_handle();
  double aspect_ratio() const;

  QVTKOpenGLNativeWidget* canvas_;
  CameraMouse* camera_mouse_ = nullptr;
  FaceScene scene_;
  SegmentHandle handle_;
  QTimer render_timer_;  ///< many changes in one turn of the event loop: one frame
  std::shared_ptr<const Anatomy> shown_anatomy_;
  Points rest_;
  Response response_;
  QString caption_;        ///< of the response
  QString shown_caption_;  ///< in the picture
  Points film_face_;       ///< empty: no film is shown
  QString film_caption_;
  std::vector<std::string> segments_;          ///< their names in the scene
  std::vector<Eigen::Vector3d> handle_homes_;  ///< of the segments
  Eigen::VectorXd change_;
  bool bone_visible_ = true;
  bool change_outdated_ = true;
  bool colour_map_ = false;
  double change_range_ = 0;
  bool before_ = false;
  double face_opacity_ = 1;
  bool dragging_ = false;
  ViewTool* tool_ = nullptr;
  bool tool_drags_ = false;
};

}  // namespace gnathion
