#include <QComboBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <future>

#include "app/driven_window.h"
#include "app/motion_words.h"
#include "app/theme.h"
#include "io/files.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

/// The quick answer, of a case with one segment.
Points predicted(const CaseController& model, const JawMotion& motion) {
  Points points;
  const LoadedCase& loaded = model.loaded();
  const std::array motions{rigid_motion(motion, loaded.anatomy->segments[0].pivot)};
  model.quick_model().predict(motions, points);
  return points;
}

}  // namespace

class WindowTest : public QObject, private DrivenWindow {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanupTestCase();

  void startsWithAWelcome();
  void refinedAnswerReplacesTheQuickOne();
  void dragReturnsToTheQuickAnswer();
  void refiningCanBeCancelled();
  void motionInTimeIsPlayed();
  void playingStopsWhenAsked();
  // From here on with linear elements, whose answers are there sooner.
  void demoCaseMayBeMadeTwiceAtOnce();
  void demoCaseOpensFromItsButton();
  void laterOpeningWins();
  void typedNumberMovesTheFace();
  void everyBoxMovesInItsOwnSense();
  void motionIsSaidInWords();
  void gripMovesSegmentAndFaceWhileTheMouseMoves();
  void oneAxisGripKeepsToItsAxis();
  void mouseBesideTheGripTurnsTheCameraOnly();
  void keysAndActionsPlaceTheCamera();
  void viewSwitchesChangeThePicture();
  void readoutsFollowTheMotion();
  void betterModelsAnswerWhereTheToleranceAsks();
  void motionThatIsTooLargeKeepsTheQuickAnswer();
  void eachSegmentHasItsMotion();
  void exportChangesVertexLinesOnly();
  void exportWithoutMotionEqualsTheImport();
  void exportOntoSomethingThatExistsIsRefused();
  void pictureIsSaved();
  void brokenCasesLeaveTheOpenOneAlone();
  void cancelEndsAnOpening();
  void windowMayCloseDuringWork();
  void exportOutlivesTheWindow();
  void oneExportAtATime();
  void noticesAreJoined();
  void beforeEndsADrag();
  void modelOfForcesDoesNotTurn();
  void programWithoutDisplaySaysSo();

 private:
  void reset_motion() const { click("reset_button"); }
  QString plain_case() const {
    return changed_case("plain.json", [](SurgicalCase&) {});
  }
  /// Quadratic elements where they are ready.
  QString sharp_case() const {
    return changed_case("sharp.json",
                        [](SurgicalCase& plan) { plan.tissue.elements = Elements::automatic; });
  }

  fs::path made_;  ///< the demo case in the user's cache
};

void WindowTest::initTestCase() {
  make_demo();
  start_window();
  open(sharp_case());
  QVERIFY(model().has_case());
}

void WindowTest::init() {
  activate();
  reset_motion();
  find<QWidget>("message_bar")->hide();
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
  const auto written = fs::last_write_time(made_ / "case.json");
  QSignalSpy opened(&user.model(), &CaseController::case_opened);
  user.click("welcome_demo_button");
  QVERIFY(user.find<QToolButton>("cancel_button")->isVisible());
  QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, patience);
  QCOMPARE(user.find<QStackedWidget>("pages")->currentWidget()->objectName(), QString("view_page"));
  QCOMPARE(user.box("forward_box")->value(), 6.0);
  QVERIFY(!user.model().is_working());
  QVERIFY(window.windowTitle().startsWith("embedded default case"));
  QCOMPARE(user.model().plan().ct.path.parent_path(), made_);
  QVERIFY(fs::last_write_time(made_ / "case.json") == written);  // it was there already
}

void WindowTest::typedNumberMovesTheFace() {
  const Points rest = model().loaded().anatomy->face.mesh.surface.vertices;
  await_answer();
  QVERIFY(model().response().face == rest);
  const Picture before = view().picture();
  type("forward_box", "6");
  QCOMPARE(model().motion(), (JawMotion{.forward_mm = 6}));
  QVERIFY(model().response().face == predicted(model(), {.forward_mm = 6}));
  QVERIFY(model().response().face != rest);
  QVERIFY(differing_pixels(before, view().picture()) > 500);
  reset_motion();
  QCOMPARE(box("forward_box")->value(), 0.0);
  QVERIFY(model().response().face == rest);
  await_answer();
  QVERIFY(differing_pixels(before, view().picture()) < 20);
}

void WindowTest::everyBoxMovesInItsOwnSense() {
  const std::pair<const char*, JawMotion> boxes[] = {
      {"forward_box", {.forward_mm = -2.5}}, {"up_box", {.up_mm = -2.5}},
      {"left_box", {.left_mm = -2.5}},       {"pitch_box", {.pitch_deg = -2.5}},
      {"roll_box", {.roll_deg = -2.5}},      {"yaw_box", {.yaw_deg = -2.5}}};
  for (const auto& [name, motion] : boxes) {
    reset_motion();
    type(name, "-2.5");
    QVERIFY2(model().motion() == motion, name);
    QVERIFY2(model().response().face == predicted(model(), motion), name);
    const bool turns = motion.pitch_deg + motion.roll_deg + motion.yaw_deg != 0;
    QCOMPARE(box(name)->maximum(), turns ? largest_turn_deg : largest_shift_mm);
    QCOMPARE(box(name)->minimum(), -box(name)->maximum());
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
  look_from("left_action");
  const QPoint ball = grip();
  Points while_down;
  JawMotion motion_while_down;
  drag(ball, ball + QPoint(-24, -12), [&] {
    while_down = model().response().face;
    motion_while_down = model().motion();
  });
  // The left profile: forward is the picture's left.
  QVERIFY(motion_while_down.forward_mm > 2);
  QVERIFY(motion_while_down.up_mm > 1);
  QCOMPARE(motion_while_down.left_mm, 0.0);
  QVERIFY(while_down == predicted(model(), motion_while_down));
  QCOMPARE(model().motion(), motion_while_down);
  QCOMPARE(box("forward_box")->value(), motion_while_down.forward_mm);
  QCOMPARE(box("up_box")->value(), motion_while_down.up_mm);
  // The grip stays where it was put, and goes where a number sends it.
  QVERIFY((grip() - ball - QPoint(-24, -12)).manhattanLength() <= 4);
  reset_motion();
  QVERIFY((grip() - ball).manhattanLength() <= 2);
}

void WindowTest::oneAxisGripKeepsToItsAxis() {
  look_from("left_action");
  // The forward grip is 16 mm before the ball: find the scale by a known motion.
  const QPoint at_zero = grip();
  type("forward_box", "10");
  QTest::qWait(300);
  const int ten_mm = at_zero.x() - grip().x();
  QVERIFY(ten_mm > 10);
  reset_motion();
  QTest::qWait(300);
  const QPoint forward_grip = at_zero - QPoint(ten_mm * 16 / 10, 0);
  drag(forward_grip, forward_grip + QPoint(-ten_mm / 2, 30));
  QVERIFY(std::abs(model().motion().forward_mm - 5) < 0.6);
  QCOMPARE(model().motion().up_mm, 0.0);
}

void WindowTest::mouseBesideTheGripTurnsTheCameraOnly() {
  look_from("front_action");
  vtkCamera* camera = view().renderer()->GetActiveCamera();
  const Eigen::Vector3d before(camera->GetPosition());
  const QPoint beside(canvas()->width() / 2, canvas()->height() / 3);
  drag(beside, beside + QPoint(60, 0));
  const Eigen::Vector3d after(camera->GetPosition());
  QVERIFY((after - before).norm() > 20);
  QCOMPARE(model().motion(), JawMotion{});
}

void WindowTest::keysAndActionsPlaceTheCamera() {
  vtkCamera* camera = view().renderer()->GetActiveCamera();
  const auto direction = [&] { return Eigen::Vector3d(camera->GetDirectionOfProjection()); };
  canvas()->setFocus();
  const std::tuple<int, Qt::KeyboardModifiers, Eigen::Vector3d> keys[] = {
      {Qt::Key_1, Qt::KeypadModifier, {0, 1, 0}},
      {Qt::Key_3, Qt::KeypadModifier, {-1, 0, 0}},
      {Qt::Key_9, Qt::KeypadModifier, {1, 0, 0}},
      {Qt::Key_7, Qt::KeypadModifier, {0, 0, -1}}};
  for (const auto& [key, modifiers, wanted] : keys) {
    QTest::keyClick(canvas(), static_cast<Qt::Key>(key), modifiers);
    QVERIFY((direction() - wanted).norm() < 1e-6);
  }
  QTest::keyClick(canvas(), Qt::Key_R);
  QVERIFY(direction().x() < -0.5 && direction().y() > 0.5);
  // VTK's own letters do nothing: e would end the program.
  for (const char letter : {'e', 'q', 'w', 's', '3', 'f'}) QTest::keyClick(canvas(), letter);
  QVERIFY(window_->isVisible());
}

void WindowTest::viewSwitchesChangeThePicture() {
  look_from("three_quarter_action");
  type("forward_box", "6");
  await_answer();
  const Picture plain = view().picture();
  for (const char* name :
       {"textured_action", "bone_action", "before_action", "colour_map_action"}) {
    trigger(name);
    QVERIFY2(differing_pixels(plain, view().picture()) > 500, name);
    trigger(name);
    QVERIFY2(differing_pixels(plain, view().picture()) < 20, name);
  }
  find<QSlider>("opacity_slider")->setValue(40);
  QVERIFY(differing_pixels(plain, view().picture()) > 500);
  find<QSlider>("opacity_slider")->setValue(100);
  QVERIFY(differing_pixels(plain, view().picture()) < 20);
}

void WindowTest::readoutsFollowTheMotion() {
  const auto* table = find<QTableWidget>("landmark_table");
  QCOMPARE(table->rowCount(), 10);
  QCOMPARE(label("max_value"), QString("0.0 mm"));
  type("forward_box", "6");
  for (int row = 0; row < table->rowCount(); ++row) {
    if (table->item(row, 0)->text() != "Pogonion soft") continue;
    QVERIFY(std::abs(table->item(row, 1)->text().toDouble() - 6) < 0.3);
    QVERIFY(std::abs(table->item(row, 2)->text().toDouble() - 1) < 0.05);
  }
  const double largest = label("max_value").section(' ', 0, 0).toDouble();
  const double mean = label("mean_value").section(' ', 0, 0).toDouble();
  QVERIFY(largest > 5.5 && largest < 7);
  QVERIFY(mean > 1 && mean < largest);
  // They become those of the refined answer.
  await_answer();
  const Prediction& refined = *model().refined();
  QCOMPARE(label("p95_value"), QString("%1 mm").arg(refined.displacement.p95, 0, 'f', 1));
  for (const auto& [name, landmark] : model().response().landmarks) {
    QCOMPARE(landmark.ratio, refined.landmarks.at(name).ratio);
  }
}

void WindowTest::refinedAnswerReplacesTheQuickOne() {
  type("forward_box", "6");
  QVERIFY(model().refinement() == Refinement::waiting);
  QVERIFY(model().refined() == nullptr);
  QVERIFY(caption().contains("6 mm forward"));
  QVERIFY(caption().contains("quick answer, linear model"));
  QVERIFY(label("model_label").contains("Quick answer, linear model on"));
  QTRY_VERIFY_WITH_TIMEOUT(model().refinement() == Refinement::running, patience);
  QVERIFY(label("model_label").contains("being refined"));
  QVERIFY(find<QToolButton>("cancel_button")->isVisible());
  await_answer();
  QVERIFY(!find<QToolButton>("cancel_button")->isVisible());
  const Prediction& refined = *model().refined();
  QVERIFY(model().response().face == refined.face_points);
  QVERIFY(refined.answer.quick_error.total.p95 > 0);
  const QString error = QString::number(refined.answer.error.total.p95, 'f', 2) + " mm";
  QVERIFY(caption().contains("estimated error " + error));
  QVERIFY(label("model_label").contains("estimated error " + error));
  QVERIFY(find<QLabel>("model_label")
              ->toolTip()
              .startsWith(QString::fromStdString(refined.answer.why), Qt::CaseInsensitive));
  // The next motion is answered at once, by the quick model again.
  type("forward_box", "5");
  QVERIFY(model().refined() == nullptr);
  QVERIFY(model().response().face == predicted(model(), {.forward_mm = 5}));
  QVERIFY(caption().contains("quick answer"));
  QVERIFY(!caption().contains("estimated"));
}

void WindowTest::dragReturnsToTheQuickAnswer() {
  type("forward_box", "6");
  await_answer();
  look_from("left_action");
  const QPoint ball = grip();
  drag(ball, ball + QPoint(-12, 0), [&] {
    QVERIFY(model().motion().forward_mm > 6);
    QVERIFY(model().refined() == nullptr);
    QVERIFY(model().response().face == predicted(model(), model().motion()));
    QVERIFY(caption().contains("quick answer"));
    // The hand rests, and the refined answer comes while it holds the grip.
    await_answer();
    QVERIFY(model().response().face == model().refined()->face_points);
  });
  QVERIFY(model().refinement() == Refinement::done);
}

void WindowTest::betterModelsAnswerWhereTheToleranceAsks() {
  MainWindow window;
  const User user{window};
  window.show();
  const CaseController& model = user.model();
  user.open(changed_case("exact.json", [](SurgicalCase& plan) {
    plan.tissue.strain = Strain::large;
    plan.tissue.elements = Elements::linear;
    plan.tissue.tolerance_mm = 1e-4;
  }));
  user.await_answer();
  QVERIFY(model.refined()->answer.large_strain);
  QVERIFY((model.response().face - predicted(model, model.motion())).norm() > 0.1);
  QVERIFY(user.caption().contains("neo-Hookean model on linear elements"));
  // What is estimated above the tolerance is told as a warning.
  QVERIFY(user.label("model_label").contains("above the tolerance of 0.00 mm"));
  QVERIFY(user.label("model_label").contains(warning_colour(window.palette()).name()));
  QVERIFY(user.caption().contains("above the tolerance"));
}

void WindowTest::refiningCanBeCancelled() {
  type("forward_box", "6");
  QTRY_VERIFY_WITH_TIMEOUT(model().refinement() == Refinement::running, patience);
  click("cancel_button");
  QVERIFY(model().refinement() == Refinement::stopped);
  QVERIFY(!find<QToolButton>("cancel_button")->isVisible());
  QVERIFY(label("model_label").contains("not refined"));
  QTest::qWait(1500);  // longer than it takes
  QVERIFY(model().refinement() == Refinement::stopped);
  QVERIFY(model().response().face == predicted(model(), {.forward_mm = 6}));
  QVERIFY(!message_visible());
  type("forward_box", "5");
  await_answer();
}

void WindowTest::motionThatIsTooLargeKeepsTheQuickAnswer() {
  MainWindow window;
  const User user{window};
  window.show();
  user.open(changed_case("large.json", [](SurgicalCase& plan) {
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
  user.open(changed_case("two.json", cut_in_halves));
  QVERIFY2(model.has_case(), qPrintable(user.label("message_text")));
  auto* choice = user.find<QComboBox>("segment_box");
  QVERIFY(choice->isVisible());
  QVERIFY(!find<QComboBox>("segment_box")->isVisible());
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
  QVERIFY(user.grip().x() < left_grip.x() - 20);  // the patient's right is the picture's left
  const QPoint right_grip = user.grip();
  user.drag(right_grip, right_grip + QPoint(0, 20));
  const JawMotion right = model.motion();
  QVERIFY(right.up_mm < -1 && model.motions()[0] == JawMotion{.forward_mm = 3});
  QVERIFY(poses_are({.forward_mm = 3}, right));
  QVERIFY(user.caption().contains("left: 3 mm forward\nright: "));
  // Both are in what is refined and exported.
  user.await_answer();
  QCOMPARE(model.refined()->motions.size(), std::size_t{2});
  const fs::path out = path("two").toStdString();
  window.controller().export_face(out);
  user.settle();
  const QString report = QString::fromStdString(read_text_file(out / "report.json"));
  QVERIFY(report.contains("\"forward_mm\": 3"));
  QVERIFY(report.contains(QString("\"up_mm\": %1").arg(right.up_mm)));
}

void WindowTest::motionInTimeIsPlayed() {
  MotionPlayer& player = window_->player();
  QAction* play = action("play_action");
  QVERIFY(!play->isEnabled());  // nothing has moved
  type("forward_box", "6");
  await_answer();
  const Picture predicted_face = view().picture();
  const Points rest = model().loaded().anatomy->face.mesh.surface.vertices;
  // The film is of linear elements, also where a drag has quadratic ones by now.
  Points quick;
  model().loaded().model->predict(model().response().poses, quick);
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
  QVERIFY(caption().contains("20 times slower"));
  QVERIFY(caption().contains("damped motion, alpha 20/s, beta 0.01 s"));
  QVERIFY(label("model_label").contains("damped motion"));
  QVERIFY(differing_pixels(predicted_face, view().picture()) > 500);
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, patience);
  QVERIFY(!play->isChecked());
  disconnect(listener);
  // From rest, ever nearer to the linear model's answer, and then back to the prediction.
  QCOMPARE(times.front(), 0.0);
  QVERIFY(std::is_sorted(times.begin(), times.end()));
  QVERIFY(std::abs(distances.front() - (rest - quick).norm()) < 1e-6);
  QVERIFY(distances.back() < 0.01 * distances.front());
  QVERIFY(caption().contains("estimated error"));
  QVERIFY(differing_pixels(predicted_face, view().picture()) < 20);
}

void WindowTest::playingStopsWhenAsked() {
  MotionPlayer& player = window_->player();
  type("forward_box", "6");
  canvas()->setFocus();
  QTest::keyClick(canvas(), Qt::Key_P);  // computing
  QVERIFY(player.is_computing());
  QTest::keyClick(canvas(), Qt::Key_P);
  QVERIFY(!player.is_running());
  QTest::keyClick(canvas(), Qt::Key_P);
  QTRY_VERIFY_WITH_TIMEOUT(player.is_playing(), patience);
  type("forward_box", "5");
  QVERIFY(!player.is_running());
  QVERIFY(caption().contains("5 mm forward"));
  QVERIFY(model().response().face == predicted(model(), {.forward_mm = 5}));
}

void WindowTest::exportChangesVertexLinesOnly() {
  type("forward_box", "6");
  const QString target = path("exported");
  answer("export_action", "export_dialog", target);
  settle();
  QVERIFY(message_visible());
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
  const QString target = path("not_moved");
  answer("export_action", "export_dialog", target);
  settle();
  QCOMPARE(read_text_file(target.toStdString() + "/predicted.obj"),
           read_text_file(demo_.toStdString() + "/photograph/face.obj"));
}

void WindowTest::exportOntoSomethingThatExistsIsRefused() {
  const QString target = path("already there");
  write_text_file(target.toStdString(), "a file of the user");
  answer("export_action", "export_dialog", target);
  settle();
  QVERIFY(message_visible());
  QVERIFY(label("message_title").contains("already there"));
  QVERIFY(label("message_text").contains("exist"));
  QVERIFY(!label("message_remedy").isEmpty());
  QCOMPARE(read_text_file(target.toStdString()), std::string("a file of the user"));
  click("message_close");
  QVERIFY(!message_visible());
}

void WindowTest::pictureIsSaved() {
  QTest::qWait(100);  // the layout, after the message of the test before
  const Picture shown = view().picture();
  const double ratio = canvas()->devicePixelRatioF();
  QCOMPARE(shown.width, static_cast<int>(canvas()->width() * ratio));
  QCOMPARE(shown.height, static_cast<int>(canvas()->height() * ratio));
  answer("picture_action", "picture_dialog", path("view.png"));
  QCOMPARE(read_picture_file(path("view.png").toStdString()) == shown, true);
  answer("picture_action", "picture_dialog", path("no such folder/view.png"));
  QVERIFY(message_visible());
  QVERIFY(label("message_title").contains("view.png"));
}

void WindowTest::brokenCasesLeaveTheOpenOneAlone() {
  type("forward_box", "3");
  // The caption and the face change once more when the answer comes.
  await_answer();
  QTest::qWait(100);  // the layout, after the message of the test before
  const Picture before = view().picture();
  const LoadedCase* open_case = &model().loaded();
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
    find<QWidget>("message_bar")->hide();
    window_->open_case(file);
    settle();
    QVERIFY2(message_visible(), named);
    QVERIFY2(label("message_title").contains(named), qPrintable(label("message_title")));
    QVERIFY(label("message_remedy").size() > 15);
    QCOMPARE(&model().loaded(), open_case);
    QCOMPARE(model().motion(), (JawMotion{.forward_mm = 3}));
    QCOMPARE(window_->size(), QSize(1280, 800));  // a long path does not stretch the window
  }
  click("message_close");
  QTRY_VERIFY(differing_pixels(before, view().picture()) < 20);
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
  user.open(demo_ + "/case.json");
  QVERIFY(user.model().has_case());
}

void WindowTest::laterOpeningWins() {
  QSignalSpy opened(&model(), &CaseController::case_opened);
  action("bone_action")->setChecked(false);
  look_from("three_quarter_action");
  const Picture without_bone = view().picture();
  const QString second =
      changed_case("second.json", [](SurgicalCase& plan) { plan.name = "the second"; });
  window_->open_case(demo_ + "/case.json");
  QTest::qWait(100);
  window_->open_case(second);
  settle();
  QTest::qWait(200);
  QCOMPARE(opened.count(), 1);
  QCOMPARE(model().loaded().plan.name, std::string("the second"));
  QVERIFY(window_->windowTitle().startsWith("the second"));
  // What the user chose to see holds for the next case too.
  reset_motion();
  QTRY_VERIFY(differing_pixels(without_bone, view().picture()) < 20);
  action("bone_action")->setChecked(true);
  QVERIFY(differing_pixels(without_bone, view().picture()) > 500);
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
  const fs::path first = path("first").toStdString(), second = path("second").toStdString();
  QVERIFY(action("export_action")->isEnabled());
  model().export_face(first);
  QVERIFY(!action("export_action")->isEnabled());
  model().export_face(second);
  settle();
  QVERIFY(fs::exists(first / "predicted.obj"));
  QVERIFY(!fs::exists(second));
  QVERIFY(action("export_action")->isEnabled());
  model().export_face(second);
  click("cancel_button");
  QVERIFY(action("export_action")->isEnabled());
  QVERIFY(!model().is_working());
}

void WindowTest::noticesAreJoined() {
  emit model().noticed("the first");
  emit model().noticed("the second");
  QCOMPARE(label("message_text"), QString("the first\nthe second"));
  for (int i = 0; i < 60; ++i) emit model().noticed("one of many");
  QTest::qWait(100);
  QVERIFY(label("message_text").startsWith("the first\nthe second\none of many"));
  QVERIFY(find<QWidget>("message_bar")->height() < 200);
  QVERIFY(find<QLabel>("message_text")->height() > 600);  // whole, to be scrolled
  QCOMPARE(window_->size(), QSize(1280, 800));
  click("message_close");
  emit model().noticed("another");
  QCOMPARE(label("message_text"), QString("another"));
  click("message_close");
}

void WindowTest::beforeEndsADrag() {
  look_from("left_action");
  const QPoint ball = grip();
  QSignalSpy ended(&view(), &FaceView::drag_ended);
  drag(ball, ball + QPoint(-24, -12), [&] { trigger("before_action"); });
  QCOMPARE(ended.count(), 1);
  trigger("before_action");
  // The grip is in nobody's hand: it lets the mouse pass, and goes where a number sends it.
  const JawMotion motion = model().motion();
  QVERIFY(motion.forward_mm > 2);
  QTest::mouseMove(canvas(), ball + QPoint(-60, -60));
  QTest::mouseMove(canvas(), ball + QPoint(-80, -60));
  QCOMPARE(model().motion(), motion);
  reset_motion();
  QVERIFY((grip() - ball).manhattanLength() <= 2);
  drag(ball, ball + QPoint(-24, 0));
  QVERIFY(model().motion().forward_mm > 2);
}

void WindowTest::demoCaseMayBeMadeTwiceAtOnce() {
  const fs::path cache =
      QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString();
  const auto make = [&cache] {
    Progress progress;
    return cached_demo_case(cache, QCoreApplication::applicationFilePath().toStdString(), progress);
  };
  std::future<fs::path> other = std::async(std::launch::async, make);
  made_ = make();
  QVERIFY(other.get() == made_);
  QVERIFY(fs::exists(made_ / "case.json"));
  QVERIFY(std::distance(fs::directory_iterator(cache), fs::directory_iterator()) == 1);
}

void WindowTest::exportOutlivesTheWindow() {
  const QString target = path("at_the_end");
  {
    MainWindow window;
    window.show();
    User(window).open(plain_case());
    window.controller().export_face(target.toStdString());
  }
  QVERIFY(fs::exists(target.toStdString() + "/predicted.obj"));
}

void WindowTest::modelOfForcesDoesNotTurn() {
  MainWindow window;
  const User user{window};
  window.show();
  user.open(changed_case("forces.json", [](SurgicalCase& plan) {
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
  return gnathion::test::run<gnathion::test::WindowTest>(argc, argv);
}

#include "window_test.moc"
