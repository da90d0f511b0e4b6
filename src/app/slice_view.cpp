#include "app/slice_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/scale_bar.h"

namespace gnathion {
namespace {

constexpr int margin = 6;   // logical pixels, of words from the view's edges
constexpr int notch = 120;  // eighths of a degree: a step of a mouse's wheel
constexpr int page = 10;    // slices
constexpr double key_zoom = 1.25;
constexpr double least_scale = 0.2, most_scale = 60;  // pixels a mm
const QColor crosshair_colour(120, 255, 120, 170);
const QColor words_colour(225, 230, 235);
const QColor letter_colour(255, 214, 90);

/// "L 12.3" for a coordinate and the letters of its positive and negative sense.
QString side_words(double mm, char positive, char negative) {
  return QString("%1 %2").arg(QChar(mm < 0 ? negative : positive)).arg(std::abs(mm), 0, 'f', 1);
}

QString place_words(const Eigen::Vector3d& lps) {
  return side_words(lps.x(), 'L', 'R') + "  " + side_words(lps.y(), 'P', 'A') + "  " +
         side_words(lps.z(), 'S', 'I') + " mm";
}

/// Words that can be read on any grey.
void draw_words(QPainter& painter, const QRect& box, int flags, const QString& text,
                const QColor& colour) {
  painter.setPen(QColor(0, 0, 0, 200));
  painter.drawText(box.translated(1, 1), flags, text);
  painter.setPen(colour);
  painter.drawText(box, flags, text);
}

}  // namespace

SliceView::SliceView(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setCursor(Qt::CrossCursor);
}

void SliceView::set_up(SlicePlane plane, const SliceScene& scene) {
  plane_ = plane;
  scene_ = &scene;
}

void SliceView::set_crosshair(const Eigen::Vector3d& lps) {
  const int axis = normal_axis(plane_);
  if (lps(axis) != crosshair_(axis)) slice_stale_ = outlines_stale_ = true;
  crosshair_ = lps;
  update();
}

void SliceView::set_hu_window(const HuWindow& window) {
  window_ = window;
  greys_stale_ = true;
  update();
}

void SliceView::set_outlines_visible(bool visible) {
  outlines_visible_ = visible;
  update();
}

void SliceView::volume_changed() {
  slice_stale_ = outlines_stale_ = true;
  fit();
}

void SliceView::outlines_changed() {
  outlines_stale_ = true;
  update();
}

void SliceView::fit() {
  scale_ = 0;
  update();
}

QRectF SliceView::rect_of(const LpsBox& box) const {
  const Eigen::Vector2d a = picture_from_lps(plane_, box.min);
  const Eigen::Vector2d b = picture_from_lps(plane_, box.max);
  return QRectF(QPointF(a.x(), a.y()), QPointF(b.x(), b.y())).normalized();
}

QRectF SliceView::slice_rect() const {
  const SliceLattice& lattice = scene_->lattice();
  return rect_of({lattice.origin - lattice.step / 2, lattice.last() + lattice.step / 2});
}

double SliceView::scale() const {
  if (scale_ > 0 || !scene_->has_volume()) return std::max(scale_, least_scale);
  const QRectF subject = rect_of(scene_->subject());
  return std::clamp(std::min(width() / subject.width(), height() / subject.height()), least_scale,
                    most_scale);
}

Eigen::Vector3d SliceView::lps_at(QPointF pixel) const {
  const QPointF off = (pixel - QRectF(rect()).center()) / scale();
  Eigen::Vector2d centre = centre_;
  if (scale_ == 0 && scene_->has_volume()) {
    const QPointF middle = rect_of(scene_->subject()).center();
    centre = {middle.x(), middle.y()};
  }
  return lps_from_picture(plane_, centre + Eigen::Vector2d(off.x(), off.y()), crosshair_);
}

QPointF SliceView::pixel_of(const Eigen::Vector3d& lps) const {
  const Eigen::Vector2d middle = picture_from_lps(plane_, lps_at(QRectF(rect()).center()));
  const Eigen::Vector2d off = scale() * (picture_from_lps(plane_, lps) - middle);
  return QRectF(rect()).center() + QPointF(off.x(), off.y());
}

void SliceView::zoom(double factor, QPointF about) {
  const Eigen::Vector2d fixed = picture_from_lps(plane_, lps_at(about));
  scale_ = std::clamp(scale() * factor, least_scale, most_scale);
  const QPointF off = (about - QRectF(rect()).center()) / scale_;
  centre_ = fixed - Eigen::Vector2d(off.x(), off.y());
  update();
}

QString SliceView::readout() const {
  if (!scene_->has_volume()) return {};
  const Eigen::Vector3d at = hovered_ ? lps_at(cursor_) : crosshair_;
  const double hu = scene_->volume().sample(scene_->lattice().nearest(at),
                                            std::numeric_limits<double>::quiet_NaN());
  const Eigen::Array3d beyond = (at - scene_->lattice().nearest(at)).array().abs();
  const bool outside =
      std::isnan(hu) || (beyond > scene_->lattice().step.array() * 0.5 + 1e-6).any();
  return place_words(at) + "   " + (outside ? tr("no CT here") : tr("%1 HU").arg(std::lround(hu)));
}

void SliceView::refresh() {
  if (slice_stale_) scene_->cut(plane_, crosshair_, slice_);
  if (slice_stale_ || greys_stale_) {
    grey_slice(slice_, window_, greys_);
    if (image_.size() != QSize(slice_.width, slice_.height)) {
      image_ = QImage(slice_.width, slice_.height, QImage::Format_RGB32);
    }
    const std::uint8_t* grey = greys_.data();
    for (int y = 0; y < slice_.height; ++y) {
      auto* row = reinterpret_cast<QRgb*>(image_.scanLine(y));
      for (int x = 0; x < slice_.width; ++x, ++grey) row[x] = qRgb(*grey, *grey, *grey);
    }
    scaled_ = {};
  }
  slice_stale_ = greys_stale_ = false;
}

void SliceView::refresh_outlines() {
  if (!outlines_stale_) return;
  outlines_stale_ = false;
  outlines_.clear();
  for (const SliceContour& contour : scene_->contours(plane_, crosshair_)) {
    const Eigen::Vector3d& c = contour.colour;
    Outline outline{
        QString::fromStdString(contour.name), QColor::fromRgbF(c.x(), c.y(), c.z()), {}};
    outline.lines.reserve(static_cast<int>(contour.lines.size()));
    for (const auto& [a, b] : contour.lines) {
      outline.lines.append(QLineF(a.x(), a.y(), b.x(), b.y()));
    }
    outlines_.append(outline);
  }
}

void SliceView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (scene_ == nullptr || !scene_->has_volume()) return;
  refresh();
  paint_slice(painter);
  if (outlines_visible_) paint_outlines(painter);
  paint_crosshair(painter);
  paint_letters(painter);
  paint_scale_bar(painter);
  paint_words(painter);
  if (hasFocus()) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
  }
}

void SliceView::paint_slice(QPainter& painter) {
  const QRectF slice = slice_rect();
  const Eigen::Vector2d corner(slice.left(), slice.top());
  const QPointF at = pixel_of(lps_from_picture(plane_, corner, crosshair_));
  const QRectF target(at, slice.size() * scale());
  const QSize pixels = (target.size() * devicePixelRatioF()).toSize();
  // The painter looks at four pixels for each of the screen, too few where the slice gets smaller.
  if (pixels.width() < slice_.width || pixels.height() < slice_.height) {
    if (scaled_.size() != pixels) {
      scaled_ = image_.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(target, scaled_);
  } else {
    painter.setRenderHint(QPainter::SmoothPixmapTransform, true);
    painter.drawImage(target, image_);
  }
}

void SliceView::paint_outlines(QPainter& painter) {
  refresh_outlines();
  const QPointF zero = pixel_of(Eigen::Vector3d::Zero());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(zero);
  painter.scale(scale(), scale());
  for (const Outline& outline : outlines_) {
    QPen pen(outline.colour, devicePixelRatioF());  // of a cosmetic pen: in the screen's own pixels
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.drawLines(outline.lines);
  }
  painter.restore();
  paint_legend(painter);
}

void SliceView::paint_legend(QPainter& painter) const {
  constexpr int least_height = 400;  // in a smaller view it would cover the patient
  if (height() < least_height) return;
  const int line = painter.fontMetrics().height();
  QRect box = rect().adjusted(margin, margin + 2 * line, -margin, 0);
  for (const Outline& outline : outlines_) {
    draw_words(painter, box, Qt::AlignLeft | Qt::AlignTop, outline.name, outline.colour);
    box.adjust(0, line, 0, 0);
  }
}

void SliceView::paint_crosshair(QPainter& painter) const {
  constexpr double gap = 7;  // so that what lies at the cross can be seen
  const QPointF at = pixel_of(crosshair_);
  const QPointF p(std::floor(at.x()) + 0.5, std::floor(at.y()) + 0.5);
  painter.setPen(QPen(crosshair_colour, 1));
  painter.drawLine(QPointF(0, p.y()), QPointF(p.x() - gap, p.y()));
  painter.drawLine(QPointF(p.x() + gap, p.y()), QPointF(width(), p.y()));
  painter.drawLine(QPointF(p.x(), 0), QPointF(p.x(), p.y() - gap));
  painter.drawLine(QPointF(p.x(), p.y() + gap), QPointF(p.x(), height()));
}

void SliceView::paint_letters(QPainter& painter) const {
  const SliceLetters letters = letters_of(plane_);
  painter.save();
  QFont bold = painter.font();
  bold.setBold(true);
  bold.setPointSizeF(1.15 * bold.pointSizeF());
  painter.setFont(bold);
  QRect box = rect().adjusted(margin, margin, -margin, -margin);
  draw_words(painter, box, Qt::AlignLeft | Qt::AlignVCenter, QChar(letters.left), letter_colour);
  draw_words(painter, box, Qt::AlignRight | Qt::AlignVCenter, QChar(letters.right), letter_colour);
  draw_words(painter, box, Qt::AlignHCenter | Qt::AlignTop, QChar(letters.top), letter_colour);
  box.setBottom(readout_rect().top() - 2);
  draw_words(painter, box, Qt::AlignHCenter | Qt::AlignBottom, QChar(letters.bottom),
             letter_colour);
  painter.restore();
}

QRect SliceView::readout_rect() const {
  const int line = fontMetrics().height();
  return {0, height() - line - margin, width(), line + margin};
}

void SliceView::paint_words(QPainter& painter) const {
  const QString names[] = {tr("Axial"), tr("Coronal"), tr("Sagittal")};
  const char* const letters[] = {"LR", "PA", "SI"};
  const int axis = normal_axis(plane_);
  const QRect box = rect().adjusted(margin, margin, -margin, -margin / 2);
  draw_words(painter, box, Qt::AlignLeft | Qt::AlignTop,
             names[static_cast<int>(plane_)] + "\n" +
                 side_words(crosshair_(axis), letters[axis][0], letters[axis][1]) + " mm",
             words_colour);
  constexpr int room_for_the_window = 330;
  if (width() >= room_for_the_window || drag_ == Drag::hu_window) {
    draw_words(painter, box, Qt::AlignRight | Qt::AlignTop,
               tr("W %1\nL %2 HU").arg(std::lround(window_.width)).arg(std::lround(window_.level)),
               words_colour);
  }
  painter.fillRect(readout_rect(), QColor(0, 0, 0, 150));
  draw_words(painter, box, Qt::AlignLeft | Qt::AlignBottom, readout(), words_colour);
}

void SliceView::paint_scale_bar(QPainter& painter) const {
  const double mm = scale_bar_mm(scale(), 0.25 * width());
  const double y = readout_rect().top() - 4.5;
  const double right = width() - margin - 0.5;
  const double left = right - mm * scale();
  for (const auto& [colour, width] : {std::pair(QColor(0, 0, 0, 200), 3.0), {words_colour, 1.0}}) {
    painter.setPen(QPen(colour, width));
    painter.drawLine(QPointF(left, y), QPointF(right, y));
    painter.drawLine(QPointF(left, y - 3), QPointF(left, y + 3));
    painter.drawLine(QPointF(right, y - 3), QPointF(right, y + 3));
  }
  const int line = fontMetrics().height();
  draw_words(painter, QRect(0, static_cast<int>(y) - line - 3, width() - margin, line),
             Qt::AlignRight | Qt::AlignBottom, QString::fromStdString(scale_bar_words(mm)),
             words_colour);
}

void SliceView::step(int slices) {
  if (!scene_->has_volume()) return;
  const SliceAxes axes = axes_of(plane_);
  const double step_mm = std::abs(axes.onward.dot(scene_->lattice().step));
  emit crosshair_chosen(crosshair_ + slices * step_mm * axes.onward);
}

void SliceView::move_in_plane(int right, int down) {
  if (!scene_->has_volume()) return;
  const SliceAxes axes = axes_of(plane_);
  const Eigen::Vector3d step_mm = scene_->lattice().step;
  emit crosshair_chosen(
      crosshair_ + ((right * axes.right + down * axes.down).array() * step_mm.array()).matrix());
}

void SliceView::change_window(double wider, double higher) {
  emit hu_window_chosen(limited({drag_window_.level + higher * drag_window_.width / 300,
                                 drag_window_.width * std::pow(2, wider / 120)}));
}

void SliceView::wheelEvent(QWheelEvent* event) {
  wheel_rest_ += event->angleDelta().y();
  const int notches = wheel_rest_ / notch;
  wheel_rest_ -= notches * notch;
  event->accept();
  if (notches == 0) return;
  if (event->modifiers() & Qt::ControlModifier) {
    zoom(std::pow(1.2, notches), event->position());
  } else {
    step(notches);
  }
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  if (drag_ != Drag::none || !scene_->has_volume()) return;
  drag_from_ = event->localPos();
  drag_window_ = window_;
  const bool control = event->modifiers() & Qt::ControlModifier;
  if (event->button() == Qt::RightButton || (event->button() == Qt::LeftButton && control)) {
    drag_ = Drag::hu_window;
  } else if (event->button() == Qt::LeftButton) {
    drag_ = Drag::crosshair;
    emit crosshair_chosen(lps_at(drag_from_));
  } else if (event->button() == Qt::MiddleButton) {
    drag_ = Drag::shift;
    zoom(1);  // from here on the view keeps its place
    drag_centre_ = centre_;
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  hovered_ = true;
  cursor_ = event->localPos();
  const QPointF moved = cursor_ - drag_from_;
  switch (drag_) {
    case Drag::none:
      update(readout_rect());
      return;
    case Drag::crosshair:
      emit crosshair_chosen(lps_at(cursor_));
      return;
    case Drag::hu_window:
      change_window(moved.x(), -moved.y());
      return;
    case Drag::shift:
      centre_ = drag_centre_ - Eigen::Vector2d(moved.x(), moved.y()) / scale();
      update();
      return;
  }
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->buttons() != Qt::NoButton) return;
  drag_ = Drag::none;
  update();
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && event->modifiers() == Qt::NoModifier) {
    emit maximise_asked();
  } else {
    mousePressEvent(event);
  }
}

void SliceView::leaveEvent(QEvent*) {
  hovered_ = false;
  update(readout_rect());
}

bool SliceView::handle_arrow(int key, Qt::KeyboardModifiers modifiers) {
  const int right = key == Qt::Key_Right ? 1 : key == Qt::Key_Left ? -1 : 0;
  const int down = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
  if (right == 0 && down == 0) return false;
  if (modifiers & Qt::ShiftModifier) {
    move_in_plane(right, down);
  } else if (modifiers & Qt::ControlModifier) {
    drag_window_ = window_;
    change_window(12 * right, -12 * down);
  } else if (down != 0) {
    step(-down);
  } else {
    return false;
  }
  return true;
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  if (handle_arrow(event->key(), event->modifiers())) return;
  switch (event->key()) {
    case Qt::Key_PageUp:
      return step(page);
    case Qt::Key_PageDown:
      return step(-page);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(key_zoom);
    case Qt::Key_Minus:
      return zoom(1 / key_zoom);
    case Qt::Key_Home:
      return fit();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace gnathion
