#include "app/decimal_comma.h"

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>

namespace gnathion {
namespace {

class CommaFilter : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease) return false;
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->text() != "," || qobject_cast<QDoubleSpinBox*>(watched) == nullptr) return false;
    QKeyEvent point(event->type(), Qt::Key_Period, key->modifiers(), ".", key->isAutoRepeat());
    QCoreApplication::sendEvent(watched, &point);
    return true;
  }
};

}  // namespace

void accept_decimal_comma() {
  QCoreApplication* app = QCoreApplication::instance();
  app->installEventFilter(new CommaFilter(app));
}

}  // namespace gnathion
