#include "app/histogram_view.h"

#include <QFontMetrics>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "render/colour_map.h"

namespace gnathion {

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize HistogramView::sizeHint() const {
  return {240, 15 * fontMetrics().height() / 2};
}

void HistogramView::show_values(const Histogram& histogram, std::vector<Mark> marks,
                                double half_range) {
  histogram_ = histogram;
  marks_ = std::move(marks);
  half_range_ = half_range;
  words_.clear();
  low_ = std::min(histogram.low, 0.0);
  high_ = std::max(histogram.high(), low_ + histogram.width);
  for (const Mark& mark : marks_) {
    low_ = std::min(low_, mark.mm);
    high_ = std::max(high_, mark.mm);
  }
  update();
}

void HistogramView::show_words(const QString& words) {
  histogram_ = {};
  marks_.clear();
  words_ = words;
  update();
}

double HistogramView::place(double mm, const QRectF& plot) const {
  return plot.left() + plot.width() * (mm - low_) / (high_ - low_);
}

QColor HistogramView::bar_colour(double mm) const {
  if (half_range_ <= 0) return palette().color(QPalette::Highlight);
  const Eigen::Vector3d rgb = diverging_colour(mm / half_range_);
  return QColor::fromRgbF(rgb.x(), rgb.y(), rgb.z());
}

void HistogramView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int line = fontMetrics().height();
  if (histogram_.counts.empty()) {
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, words_);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF plot(line, 2.2 * line, width() - 2.0 * line, height() - 4.6 * line);
  paint_bars(painter, plot);
  paint_axis(painter, plot);
  paint_marks(painter, plot);
}

void HistogramView::paint_bars(QPainter& painter, const QRectF& plot) const {
  const auto most = static_cast<double>(histogram_.largest());
  painter.setPen(QPen(palette().color(QPalette::Mid), 0.6));
  for (std::size_t i = 0; i < histogram_.counts.size(); ++i) {
    if (histogram_.counts[i] == 0) continue;
    const double from = histogram_.low + histogram_.width * static_cast<double>(i);
    const double tall =
        std::max(plot.height() * static_cast<double>(histogram_.counts[i]) / most, 1.0);
    const double left = place(from, plot), right = place(from + histogram_.width, plot);
    painter.setBrush(bar_colour(from + histogram_.width / 2));
    painter.drawRect(QRectF(left, plot.bottom() - tall, right - left, tall));
  }
}

void HistogramView::paint_axis(QPainter& painter, const QRectF& plot) const {
  const QFontMetrics metrics = fontMetrics();
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawLine(plot.bottomLeft(), plot.bottomRight());
  const double room = 2.2 * metrics.horizontalAdvance(QStringLiteral("-00.0"));
  const double wanted = (high_ - low_) * room / plot.width();
  const double unit = std::pow(10, std::floor(std::log10(wanted)));
  double step = 10 * unit;
  for (const double round : {5.0, 2.0, 1.0}) {
    if (round * unit >= wanted) step = round * unit;
  }
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  for (double k = std::ceil(low_ / step - 1e-9); k * step <= high_ + 1e-9 * step; ++k) {
    const double x = place(k * step, plot);
    painter.drawLine(QPointF(x, plot.bottom()), QPointF(x, plot.bottom() + 4));
    QString text = QLocale().toString(k == 0 ? 0.0 : k * step, 'f', decimals);
    text.replace('-', QChar(0x2212));
    const double half = room;
    painter.drawText(QRectF(x - half, plot.bottom() + 4, 2 * half, metrics.height()),
                     Qt::AlignHCenter | Qt::AlignTop, text);
  }
  painter.drawText(QRectF(0, height() - metrics.height(), width(), metrics.height()),
                   Qt::AlignCenter, tr("mm, number of points of the region"));
}

void HistogramView::paint_marks(QPainter& painter, const QRectF& plot) const {
  const QFontMetrics metrics = fontMetrics();
  double free_from[2] = {0, 0};  // of two rows of names
  std::vector<Mark> ordered = marks_;
  std::sort(ordered.begin(), ordered.end(),
            [](const Mark& a, const Mark& b) { return a.mm < b.mm; });
  for (const Mark& mark : ordered) {
    const double x = place(mark.mm, plot);
    const double wide = metrics.horizontalAdvance(mark.name);
    const double left = std::clamp(x - wide / 2, 0.0, std::max(width() - wide, 0.0));
    const int row = left >= free_from[0] ? 0 : 1;
    free_from[row] = left + wide + 6;
    const double base = plot.top() - (row == 0 ? 2 : 2 + metrics.height());
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1, Qt::DashLine));
    painter.drawLine(QPointF(x, base), QPointF(x, plot.bottom()));
    painter.drawText(QPointF(left, base - metrics.descent() / 2.0), mark.name);
  }
}

}  // namespace gnathion
