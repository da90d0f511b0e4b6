#pragma once

#include <Eigen/Core>
#include <QList>
#include <QTimer>
#include <QWidget>
#include <array>
#include <memory>
#include <string>

#include "render/crosshair_mark.h"
#include "render/orientation_cube.h"
#include "render/scale_bar.h"
#include "render/slice_scene.h"

class QMouseEvent;

namespace Ui {
class ViewGrid;
}

namespace gnathion {

struct BoneSegment;
class CaseController;
class FaceView;
class SliceView;

/// The 3D view and beside it an axial, a coronal and a sagittal slice of the CT, linked by one
/// crosshair and one window of Hounsfield units. A double click gives a view all the room, another
/// gives it back. Shift and the mouse over the 3D view set the crosshair where it points. The
/// slices follow the motion when it rests, so that a drag is not slowed.
class ViewGrid : public QWidget {
  Q_OBJECT
 public:
  explicit ViewGrid(QWidget* parent = nullptr);
  ~ViewGrid() override;
  /// Once. The grid takes the view in; both must outlive it.
  void set_up(CaseController& controller, FaceView& view);

  SliceView& slice(SlicePlane plane) const;
  const Eigen::Vector3d& crosshair() const { return crosshair_; }
  /// To the nearest place of the CT's lattice, mm, LPS. Nothing without a case.
  void set_crosshair(const Eigen::Vector3d& lps);
  const HuWindow& hu_window() const { return hu_window_; }
  void set_hu_window(const HuWindow& window);

  void set_slices_visible(bool visible);
  void set_outlines_visible(bool visible);
  /// The only view to be seen: the 3D view or a slice; null: all of them.
  void maximise(QWidget* view);
  QWidget* maximised() const { return maximised_; }
  /// The view that has the focus gets all the room (the 3D view where none has), or gives it back.
  void toggle_maximised();
  /// Of the slice that has the focus, else of the 3D view; above 1: larger.
  void zoom(double factor);
  /// Every slice shows the patient whole again.
  void fit_slices();

 signals:
  void outlines_toggled(bool visible);
  void maximised_changed(bool maximised);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::array<SliceView*, 3> slices() const;
  SliceView* focused_slice() const;
  void connect_slices();
  void connect_controller();
  void keep_sizes();
  void lay_out();
  bool slices_shown() const;
  void take_case(bool another);
  void take_surfaces();
  void take_motion();
  void point_at(const QMouseEvent& mouse);
  static std::string segment_words(const BoneSegment& segment);
  void show_hu_window();

  std::unique_ptr<Ui::ViewGrid> ui_;
  CaseController* controller_ = nullptr;
  FaceView* face_view_ = nullptr;
  SliceScene scene_;
  OrientationCube cube_;
  ScaleBar scale_bar_;
  CrosshairMark mark_;
  Eigen::Vector3d crosshair_{0, 0, 0};
  HuWindow hu_window_ = bone_window;
  bool slices_visible_ = true;
  QWidget* maximised_ = nullptr;
  bool divided_ = true;  ///< all four views are there
  QList<int> view_sizes_, slice_sizes_;
  QTimer rest_;                ///< runs out when the motion has rested
  bool motion_stale_ = false;  ///< the slices show an older motion than the model's
};

}  // namespace gnathion
