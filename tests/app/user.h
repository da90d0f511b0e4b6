#pragma once

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QPainter>
#include <QPixmap>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>

#include <vtkRenderer.h>

#include "app/face_view.h"
#include "app/main_window.h"

namespace gnathion::test {

/// The window as a user has it: widgets by their names, mouse and keyboard.
struct User {
  static constexpr int patience = 240000;  // ms, for work beside the window

  MainWindow& window;

  template <typename T>
  T* find(const char* name) const {
    T* found = window.findChild<T*>(name);
    if (found == nullptr) qFatal("no widget %s", name);
    return found;
  }
  CaseController& model() const { return window.controller(); }
  QAction* action(const char* name) const { return find<QAction>(name); }
  QOpenGLWidget* canvas() const { return find<QOpenGLWidget>("face_canvas"); }

  void choose_step(const char* page) const {
    auto* steps = find<QTabWidget>("steps");
    for (int i = 0; i < steps->count(); ++i) {
      if (steps->widget(i)->objectName() == page) return steps->setCurrentIndex(i);
    }
    qFatal("no step %s", page);
  }
  /// Scrolled to, as a hand would before it clicks.
  void click(const char* button) const {
    auto* widget = find<QAbstractButton>(button);
    if (!widget->isEnabled()) qFatal("%s is disabled", button);
    for (QWidget* outer = widget->parentWidget(); outer; outer = outer->parentWidget()) {
      if (auto* area = qobject_cast<QScrollArea*>(outer)) area->ensureWidgetVisible(widget);
    }
    QTest::mouseClick(widget, Qt::LeftButton);
  }
  void type(const char* box, const QString& text) const {
    auto* spin = find<QAbstractSpinBox>(box);
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }
  void settle() const { QTRY_VERIFY_WITH_TIMEOUT(!model().is_working(), patience); }

  /// Answers the file dialog that an action opens.
  void answer(const char* action_name, const char* dialog_name, const QString& file) const {
    action(action_name)->trigger();
    auto* dialog = find<QFileDialog>(dialog_name);
    // Not typed letter by letter: the completer's popup would take the click on the button.
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
    auto* buttons = dialog->findChild<QDialogButtonBox*>("buttonBox");
    for (QAbstractButton* button : buttons->buttons()) {
      if (buttons->buttonRole(button) != QDialogButtonBox::AcceptRole) continue;
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
    QTRY_VERIFY(window.findChild<QFileDialog*>(dialog_name) == nullptr);
  }

  /// Where a point in space is on the canvas.
  QPoint pixel_of(const Eigen::Vector3d& place) const {
    vtkRenderer* renderer = window.face_view().renderer();
    renderer->SetWorldPoint(place.x(), place.y(), place.z(), 1);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    const double ratio = canvas()->devicePixelRatioF();
    return {static_cast<int>(at[0] / ratio),
            canvas()->height() - 1 - static_cast<int>(at[1] / ratio)};
  }
  /// The mouse from one place of the canvas to another, by steps; `while_down` before it is let go.
  template <typename WhileDown>
  void drag(QPoint from, QPoint to, WhileDown while_down) const {
    QTest::mouseMove(canvas(), from);
    QTest::mousePress(canvas(), Qt::LeftButton, {}, from);
    for (int step = 1; step <= 6; ++step) {
      const QPoint at = from + (to - from) * step / 6;
      // QTest::mouseMove tells no button; a user's mouse does.
      QMouseEvent move(QEvent::MouseMove, at, canvas()->mapToGlobal(at), Qt::NoButton,
                       Qt::LeftButton, {});
      QApplication::sendEvent(canvas(), &move);
    }
    while_down();
    QTest::mouseRelease(canvas(), Qt::LeftButton, {}, to);
  }
  void drag(QPoint from, QPoint to) const {
    drag(from, to, [] {});
  }
  /// Mean place of the yellow grip's pixels on the canvas.
  QPoint grip() const {
    const QImage image = canvas()->grabFramebuffer();
    double x = 0, y = 0;
    int count = 0;
    for (int row = 0; row < image.height(); ++row) {
      for (int column = 0; column < image.width(); ++column) {
        const QColor colour = image.pixelColor(column, row);
        if (colour.red() < 180 || colour.green() < 110 || colour.blue() > 60) continue;
        x += column;
        y += row;
        ++count;
      }
    }
    if (count < 20) qFatal("the grip is not to be seen");
    const double ratio = canvas()->devicePixelRatioF();
    return {static_cast<int>(x / count / ratio), static_cast<int>(y / count / ratio)};
  }

  /// A picture of the window NAME.png into the folder $GNATHION_SHOTS, where that is set.
  void shoot(const char* name) const {
    const QString folder = qEnvironmentVariable("GNATHION_SHOTS");
    if (folder.isEmpty()) return;
    QTest::qWait(400);
    QPixmap picture = window.grab();
    if (canvas()->isVisible()) {
      QPainter painter(&picture);
      painter.drawImage(QRect(canvas()->mapTo(&window, QPoint()), canvas()->size()),
                        canvas()->grabFramebuffer());
    }
    picture.save(folder + "/" + name + ".png");
  }
};

}  // namespace gnathion::test
