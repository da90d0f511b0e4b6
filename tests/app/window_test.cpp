#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QOpenGLWidget>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <filesystem>
#include <future>
#include <memory>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "app/display.h"
#include "app/face_view.h"
#include "app/main_window.h"
#include "app/motion_words.h"
#include "app/theme.h"
#include "demo/demo_case.h"
#include "io/case_file.h"
#include "io/files.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

constexpr int patience = 60000;  // ms, for work beside the window

/// The window as a user has it: widgets by their names, mouse and keyboard.
struct User {
  MainWindow& window;

  template <typename T>
  T* find(const char* name) const {
    T* found = window.findChild<T*>(name);
    if (found == nullptr) qFatal("no widget %s", name);
    return found;
  }
  CaseController& model() const { return window.controller(); }
  QAction* action(const char* name) const { return find<QAction>(name); }
  QDoubleSpinBox* box(const char* name) const { return find<QDoubleSpinBox>(name); }
  QOpenGLWidget* canvas() const { return find<QOpenGLWidget>("face_canvas"); }
  QString label(const char* name) const { return find<QLabel>(name)->text(); }
  QString caption() const { return window.face_view().caption(); }
  bool message_visible() const { return find<QWidget>("message_bar")->isVisible(); }

  void click(const char* button) const {
    QTest::mouseClick(find<QAbstractButton>(button), Qt::LeftButton);
  }
  void type(const char* box_name, const QString& text) const {
    QDoubleSpinBox* spin = box(box_name);
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }
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
    return {static_cast<int>(x / count), static_cast<int>(y / count)};
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
  void look_from(const char* action_name) const {
    action(action_name)->trigger();
    QTest::qWait(300);  // the frame
  }
};

/// The quick answer, of a case with one segment.
Points predicted(const CaseController& model, const JawMotion& motion) {
  Points points;
  const LoadedCase& loaded = model.loaded();
  const std::array motions{rigid_motion(motion, loaded.anatomy->segments[0].pivot)};
  model.quick_model().predict(motions, points);
  return points;
}

int differing_pixels(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height) return a.width * a.height;
  int count = 0;
  for (size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); i += 3) {
    if (std::abs(a.rgb[i] - b.rgb[i]) > 12) ++count;
  }
  return count;
}

}  // namespace

class WindowTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanupTestCase();

  void startsWithAWelcome();
  void demoCaseOpensFromItsButton();
  void typedNumberMovesTheFace();
  void everyBoxMovesInItsOwnSense();
  void motionIsSaidInWords();
  void gripMovesSegmentAndFaceWhileTheMouseMoves();
  void oneAxisGripKeepsToItsAxis();
  void mouseBesideTheGripTurnsTheCameraOnly();
  void keysAndActionsPlaceTheCamera();
  void viewSwitchesChangeThePicture();
  void readoutsFollowTheMotion();
  void refinedAnswerReplacesTheQuickOne();
  void dragReturnsToTheQuickAnswer();
  void betterModelsAnswerWhereTheToleranceAsks();
  void refiningCanBeCancelled();
  void motionThatIsTooLargeKeepsTheQuickAnswer();
  void eachSegmentHasItsMotion();
  void motionInTimeIsPlayed();
  void playingStopsWhenAsked();
  void exportChangesVertexLinesOnly();
  void exportWithoutMotionEqualsTheImport();
  void exportOntoSomethingThatExistsIsRefused();
  void pictureIsSaved();
  void brokenCasesLeaveTheOpenOneAlone();
  void cancelEndsAnOpening();
  void laterOpeningWins();
  void windowMayCloseDuringWork();
  void exportOutlivesTheWindow();
  void oneExportAtATime();
  void noticesAreJoined();
  void beforeEndsADrag();
  void demoCaseMayBeMadeTwiceAtOnce();
  void modelOfForcesDoesNotTurn();
  void programWithoutDisplaySaysSo();

 private:
  QString path(const char* name) const { return folder_.filePath(name); }
  User user() const { return {*window_}; }
  void reset_motion() const { user().click("reset_button"); }
  /// The demo case with something in its plan changed, in a file beside it. Small strain, unless
  /// that is changed: large strain takes many seconds.
  template <typename Change>
  QString changed_case(const char* name, Change change) const {
    SurgicalCase plan = read_case_file(demo_.toStdString() + "/case.json");
    plan.tissue.strain = Strain::small;
    change(plan);
    const QString file = demo_ + "/" + name;
    write_case_file(plan, file.toStdString());
    return file;
  }
  QString plain_case() const {
    return changed_case("plain.json", [](SurgicalCase&) {});
  }
  /// The demo case with its jaw in two halves, left and right.
  QString two_segments() const {
    return changed_case("two.json", [](SurgicalCase& plan) {
      BoxCut half = std::get<BoxCut>(plan.segments[0].cut);
      const Eigen::Vector3d centre = half.centre;
      half.half_extents.x() = half.half_extents.x() / 2 - 0.25;
      plan.segments.assign(2, {});
      for (const std::size_t side : {0U, 1U}) {
        half.centre.x() = centre.x() + (side == 0 ? 1 : -1) * (half.half_extents.x() + 0.25);
        plan.segments[side].name = side == 0 ? "left" : "right";
        plan.segments[side].cut = half;
      }
    });
  }
  /// Opens a case and waits until it is on screen.
  static void open(MainWindow& window, const QString& file) {
    window.open_case(file);
    QTRY_VERIFY_WITH_TIMEOUT(!window.controller().is_working(), patience);
  }

  QTemporaryDir folder_;
  QString demo_;
  std::unique_ptr<MainWindow> window_;
};

void WindowTest::initTestCase() {
  demo_ = path("a demo, übung");  // blanks and letters beyond ASCII are to be borne
  Progress progress;
  write_demo_case(1, demo_.toStdString(), progress);
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  open(*window_, plain_case());
  QVERIFY(window_->controller().has_case());
}

void WindowTest::init() {
  if (!window_) return;
  // A display without window manager makes no window the active one, which shortcuts ask for.
  QApplication::setActiveWindow(window_.get());
  reset_motion();
  user().find<QWidget>("message_bar")->hide();
}

void WindowTest::cleanupTestCase() {
  window_.reset();
}

void WindowTest::startsWithAWelcome() {
  MainWindow window;
  const User user{window};
  window.show();
  QCOMPARE(user.find<QStackedWidget>("pages")->currentWidget()->objectName(),
           QString("welcome_page"));
  QVERIFY(user.find<QLabel>("research_label")->isVisible());
  QVERIFY(!user.action("export_action")->isEnabled());
  QVERIFY(!user.find<QWidget>("motion_panel")->isEnabled());
  QVERIFY(user.action("open_action")->isEnabled());
}

void WindowTest::demoCaseOpensFromItsButton() {
  MainWindow window;
  const User user{window};
  window.show();
  QSignalSpy opened(&user.model(), &CaseController::case_opened);
  user.click("welcome_demo_button");
  QVERIFY(user.find<QToolButton>("cancel_button")->isVisible());
  QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
  QCOMPARE(user.find<QStackedWidget>("pages")->currentWidget()->objectName(), QString("view_page"));
  QCOMPARE(user.box("forward_box")->value(), 6.0);
  QVERIFY(!user.model().is_working());
  QVERIFY(window.windowTitle().startsWith("embedded default case"));
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refined() != nullptr, 2 * patience);
  QVERIFY(user.model().refined()->relative_residual < 1e-8);
  // The second time it is there already.
  const fs::path file = user.model().plan().ct.path.parent_path() / "case.json";
  const auto written = fs::last_write_time(file);
  window.open_demo_case();
  QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 2, patience);
  QVERIFY(fs::last_write_time(file) == written);
}

void WindowTest::typedNumberMovesTheFace() {
  const User user = this->user();
  const Points rest = user.model().loaded().anatomy->face.mesh.surface.vertices;
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::done, patience);
  QVERIFY(user.model().response().face == rest);
  const Picture before = window_->face_view().picture();
  user.type("forward_box", "6");
  QCOMPARE(user.model().motion(), (JawMotion{.forward_mm = 6}));
  QVERIFY(user.model().response().face == predicted(user.model(), {.forward_mm = 6}));
  QVERIFY(user.model().response().face != rest);
  QVERIFY(differing_pixels(before, window_->face_view().picture()) > 500);
  reset_motion();
  QCOMPARE(user.box("forward_box")->value(), 0.0);
  QVERIFY(user.model().response().face == rest);
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::done, patience);
  QVERIFY(differing_pixels(before, window_->face_view().picture()) < 20);
}

void WindowTest::everyBoxMovesInItsOwnSense() {
  const User user = this->user();
  const std::pair<const char*, JawMotion> boxes[] = {
      {"forward_box", {.forward_mm = -2.5}}, {"up_box", {.up_mm = -2.5}},
      {"left_box", {.left_mm = -2.5}},       {"pitch_box", {.pitch_deg = -2.5}},
      {"roll_box", {.roll_deg = -2.5}},      {"yaw_box", {.yaw_deg = -2.5}}};
  for (const auto& [box, motion] : boxes) {
    reset_motion();
    user.type(box, "-2.5");
    QVERIFY2(user.model().motion() == motion, box);
    QVERIFY2(user.model().response().face == predicted(user.model(), motion), box);
    const bool turns = motion.pitch_deg + motion.roll_deg + motion.yaw_deg != 0;
    QCOMPARE(user.box(box)->maximum(), turns ? largest_turn_deg : largest_shift_mm);
    QCOMPARE(user.box(box)->minimum(), -user.box(box)->maximum());
  }
}

void WindowTest::motionIsSaidInWords() {
  QCOMPARE(motion_words({}), QString("not moved"));
  QCOMPARE(motion_words({.forward_mm = 6, .left_mm = -0.5, .pitch_deg = 2}),
           QString("6 mm forward, 0.5 mm to the right, 2° chin up"));
  QCOMPARE(motion_words({.forward_mm = -1, .up_mm = -1, .roll_deg = -1, .yaw_deg = -1}),
           QString("1 mm back, 1 mm down, 1° right side up, 1° chin to right"));
  QCOMPARE(landmark_words("mouth_corner_left"), QString("Mouth corner left"));
}

void WindowTest::gripMovesSegmentAndFaceWhileTheMouseMoves() {
  const User user = this->user();
  user.look_from("left_action");
  const QPoint grip = user.grip();
  Points while_down;
  JawMotion motion_while_down;
  user.drag(grip, grip + QPoint(-24, -12), [&] {
    while_down = user.model().response().face;
    motion_while_down = user.model().motion();
  });
  // The left profile: forward is the picture's left.
  QVERIFY(motion_while_down.forward_mm > 2);
  QVERIFY(motion_while_down.up_mm > 1);
  QCOMPARE(motion_while_down.left_mm, 0.0);
  QVERIFY(while_down == predicted(user.model(), motion_while_down));
  QCOMPARE(user.model().motion(), motion_while_down);
  QCOMPARE(user.box("forward_box")->value(), motion_while_down.forward_mm);
  QCOMPARE(user.box("up_box")->value(), motion_while_down.up_mm);
  // The grip stays where it was put, and goes where a number sends it.
  QTest::qWait(300);
  QVERIFY((user.grip() - grip - QPoint(-24, -12)).manhattanLength() <= 4);
  reset_motion();
  QTest::qWait(300);
  QVERIFY((user.grip() - grip).manhattanLength() <= 2);
}

void WindowTest::oneAxisGripKeepsToItsAxis() {
  const User user = this->user();
  user.look_from("left_action");
  // The forward grip is 16 mm before the ball: find the scale by a known motion.
  const QPoint at_zero = user.grip();
  user.type("forward_box", "10");
  QTest::qWait(300);
  const int ten_mm = at_zero.x() - user.grip().x();
  QVERIFY(ten_mm > 10);
  reset_motion();
  QTest::qWait(300);
  const QPoint forward_grip = at_zero - QPoint(ten_mm * 16 / 10, 0);
  user.drag(forward_grip, forward_grip + QPoint(-ten_mm / 2, 30));
  QVERIFY(std::abs(user.model().motion().forward_mm - 5) < 0.6);
  QCOMPARE(user.model().motion().up_mm, 0.0);
}

void WindowTest::mouseBesideTheGripTurnsTheCameraOnly() {
  const User user = this->user();
  user.look_from("front_action");
  vtkCamera* camera = window_->face_view().renderer()->GetActiveCamera();
  const Eigen::Vector3d before(camera->GetPosition());
  const QPoint beside(user.canvas()->width() / 2, user.canvas()->height() / 3);
  user.drag(beside, beside + QPoint(60, 0));
  const Eigen::Vector3d after(camera->GetPosition());
  QVERIFY((after - before).norm() > 20);
  QCOMPARE(user.model().motion(), JawMotion{});
}

void WindowTest::keysAndActionsPlaceTheCamera() {
  const User user = this->user();
  vtkCamera* camera = window_->face_view().renderer()->GetActiveCamera();
  const auto direction = [&] { return Eigen::Vector3d(camera->GetDirectionOfProjection()); };
  user.canvas()->setFocus();
  const std::tuple<int, Qt::KeyboardModifiers, Eigen::Vector3d> keys[] = {
      {Qt::Key_1, Qt::KeypadModifier, {0, 1, 0}},
      {Qt::Key_3, Qt::KeypadModifier, {-1, 0, 0}},
      {Qt::Key_9, Qt::KeypadModifier, {1, 0, 0}},
      {Qt::Key_7, Qt::KeypadModifier, {0, 0, -1}}};
  for (const auto& [key, modifiers, wanted] : keys) {
    QTest::keyClick(user.canvas(), static_cast<Qt::Key>(key), modifiers);
    QVERIFY((direction() - wanted).norm() < 1e-6);
  }
  QTest::keyClick(user.canvas(), Qt::Key_R);
  QVERIFY(direction().x() < -0.5 && direction().y() > 0.5);
  // VTK's own letters do nothing: e would end the program.
  for (const char letter : {'e', 'q', 'w', 's', '3', 'f'}) QTest::keyClick(user.canvas(), letter);
  QVERIFY(window_->isVisible());
}

void WindowTest::viewSwitchesChangeThePicture() {
  const User user = this->user();
  FaceView& view = window_->face_view();
  user.look_from("three_quarter_action");
  user.type("forward_box", "6");
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refined() != nullptr, patience);
  const Picture plain = view.picture();
  for (const char* name :
       {"textured_action", "bone_action", "before_action", "colour_map_action"}) {
    user.action(name)->trigger();
    QVERIFY2(differing_pixels(plain, view.picture()) > 500, name);
    user.action(name)->trigger();
    QVERIFY2(differing_pixels(plain, view.picture()) < 20, name);
  }
  user.find<QSlider>("opacity_slider")->setValue(40);
  QVERIFY(differing_pixels(plain, view.picture()) > 500);
  user.find<QSlider>("opacity_slider")->setValue(100);
  QVERIFY(differing_pixels(plain, view.picture()) < 20);
}

void WindowTest::readoutsFollowTheMotion() {
  const User user = this->user();
  const auto* table = user.find<QTableWidget>("landmark_table");
  QCOMPARE(table->rowCount(), 10);
  QCOMPARE(user.label("max_value"), QString("0.0 mm"));
  user.type("forward_box", "6");
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 0)->text() != "Pogonion soft") continue;
    QVERIFY(std::abs(table->item(row, 1)->text().toDouble() - 6) < 0.3);
    QVERIFY(std::abs(table->item(row, 2)->text().toDouble() - 1) < 0.05);
  }
  const double largest = user.label("max_value").section(' ', 0, 0).toDouble();
  const double mean = user.label("mean_value").section(' ', 0, 0).toDouble();
  QVERIFY(largest > 5.5 && largest < 7);
  QVERIFY(mean > 1 && mean < largest);
  // They become those of the refined answer.
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refined() != nullptr, patience);
  const Prediction& refined = *user.model().refined();
  QCOMPARE(user.label("p95_value"), QString("%1 mm").arg(refined.displacement.p95, 0, 'f', 1));
  for (const auto& [name, landmark] : user.model().response().landmarks) {
    QCOMPARE(landmark.ratio, refined.landmarks.at(name).ratio);
  }
}

void WindowTest::refinedAnswerReplacesTheQuickOne() {
  const User user = this->user();
  const CaseController& model = user.model();
  user.type("forward_box", "6");
  QVERIFY(model.refinement() == Refinement::waiting);
  QVERIFY(model.refined() == nullptr);
  QVERIFY(user.caption().contains("6 mm forward"));
  QVERIFY(user.caption().contains("quick answer, linear model"));
  QVERIFY(user.label("model_label").contains("Quick answer, linear model on"));
  QTRY_VERIFY_WITH_TIMEOUT(model.refinement() == Refinement::running, patience);
  QVERIFY(user.label("model_label").contains("being refined"));
  QVERIFY(user.find<QToolButton>("cancel_button")->isVisible());
  QTRY_VERIFY_WITH_TIMEOUT(model.refinement() == Refinement::done, patience);
  QVERIFY(!user.find<QToolButton>("cancel_button")->isVisible());
  const Prediction& refined = *model.refined();
  QVERIFY(model.response().face == refined.face_points);
  QVERIFY(refined.answer.quick_error.total.p95 > 0);
  const QString error = QString::number(refined.answer.error.total.p95, 'f', 2) + " mm";
  QVERIFY(user.caption().contains("estimated error " + error));
  QVERIFY(user.label("model_label").contains("estimated error " + error));
  QVERIFY(user.find<QLabel>("model_label")
              ->toolTip()
              .startsWith(QString::fromStdString(refined.answer.why), Qt::CaseInsensitive));
  // The next motion is answered at once, by the quick model again.
  user.type("forward_box", "5");
  QVERIFY(model.refined() == nullptr);
  QVERIFY(model.response().face == predicted(model, {.forward_mm = 5}));
  QVERIFY(user.caption().contains("quick answer"));
  QVERIFY(!user.caption().contains("estimated"));
}

void WindowTest::dragReturnsToTheQuickAnswer() {
  const User user = this->user();
  const CaseController& model = user.model();
  user.type("forward_box", "6");
  QTRY_VERIFY_WITH_TIMEOUT(model.refinement() == Refinement::done, patience);
  user.look_from("left_action");
  const QPoint grip = user.grip();
  user.drag(grip, grip + QPoint(-12, 0), [&] {
    QVERIFY(model.motion().forward_mm > 6);
    QVERIFY(model.refined() == nullptr);
    QVERIFY(model.response().face == predicted(model, model.motion()));
    QVERIFY(user.caption().contains("quick answer"));
    // The hand rests, and the refined answer comes while it holds the grip.
    QTRY_VERIFY_WITH_TIMEOUT(model.refinement() == Refinement::done, patience);
    QVERIFY(model.response().face == model.refined()->face_points);
  });
  QVERIFY(model.refinement() == Refinement::done);
}

void WindowTest::betterModelsAnswerWhereTheToleranceAsks() {
  MainWindow window;
  const User user{window};
  window.show();
  const CaseController& model = user.model();
  open(window, changed_case("exact.json", [](SurgicalCase& plan) {
         plan.tissue.strain = Strain::large;
         plan.tissue.elements = Elements::linear;
         plan.tissue.tolerance_mm = 1e-4;
       }));
  QTRY_VERIFY_WITH_TIMEOUT(model.refinement() == Refinement::done, patience);
  QVERIFY(model.refined()->answer.large_strain);
  QVERIFY((model.response().face - predicted(model, model.motion())).norm() > 0.1);
  QVERIFY(user.caption().contains("neo-Hookean model on linear elements"));
  // What is estimated above the tolerance is told as a warning.
  QVERIFY(user.label("model_label").contains("above the tolerance of 0.00 mm"));
  QVERIFY(user.label("model_label").contains(warning_colour(window.palette()).name()));
  QVERIFY(user.caption().contains("above the tolerance"));
}

void WindowTest::refiningCanBeCancelled() {
  const User user = this->user();
  user.type("forward_box", "6");
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::running, patience);
  user.click("cancel_button");
  QVERIFY(user.model().refinement() == Refinement::stopped);
  QVERIFY(!user.find<QToolButton>("cancel_button")->isVisible());
  QVERIFY(user.label("model_label").contains("not refined"));
  QTest::qWait(1500);  // longer than it takes
  QVERIFY(user.model().refinement() == Refinement::stopped);
  QVERIFY(user.model().response().face == predicted(user.model(), {.forward_mm = 6}));
  QVERIFY(!user.message_visible());
  user.type("forward_box", "5");
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::done, patience);
}

void WindowTest::motionThatIsTooLargeKeepsTheQuickAnswer() {
  MainWindow window;
  const User user{window};
  window.show();
  open(window, changed_case("large.json", [](SurgicalCase& plan) {
         plan.tissue.strain = Strain::large;
         plan.tissue.elements = Elements::linear;
         plan.segments[0].motion = {};
         plan.region.reach_mm = 15;  // few tetrahedra and little room: it gives up soon
         plan.tissue.edge_mm = 5;
       }));
  const JawMotion motion{.forward_mm = -30, .up_mm = 30, .yaw_deg = 30};
  user.model().set_motion(motion);
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::refused, patience);
  QVERIFY(user.message_visible());
  QVERIFY(!user.label("message_remedy").isEmpty());
  QVERIFY(user.model().response().face == predicted(user.model(), motion));
  QVERIFY(user.label("model_label").contains("not refined"));
  QVERIFY(user.label("model_label").contains(warning_colour(window.palette()).name()));
  QVERIFY(user.caption().contains("quick answer"));
  QVERIFY(user.caption().contains("not refined"));
}

void WindowTest::eachSegmentHasItsMotion() {
  MainWindow window;
  const User user{window};
  window.show();
  const CaseController& model = user.model();
  open(window, two_segments());
  QVERIFY2(model.has_case(), qPrintable(user.label("message_text")));
  auto* choice = user.find<QComboBox>("segment_box");
  QVERIFY(choice->isVisible());
  QVERIFY(!this->user().find<QComboBox>("segment_box")->isVisible());
  QCOMPARE(choice->count(), 2);
  QCOMPARE(choice->itemText(1), QString("right"));
  const auto poses_are = [&](const JawMotion& left, const JawMotion& right) {
    const std::vector<BoneSegment>& segments = model.loaded().anatomy->segments;
    const std::array poses{rigid_motion(left, segments[0].pivot),
                           rigid_motion(right, segments[1].pivot)};
    Points face;
    model.quick_model().predict(poses, face);
    return model.response().face == face &&
           model.response().poses[0].translation == poses[0].translation &&
           model.response().poses[1].translation == poses[1].translation;
  };
  user.type("forward_box", "3");
  user.look_from("front_action");
  const QPoint left_grip = user.grip();
  QVERIFY(poses_are({.forward_mm = 3}, {}));
  // The other segment: its numbers, its grips.
  choice->setFocus();
  QTest::keyClick(choice, Qt::Key_Down);
  QCOMPARE(model.active_segment(), std::size_t{1});
  QCOMPARE(user.box("forward_box")->value(), 0.0);
  QTest::qWait(300);
  QVERIFY(user.grip().x() < left_grip.x() - 20);  // the patient's right is the picture's left
  const QPoint right_grip = user.grip();
  user.drag(right_grip, right_grip + QPoint(0, 20));
  const JawMotion right = model.motion();
  QVERIFY(right.up_mm < -1 && model.motions()[0] == JawMotion{.forward_mm = 3});
  QVERIFY(poses_are({.forward_mm = 3}, right));
  QVERIFY(user.caption().contains("left: 3 mm forward\nright: "));
  // Both are in what is refined and exported.
  QTRY_VERIFY_WITH_TIMEOUT(model.refinement() == Refinement::done, patience);
  QCOMPARE(model.refined()->motions.size(), std::size_t{2});
  const fs::path out = path("two").toStdString();
  window.controller().export_face(out);
  QTRY_VERIFY_WITH_TIMEOUT(!model.is_working(), patience);
  const QString report = QString::fromStdString(read_text_file(out / "report.json"));
  QVERIFY(report.contains("\"forward_mm\": 3"));
  QVERIFY(report.contains(QString("\"up_mm\": %1").arg(right.up_mm)));
}

void WindowTest::motionInTimeIsPlayed() {
  const User user = this->user();
  MotionPlayer& player = window_->player();
  QAction* play = user.action("play_action");
  QVERIFY(!play->isEnabled());  // nothing has moved
  user.type("forward_box", "6");
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::done, patience);
  const Picture predicted_face = window_->face_view().picture();
  const Points rest = user.model().loaded().anatomy->face.mesh.surface.vertices;
  // The film is of linear elements, also where a drag has quadratic ones by now.
  Points quick;
  user.model().loaded().model->predict(user.model().response().poses, quick);
  std::vector<double> times, distances;
  const auto listener =
      connect(&player, &MotionPlayer::frame_due, [&](const Points& face, double time_s) {
        times.push_back(time_s);
        distances.push_back((face - quick).norm());
      });
  QSignalSpy ended(&player, &MotionPlayer::ended);
  play->trigger();
  QVERIFY(play->isChecked());
  QTRY_VERIFY_WITH_TIMEOUT(times.size() > 1, patience);
  QVERIFY(user.caption().contains("20 times slower"));
  QVERIFY(user.caption().contains("damped motion, alpha 20/s, beta 0.01 s"));
  QVERIFY(user.label("model_label").contains("damped motion"));
  QVERIFY(differing_pixels(predicted_face, window_->face_view().picture()) > 500);
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, patience);
  QVERIFY(!play->isChecked());
  disconnect(listener);
  // From rest, ever nearer to the linear model's answer, and then back to the prediction.
  QCOMPARE(times.front(), 0.0);
  QVERIFY(std::is_sorted(times.begin(), times.end()));
  QVERIFY(std::abs(distances.front() - (rest - quick).norm()) < 1e-6);
  QVERIFY(distances.back() < 0.01 * distances.front());
  QVERIFY(user.caption().contains("estimated error"));
  QVERIFY(differing_pixels(predicted_face, window_->face_view().picture()) < 20);
}

void WindowTest::playingStopsWhenAsked() {
  const User user = this->user();
  MotionPlayer& player = window_->player();
  user.type("forward_box", "6");
  user.canvas()->setFocus();
  QTest::keyClick(user.canvas(), Qt::Key_P);  // computing
  QVERIFY(player.is_computing());
  QTest::keyClick(user.canvas(), Qt::Key_P);
  QVERIFY(!player.is_running());
  QTest::keyClick(user.canvas(), Qt::Key_P);
  QTRY_VERIFY_WITH_TIMEOUT(player.is_playing(), patience);
  user.type("forward_box", "5");
  QVERIFY(!player.is_running());
  QVERIFY(user.caption().contains("5 mm forward"));
  QVERIFY(user.model().response().face == predicted(user.model(), {.forward_mm = 5}));
}

void WindowTest::exportChangesVertexLinesOnly() {
  const User user = this->user();
  user.type("forward_box", "6");
  const QString target = path("exported");
  user.answer("export_action", "export_dialog", target);
  QTRY_VERIFY_WITH_TIMEOUT(!user.model().is_working(), patience);
  QVERIFY(user.message_visible());
  const fs::path out = target.toStdString(), photograph = demo_.toStdString() + "/photograph";
  const auto lines = [](const fs::path& file) {
    return QString::fromStdString(read_text_file(file)).split('\n');
  };
  const QStringList before = lines(photograph / "face.obj"), after = lines(out / "predicted.obj");
  QCOMPARE(after.size(), before.size());
  int changed = 0;
  for (int i = 0; i < before.size(); ++i) {
    if (after[i] == before[i]) continue;
    QVERIFY(before[i].startsWith("v ") && after[i].startsWith("v "));
    ++changed;
  }
  QVERIFY(changed > 1000);
  QCOMPARE(read_text_file(out / "face.png"), read_text_file(photograph / "face.png"));
  QCOMPARE(read_text_file(out / "face.mtl"), read_text_file(photograph / "face.mtl"));
  QVERIFY(
      QString::fromStdString(read_text_file(out / "report.json")).contains("\"forward_mm\": 6"));
}

void WindowTest::exportWithoutMotionEqualsTheImport() {
  const User user = this->user();
  const QString target = path("not_moved");
  user.answer("export_action", "export_dialog", target);
  QTRY_VERIFY_WITH_TIMEOUT(!user.model().is_working(), patience);
  QCOMPARE(read_text_file(target.toStdString() + "/predicted.obj"),
           read_text_file(demo_.toStdString() + "/photograph/face.obj"));
}

void WindowTest::exportOntoSomethingThatExistsIsRefused() {
  const User user = this->user();
  const QString target = path("already there");
  write_text_file(target.toStdString(), "a file of the user");
  user.answer("export_action", "export_dialog", target);
  QTRY_VERIFY_WITH_TIMEOUT(!user.model().is_working(), patience);
  QVERIFY(user.message_visible());
  QVERIFY(user.label("message_title").contains("already there"));
  QVERIFY(user.label("message_text").contains("exist"));
  QVERIFY(!user.label("message_remedy").isEmpty());
  QCOMPARE(read_text_file(target.toStdString()), std::string("a file of the user"));
  user.click("message_close");
  QVERIFY(!user.message_visible());
}

void WindowTest::pictureIsSaved() {
  const User user = this->user();
  QTest::qWait(100);  // the layout, after the message of the test before
  const Picture shown = window_->face_view().picture();
  const double ratio = user.canvas()->devicePixelRatioF();
  QCOMPARE(shown.width, static_cast<int>(user.canvas()->width() * ratio));
  QCOMPARE(shown.height, static_cast<int>(user.canvas()->height() * ratio));
  user.answer("picture_action", "picture_dialog", path("view.png"));
  QCOMPARE(read_picture_file(path("view.png").toStdString()) == shown, true);
  user.answer("picture_action", "picture_dialog", path("no such folder/view.png"));
  QVERIFY(user.message_visible());
  QVERIFY(user.label("message_title").contains("view.png"));
}

void WindowTest::brokenCasesLeaveTheOpenOneAlone() {
  const User user = this->user();
  user.type("forward_box", "3");
  // The caption and the face change once more when the answer comes.
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refined() != nullptr, 2 * patience);
  QTest::qWait(100);  // the layout, after the message of the test before
  const Picture before = window_->face_view().picture();
  const LoadedCase* open_case = &user.model().loaded();
  write_text_file(path("broken.json").toStdString(), "{\"gnathion_case\": 1, \"ct\": {");
  const QString no_ct =
      changed_case("no_ct.json", [](SurgicalCase& plan) { plan.ct.path = "nowhere"; });
  // A texture that is no picture is found before the case on screen is given up.
  fs::copy(demo_.toStdString() + "/photograph", demo_.toStdString() + "/bad");
  write_text_file(demo_.toStdString() + "/bad/face.png", "this is no picture");
  const QString no_picture = changed_case("no_picture.json", [this](SurgicalCase& plan) {
    plan.photograph->obj = demo_.toStdString() + "/bad/face.obj";
  });
  const std::pair<QString, const char*> files[] = {{path("broken.json"), "broken.json"},
                                                   {path("absent.json"), "absent.json"},
                                                   {no_ct, "nowhere"},
                                                   {no_picture, "face.png"}};
  for (const auto& [file, named] : files) {
    user.find<QWidget>("message_bar")->hide();
    window_->open_case(file);
    QTRY_VERIFY_WITH_TIMEOUT(!user.model().is_working(), patience);
    QVERIFY2(user.message_visible(), named);
    QVERIFY2(user.label("message_title").contains(named), qPrintable(user.label("message_title")));
    QVERIFY(user.label("message_remedy").size() > 15);
    QCOMPARE(&user.model().loaded(), open_case);
    QCOMPARE(user.model().motion(), (JawMotion{.forward_mm = 3}));
    QCOMPARE(window_->size(), QSize(1280, 800));  // a long path does not stretch the window
  }
  user.click("message_close");
  QTRY_VERIFY(differing_pixels(before, window_->face_view().picture()) < 20);
}

void WindowTest::cancelEndsAnOpening() {
  MainWindow window;
  const User user{window};
  window.show();
  QSignalSpy stages(&user.model(), &CaseController::work_stage);
  for (const int stage : {1, 3, 6}) {
    stages.clear();
    window.open_case(demo_ + "/case.json");
    QTRY_VERIFY_WITH_TIMEOUT(stages.count() >= stage, patience);
    user.click("cancel_button");
    QVERIFY(!user.model().is_working());
    QVERIFY(!user.find<QToolButton>("cancel_button")->isVisible());
    QTest::qWait(50);
    QVERIFY(!user.model().has_case());
    QVERIFY(!user.message_visible());
  }
  open(window, demo_ + "/case.json");
  QVERIFY(user.model().has_case());
}

void WindowTest::laterOpeningWins() {
  const User user = this->user();
  QSignalSpy opened(&user.model(), &CaseController::case_opened);
  user.action("bone_action")->setChecked(false);
  user.look_from("three_quarter_action");
  const Picture without_bone = window_->face_view().picture();
  const QString second =
      changed_case("second.json", [](SurgicalCase& plan) { plan.name = "the second"; });
  window_->open_case(demo_ + "/case.json");
  QTest::qWait(100);
  window_->open_case(second);
  QTRY_VERIFY_WITH_TIMEOUT(!user.model().is_working(), patience);
  QTest::qWait(200);
  QCOMPARE(opened.count(), 1);
  QCOMPARE(user.model().loaded().plan.name, std::string("the second"));
  QVERIFY(window_->windowTitle().startsWith("the second"));
  // What the user chose to see holds for the next case too.
  reset_motion();
  QTRY_VERIFY(differing_pixels(without_bone, window_->face_view().picture()) < 20);
  user.action("bone_action")->setChecked(true);
  QVERIFY(differing_pixels(without_bone, window_->face_view().picture()) > 500);
}

void WindowTest::windowMayCloseDuringWork() {
  for (const int wait : {0, 30, 150, 400, 700, 1000}) {
    const QTemporaryDir cache;
    const fs::path folder = cache.path().toStdString();
    const auto files = [&folder] {
      std::vector<fs::path> found;
      for (const auto& entry : fs::recursive_directory_iterator(folder)) found.push_back(entry);
      return found;
    };
    auto window = std::make_unique<MainWindow>();
    window->show();
    int heard = 0;
    CaseController& model = window->controller();
    QObject::connect(&model, &CaseController::work_stage, [&heard] { ++heard; });
    QObject::connect(&model, &CaseController::case_opened, [&heard] { ++heard; });
    QObject::connect(&model, &CaseController::work_ended, [&heard] { ++heard; });
    model.open_demo_case(folder);
    QTest::qWait(wait);
    window->close();
    window.reset();
    // The worker has ended: it writes and says no more, and what it had begun is removed.
    const int heard_at_the_end = heard;
    const std::vector<fs::path> left = files();
    QTest::qWait(200);
    QCOMPARE(heard, heard_at_the_end);
    QVERIFY(files() == left);
    for (const auto& entry : fs::directory_iterator(folder)) {
      QVERIFY2(fs::exists(entry.path() / "case.json"), entry.path().c_str());
      QVERIFY2(entry.path().filename().string().front() != '.', entry.path().c_str());
    }
  }
}

void WindowTest::oneExportAtATime() {
  const User user = this->user();
  const fs::path first = path("first").toStdString(), second = path("second").toStdString();
  QVERIFY(user.action("export_action")->isEnabled());
  user.model().export_face(first);
  QVERIFY(!user.action("export_action")->isEnabled());
  user.model().export_face(second);
  QTRY_VERIFY_WITH_TIMEOUT(!user.model().is_working(), patience);
  QVERIFY(fs::exists(first / "predicted.obj"));
  QVERIFY(!fs::exists(second));
  QVERIFY(user.action("export_action")->isEnabled());
  user.model().export_face(second);
  user.click("cancel_button");
  QVERIFY(user.action("export_action")->isEnabled());
  QVERIFY(!user.model().is_working());
}

void WindowTest::noticesAreJoined() {
  const User user = this->user();
  emit user.model().noticed("the first");
  emit user.model().noticed("the second");
  QCOMPARE(user.label("message_text"), QString("the first\nthe second"));
  for (int i = 0; i < 60; ++i) emit user.model().noticed("one of many");
  QTest::qWait(100);
  QVERIFY(user.label("message_text").startsWith("the first\nthe second\none of many"));
  QVERIFY(user.find<QWidget>("message_bar")->height() < 200);
  QVERIFY(user.find<QLabel>("message_text")->height() > 600);  // whole, to be scrolled
  QCOMPARE(window_->size(), QSize(1280, 800));
  user.click("message_close");
  emit user.model().noticed("another");
  QCOMPARE(user.label("message_text"), QString("another"));
  user.click("message_close");
}

void WindowTest::beforeEndsADrag() {
  const User user = this->user();
  user.look_from("left_action");
  const QPoint grip = user.grip();
  QSignalSpy ended(&window_->face_view(), &FaceView::drag_ended);
  user.drag(grip, grip + QPoint(-24, -12), [&] { user.action("before_action")->trigger(); });
  QCOMPARE(ended.count(), 1);
  user.action("before_action")->trigger();
  // The grip is in nobody's hand: it lets the mouse pass, and goes where a number sends it.
  const JawMotion motion = user.model().motion();
  QVERIFY(motion.forward_mm > 2);
  QTest::mouseMove(user.canvas(), grip + QPoint(-60, -60));
  QTest::mouseMove(user.canvas(), grip + QPoint(-80, -60));
  QCOMPARE(user.model().motion(), motion);
  reset_motion();
  QTest::qWait(300);
  QVERIFY((user.grip() - grip).manhattanLength() <= 2);
  user.drag(grip, grip + QPoint(-24, 0));
  QVERIFY(user.model().motion().forward_mm > 2);
}

void WindowTest::demoCaseMayBeMadeTwiceAtOnce() {
  const fs::path cache = path("cache").toStdString();
  const auto make = [&cache] {
    Progress progress;
    return cached_demo_case(cache, GNATHION_PROGRAM, progress);
  };
  std::future<fs::path> other = std::async(std::launch::async, make);
  const fs::path folder = make();
  QVERIFY(other.get() == folder);
  QVERIFY(fs::exists(folder / "case.json"));
  QVERIFY(std::distance(fs::directory_iterator(cache), fs::directory_iterator()) == 1);
}

void WindowTest::exportOutlivesTheWindow() {
  const QString target = path("at_the_end");
  {
    MainWindow window;
    window.show();
    open(window, plain_case());
    window.controller().export_face(target.toStdString());
  }
  QVERIFY(fs::exists(target.toStdString() + "/predicted.obj"));
}

void WindowTest::modelOfForcesDoesNotTurn() {
  MainWindow window;
  const User user{window};
  window.show();
  open(window, changed_case("forces.json", [](SurgicalCase& plan) {
         plan.tissue.load = LoadModel::force;
         plan.segments[0].motion = {.forward_mm = 2};
       }));
  QVERIFY(user.model().has_case());
  QVERIFY(!user.box("pitch_box")->isEnabled());
  QVERIFY(user.box("forward_box")->isEnabled());
  user.model().set_motion({.forward_mm = 2, .pitch_deg = 3});
  QVERIFY(user.message_visible());
  QCOMPARE(user.model().motion(), (JawMotion{.forward_mm = 2}));
  QCOMPARE(user.box("pitch_box")->value(), 0.0);
}

void WindowTest::programWithoutDisplaySaysSo() {
  const auto run = [](const QString& display, const QStringList& arguments) {
    auto process = std::make_unique<QProcess>();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove("DISPLAY");
    if (!display.isEmpty()) environment.insert("DISPLAY", display);
    process->setProcessEnvironment(environment);
    process->start(GNATHION_PROGRAM, arguments);
    process->waitForFinished(20000);
    return process;
  };
  for (const QString& display : {QString(), QString(":60999")}) {
    const auto process = run(display, {});
    QCOMPARE(process->exitStatus(), QProcess::NormalExit);
    QCOMPARE(process->exitCode(), 2);
    const QByteArray said = process->readAllStandardError();
    QVERIFY2(said.contains("display") && said.contains("gnathion-cli"), said);
  }
  const auto version = run({}, {"--version"});
  QCOMPARE(version->exitCode(), 0);
  QCOMPARE(version->readAllStandardOutput(), QByteArray("gnathion " GNATHION_VERSION "\n"));
  QCOMPARE(run({}, {"one.json", "two.json"})->exitCode(), 2);
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  QCoreApplication::setApplicationName("gnathion");
  const QTemporaryDir cache;  // the demo case is written there, not into the user's own
  qputenv("XDG_CACHE_HOME", cache.path().toLocal8Bit());
  const QString problem = gnathion::display_problem();
  if (!problem.isEmpty()) qFatal("%s", qPrintable(problem));
  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  gnathion::use_c_numbers();
  gnathion::test::WindowTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "window_test.moc"
