#include "app/picture_pane.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace gnathion {
namespace {

constexpr double kStep = 1.25;   // of the zoom
constexpr double kLargest = 20;  // widget's pixels for one of the photograph
constexpr double kArrow = 40;    // widget's pixels
const QColor kPicked(255, 200, 40), kChosen(255, 110, 30), kComputed(90, 220, 255);

QPointF point(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

}  // namespace

PicturePane::PicturePane(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  setMinimumSize(240, 240);
}

void PicturePane::show_photo(std::shared_ptr<const Photo> photo, const QString& words) {
  words_ = words;
  if (photo != photo_) {
    photo_ = std::move(photo);
    image_ = photo_ ? QImage(photo_->rgb.data(), photo_->width, photo_->height, 3 * photo_->width,
                             QImage::Format_RGB888)
                    : QImage();
    show_whole();
  }
  update();
}

void PicturePane::show_marks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  update();
}

QPointF PicturePane::place_of(const Eigen::Vector2d& pixel) const {
  return corner_ + zoom_ * point(pixel.array() + 0.5);
}

Eigen::Vector2d PicturePane::pixel_at(const QPointF& place) const {
  const QPointF p = (place - corner_) / zoom_;
  return {p.x() - 0.5, p.y() - 0.5};
}

double PicturePane::whole_zoom() const {
  return image_.isNull()
             ? 1
             : std::min(width() / double(image_.width()), height() / double(image_.height()));
}

void PicturePane::show_whole() {
  whole_ = true;
  zoom_ = whole_zoom();
  corner_ = QPointF(width() - zoom_ * image_.width(), height() - zoom_ * image_.height()) / 2;
  update();
}

void PicturePane::zoom_about(const QPointF& place, double factor) {
  if (image_.isNull()) return;
  const double zoom = std::clamp(zoom_ * factor, whole_zoom(), std::max(kLargest, whole_zoom()));
  if (zoom <= whole_zoom()) return show_whole();
  corner_ = place + (corner_ - place) * (zoom / zoom_);
  zoom_ = zoom;
  whole_ = false;
  update();
}

void PicturePane::resizeEvent(QResizeEvent*) {
  if (whole_ || zoom_ < whole_zoom()) show_whole();
}

void PicturePane::wheelEvent(QWheelEvent* event) {
  zoom_about(event->position(), std::pow(kStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void PicturePane::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->pos();
  moved_ = false;
}

void PicturePane::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) return;
  moved_ =
      moved_ || (event->pos() - pressed_).manhattanLength() > QApplication::startDragDistance();
  if (!moved_) return;
  corner_ += event->pos() - last_;
  last_ = event->pos();
  whole_ = false;
  update();
}

void PicturePane::mouseReleaseEvent(QMouseEvent* event) {
  if (moved_ || image_.isNull() || event->button() != Qt::LeftButton) return;
  const Eigen::Vector2d pixel = pixel_at(event->localPos());
  const bool inside = pixel.minCoeff() > -0.5 && pixel.x() < image_.width() - 0.5 &&
                      pixel.y() < image_.height() - 0.5;
  if (inside) emit clicked(pixel);
}

void PicturePane::keyPressEvent(QKeyEvent* event) {
  const QPointF middle(width() / 2.0, height() / 2.0);
  const auto move = [this](double x, double y) {
    corner_ += QPointF(x, y);
    whole_ = false;
    update();
  };
  switch (event->key()) {
    case Qt::Key_Plus:
      return zoom_about(middle, kStep);
    case Qt::Key_Minus:
      return zoom_about(middle, 1 / kStep);
    case Qt::Key_0:
      return show_whole();
    case Qt::Key_Left:
      return move(kArrow, 0);
    case Qt::Key_Right:
      return move(-kArrow, 0);
    case Qt::Key_Up:
      return move(0, kArrow);
    case Qt::Key_Down:
      return move(0, -kArrow);
    default:
      QWidget::keyPressEvent(event);
  }
}

void PicturePane::paint_mark(QPainter& painter, const Mark& mark) const {
  const QPointF at = place_of(mark.pixel);
  if (mark.computed) {
    const QPointF there = place_of(*mark.computed);
    painter.setPen(QPen(kComputed, 1.5));
    painter.drawLine(at, there);
    painter.drawEllipse(there, 3, 3);
  }
  const double arm = mark.chosen ? 10 : 7;
  for (const auto& [colour, width] :
       {std::pair(QColor(0, 0, 0, 160), 3.0), std::pair(mark.chosen ? kChosen : kPicked, 1.5)}) {
    painter.setPen(QPen(colour, width));
    painter.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
    painter.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
  }
  const QRectF words = painter.fontMetrics().boundingRect(mark.words);
  const QPointF base = at + QPointF(9, -5);
  painter.fillRect(words.translated(base).adjusted(-2, 0, 2, 0), QColor(0, 0, 0, 130));
  painter.setPen(Qt::white);
  painter.drawText(base, mark.words);
}

void PicturePane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Dark));
  if (image_.isNull()) {
    painter.setPen(palette().color(QPalette::BrightText));
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap, words_);
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom_ < 4);
  painter.drawImage(QRectF(corner_, zoom_ * QSizeF(image_.size())), image_);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Mark& mark : marks_) paint_mark(painter, mark);
}

}  // namespace gnathion
