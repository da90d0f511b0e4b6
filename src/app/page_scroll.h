#pragma once

#include <QScrollArea>

namespace gnathion {

/// A page that scrolls up and down only: never narrower than what stands on it and the bar beside
/// it, in any language.
class PageScroll : public QScrollArea {
  Q_OBJECT
 public:
  explicit PageScroll(QWidget* parent = nullptr);
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace gnathion
