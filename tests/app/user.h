#pragma once

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QPainter>
#include <QPixmap>
#include <QRadioButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QWheelEvent>

#include <vtkCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "app/face_view.h"
#include "app/main_window.h"

namespace gnathion::test {

/// How a mouse goes from one place to another.
struct Stroke {
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers keys = Qt::NoModifier;
  int steps = 6;
  QWidget* over = nullptr;  ///< null: the 3D view's canvas
};

/// The window as a user has it: widgets by their names, mouse and keyboard.
class User {
 public:
  static constexpr int patience = 240000;  // ms, for work beside the window

  User(MainWindow& window) : hand_on_(&window) {}

  MainWindow& window() const { return *hand_on_; }
  template <typename T>
  T* find(const char* name) const {
    T* found = window().findChild<T*>(name);
    if (found == nullptr) qFatal("no widget %s", name);
    return found;
  }
  CaseController& model() const { return window().controller(); }
  FaceView& view() const { return window().face_view(); }
  QAction* action(const char* name) const { return find<QAction>(name); }
  QDoubleSpinBox* box(const char* name) const { return find<QDoubleSpinBox>(name); }
  QOpenGLWidget* canvas() const { return find<QOpenGLWidget>("face_canvas"); }
  vtkCamera* camera() const { return view().renderer()->GetActiveCamera(); }
  QString label(const char* name) const { return find<QLabel>(name)->text(); }
  QString caption() const { return view().caption(); }
  bool message_visible() const { return find<QWidget>("message_bar")->isVisible(); }
  QString message() const {
    return label("message_title") + "\n" + label("message_text") + "\n" + label("message_remedy");
  }

  void trigger(const char* name) const { action(name)->trigger(); }
  /// The layout and the frame that are due, now.
  void draw() const {
    QApplication::processEvents();
    view().interactor()->Render();
  }
  void look_from(const char* name) const {
    trigger(name);
    draw();
  }
  /// A step of the operation, by its page or its title.
  void choose_step(const QString& page) const {
    auto* steps = find<QTabWidget>("steps");
    for (int i = 0; i < steps->count(); ++i) {
      const bool named = steps->widget(i)->objectName() == page;
      if (named || steps->tabText(i).remove('&') == page) return steps->setCurrentIndex(i);
    }
    qFatal("no step %s", qPrintable(page));
  }
  /// Scrolled to, as a hand would before it clicks.
  void click(const char* button) const {
    auto* widget = find<QAbstractButton>(button);
    if (!widget->isEnabled()) qFatal("%s is disabled", button);
    for (QWidget* outer = widget->parentWidget(); outer; outer = outer->parentWidget()) {
      if (auto* area = qobject_cast<QScrollArea*>(outer)) area->ensureWidgetVisible(widget);
    }
    // A box may be wider than its words, and is clicked only on them.
    const bool has_words = qobject_cast<QCheckBox*>(widget) || qobject_cast<QRadioButton*>(widget);
    QTest::mouseClick(widget, Qt::LeftButton, {},
                      has_words ? QPoint(8, widget->height() / 2) : QPoint());
  }
  void type(const char* box_name, const QString& text) const {
    auto* spin = find<QAbstractSpinBox>(box_name);
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }
  void settle() const { QTRY_VERIFY_WITH_TIMEOUT(!model().is_working(), patience); }
  void await_answer() const {
    QTRY_VERIFY_WITH_TIMEOUT(model().refinement() == Refinement::done, patience);
  }
  /// Opens a case, whatever becomes of the one that is open, and waits until that has ended.
  void open(const QString& file) const {
    window().open_case(file);
    settle();
  }

  /// Answers a file dialog that is open.
  void answer(const char* dialog_name, const QString& file) const {
    auto* dialog = find<QFileDialog>(dialog_name);
    // Not typed letter by letter: the completer's popup would take the click on the button.
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
    auto* buttons = dialog->findChild<QDialogButtonBox*>("buttonBox");
    for (QAbstractButton* button : buttons->buttons()) {
      if (buttons->buttonRole(button) != QDialogButtonBox::AcceptRole) continue;
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
    QTRY_VERIFY(window().findChild<QFileDialog*>(dialog_name) == nullptr);
  }
  /// Answers the file dialog that an action opens.
  void answer(const char* action_name, const char* dialog_name, const QString& file) const {
    trigger(action_name);
    answer(dialog_name, file);
  }

  /// Where a point in space is on the canvas.
  QPoint pixel_of(const Eigen::Vector3d& place) const {
    vtkRenderer* renderer = view().renderer();
    renderer->SetWorldPoint(place.x(), place.y(), place.z(), 1);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    const double ratio = canvas()->devicePixelRatioF();
    return {static_cast<int>(at[0] / ratio),
            canvas()->height() - 1 - static_cast<int>(at[1] / ratio)};
  }
  /// A mouse that moves with its button down.
  void move(QPoint at, const Stroke& how = {}) const {
    QWidget* over = how.over ? how.over : canvas();
    // QTest::mouseMove tells no button; a user's mouse does.
    QMouseEvent event(QEvent::MouseMove, at, over->mapToGlobal(at), Qt::NoButton, how.button,
                      how.keys);
    QApplication::sendEvent(over, &event);
  }
  /// The mouse from one place to another, by steps; `while_down` before it is let go.
  template <typename WhileDown>
  void drag(QPoint from, QPoint to, WhileDown while_down, const Stroke& how = {}) const {
    QWidget* over = how.over ? how.over : canvas();
    QTest::mouseMove(over, from);
    QTest::mousePress(over, how.button, how.keys, from);
    for (int step = 1; step <= how.steps; ++step) {
      move(from + (to - from) * step / how.steps, how);
    }
    while_down();
    QTest::mouseRelease(over, how.button, how.keys, to);
  }
  void drag(QPoint from, QPoint to, const Stroke& how = {}) const {
    drag(
        from, to, [] {}, how);
  }
  void wheel(QWidget* over, QPoint at, int notches, Qt::KeyboardModifiers keys = {}) const {
    QWheelEvent event(at, over->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(over, &event);
  }
  /// Mean place of the yellow grip's pixels on the canvas.
  QPoint grip() const {
    draw();
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
    QPixmap picture = window().grab();
    if (canvas()->isVisible()) {
      QPainter painter(&picture);
      painter.drawImage(QRect(canvas()->mapTo(&window(), QPoint()), canvas()->size()),
                        canvas()->grabFramebuffer());
    }
    picture.save(folder + "/" + name + ".png");
  }

 protected:
  User() = default;
  void take_hold_of(MainWindow& window) { hand_on_ = &window; }

 private:
  MainWindow* hand_on_ = nullptr;
};

}  // namespace gnathion::test
