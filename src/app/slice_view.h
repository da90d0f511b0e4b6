#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QLineF>
#include <QVector>
#include <QWidget>
#include <vector>

#include "render/slice_scene.h"

class QPainter;

namespace gnathion {

/// One slice of the CT with outlines, crosshair, letters and scale: the slice through the
/// crosshair. Wheel and arrow keys go from slice to slice, the left button moves the crosshair, the
/// right one (or Ctrl and left) the window of Hounsfield units, the middle one the picture; Ctrl
/// and wheel zoom. It reports what the mouse chooses and shows what it is told.
class SliceView : public QWidget {
  Q_OBJECT
 public:
  explicit SliceView(QWidget* parent = nullptr);
  /// Once, before anything else. The scene must outlive the view.
  void set_up(SlicePlane plane, const SliceScene& scene);

  SlicePlane plane() const { return plane_; }
  /// mm, LPS, a place of the scene's lattice.
  void set_crosshair(const Eigen::Vector3d& lps);
  const Eigen::Vector3d& crosshair() const { return crosshair_; }
  void set_hu_window(const HuWindow& window);
  void set_outlines_visible(bool visible);

  /// The scene has another volume: all is computed anew when it is next painted.
  void volume_changed();
  /// The scene has other surfaces, poses or points.
  void outlines_changed();

  /// The patient in the middle of the view, also after it has another size.
  void fit();
  /// Above 1: larger, about a place of the widget that stays where it is.
  void zoom(double factor, QPointF about);
  void zoom(double factor) { zoom(factor, QRectF(rect()).center()); }
  /// Logical pixels a mm.
  double scale() const;

  /// The place in the slice under a place of the widget (logical pixels), mm, LPS.
  Eigen::Vector3d lps_at(QPointF pixel) const;
  QPointF pixel_of(const Eigen::Vector3d& lps) const;
  /// What stands at the lower edge: place and HU under the cursor, or else at the crosshair.
  QString readout() const;

 signals:
  void crosshair_chosen(const Eigen::Vector3d& lps);
  void hu_window_chosen(const gnathion::HuWindow& window);
  void maximise_asked();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  QSize sizeHint() const override { return {260, 220}; }
  QSize minimumSizeHint() const override { return {140, 110}; }

 private:
  enum class Drag { none, crosshair, hu_window, shift };
  void refresh();
  void refresh_outlines();
  void step(int slices);
  bool handle_arrow(int key, Qt::KeyboardModifiers modifiers);
  void move_in_plane(int right, int down);
  void change_window(double wider, double higher);
  QRectF rect_of(const LpsBox& box) const;
  QRectF slice_rect() const;
  QRect readout_rect() const;
  void paint_slice(QPainter& painter);
  void paint_outlines(QPainter& painter);
  void paint_crosshair(QPainter& painter) const;
  void paint_letters(QPainter& painter) const;
  void paint_words(QPainter& painter) const;
  void paint_legend(QPainter& painter) const;
  void paint_scale_bar(QPainter& painter) const;

  struct Outline {
    QString name;
    QColor colour;
    QVector<QLineF> lines;  ///< picture mm
  };

  SlicePlane plane_ = SlicePlane::axial;
  const SliceScene* scene_ = nullptr;
  Eigen::Vector3d crosshair_{0, 0, 0};
  HuWindow window_ = bone_window;
  bool outlines_visible_ = true;

  CtSlice slice_;
  std::vector<std::uint8_t> greys_;
  QImage image_;   ///< the slice in greys
  QImage scaled_;  ///< likewise where it is shown smaller than it is
  QVector<Outline> outlines_;
  bool slice_stale_ = true, greys_stale_ = true, outlines_stale_ = true;

  double scale_ = 0;              ///< 0: the slice fits the view
  Eigen::Vector2d centre_{0, 0};  ///< of the view, picture mm; where it does not fit
  Drag drag_ = Drag::none;
  QPointF drag_from_;
  Eigen::Vector2d drag_centre_{0, 0};
  HuWindow drag_window_;
  bool hovered_ = false;
  QPointF cursor_;
  int wheel_rest_ = 0;  ///< of a notch, eighths of a degree
};

}  // namespace gnathion
