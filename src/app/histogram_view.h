#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <vector>

#include "geometry/histogram.h"

namespace gnathion {

/// A histogram with an axis in mm and marked values.
class HistogramView : public QWidget {
  Q_OBJECT
 public:
  struct Mark {
    double mm;
    QString name;
  };

  explicit HistogramView(QWidget* parent = nullptr);

  /// What is counted, the marks over it, and whether the bars have the colours of the colour map
  /// with these mm at its ends (0: one colour).
  void show_values(const Histogram& histogram, std::vector<Mark> marks, double half_range);
  /// No values: why.
  void show_words(const QString& words);

  const Histogram& histogram() const { return histogram_; }
  const std::vector<Mark>& marks() const { return marks_; }
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double place(double mm, const QRectF& plot) const;
  QColor bar_colour(double mm) const;
  void paint_bars(QPainter& painter, const QRectF& plot) const;
  void paint_axis(QPainter& painter, const QRectF& plot) const;
  void paint_marks(QPainter& painter, const QRectF& plot) const;

  Histogram histogram_;
  std::vector<Mark> marks_;
  double half_range_ = 0;
  double low_ = 0, high_ = 1;  ///< mm at the axis' ends
  QString words_;
};

}  // namespace gnathion
