#include "app/display.h"

#include <QCoreApplication>
#include <QLocale>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <clocale>

#include <QVTKOpenGLNativeWidget.h>

#include "app/decimal_comma.h"

// Last: it defines words such as None and Bool.
#include <X11/Xlib.h>

namespace gnathion {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("display", text);
}

}  // namespace

QString display_problem() {
  const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
  if (!platform.isEmpty() && !platform.startsWith("xcb")) {
    return words(QT_TRANSLATE_NOOP("display",
                                   "QT_QPA_PLATFORM is \"%1\", but the 3D view needs X11; unset "
                                   "it, or set it to xcb"))
        .arg(QString::fromLocal8Bit(platform));
  }
  const QString advice = words(QT_TRANSLATE_NOOP(
      "display",
      "start it within a desktop session (over ssh: ssh -X), or use gnathion-cli, which needs no "
      "display"));
  const QByteArray name = qgetenv("DISPLAY");
  if (name.isEmpty())
    return words(QT_TRANSLATE_NOOP("display", "no display: DISPLAY is not set; %1")).arg(advice);
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) {
    return words(QT_TRANSLATE_NOOP("display", "the display \"%1\" cannot be reached; %2"))
        .arg(QString::fromLocal8Bit(name), advice);
  }
  XCloseDisplay(display);
  return {};
}

void prepare_graphics() {
  qputenv("QT_QPA_PLATFORM", "xcb");
  if (qEnvironmentVariableIsEmpty("QT_XCB_GL_INTEGRATION")) {
    qputenv("QT_XCB_GL_INTEGRATION", "xcb_glx");
  }
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

QString graphics_problem() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  const bool works = context.create() && context.makeCurrent(&surface);
  const auto version = context.format().version();
  if (works && version >= qMakePair(3, 2)) return {};
  return words(QT_TRANSLATE_NOOP("display",
                                 "the display gives no OpenGL 3.2; update its driver, or set "
                                 "LIBGL_ALWAYS_SOFTWARE=1 to draw without one"));
}

void use_c_numbers() {
  QLocale::setDefault(QLocale::c());
  std::setlocale(LC_NUMERIC, "C");
  accept_decimal_comma();
}

}  // namespace gnathion
