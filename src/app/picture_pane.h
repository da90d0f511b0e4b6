#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "projection/photo.h"

namespace gnathion {

/// A photograph that is zoomed with the wheel (or + and −, 0 for all of it), moved by dragging (or
/// the arrow keys), and clicked. Places are its pixels, as PhotoLandmark::pixel.
class PicturePane : public QWidget {
  Q_OBJECT
 public:
  struct Mark {
    Eigen::Vector2d pixel;  ///< where it was picked
    QString words;
    bool chosen = false;
    std::optional<Eigen::Vector2d> computed;  ///< where the camera sees its place on the skin
  };

  explicit PicturePane(QWidget* parent = nullptr);

  /// Null: none, and `words` in its place.
  void show_photo(std::shared_ptr<const Photo> photo, const QString& words);
  void show_marks(std::vector<Mark> marks);
  const std::vector<Mark>& marks() const { return marks_; }

  QPointF place_of(const Eigen::Vector2d& pixel) const;  ///< in the widget
  Eigen::Vector2d pixel_at(const QPointF& place) const;
  double zoom() const { return zoom_; }  ///< of the widget's pixels to the photograph's
  QSize sizeHint() const override { return {520, 560}; }

 signals:
  void clicked(const Eigen::Vector2d& pixel);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double whole_zoom() const;
  void show_whole();
  void zoom_about(const QPointF& place, double factor);
  void paint_mark(QPainter& painter, const Mark& mark) const;

  std::shared_ptr<const Photo> photo_;
  QImage image_;  ///< the photo's own bytes
  QString words_;
  std::vector<Mark> marks_;
  double zoom_ = 1;
  QPointF corner_;  ///< of the picture's upper left corner in the widget
  bool whole_ = true;
  QPoint pressed_, last_;
  bool moved_ = false;
};

}  // namespace gnathion
