#include "app/page_scroll.h"

#include <QEvent>
#include <QScrollBar>

namespace gnathion {

PageScroll::PageScroll(QWidget* parent) : QScrollArea(parent) {
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);  // its inputs take the focus
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidgetResizable(true);
}

QSize PageScroll::minimumSizeHint() const {
  QSize least = QScrollArea::minimumSizeHint();
  if (widget() != nullptr) {
    const int page = widget()->minimumSizeHint().width();
    least.setWidth(page + verticalScrollBar()->sizeHint().width());
  }
  return least;
}

bool PageScroll::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

}  // namespace gnathion
