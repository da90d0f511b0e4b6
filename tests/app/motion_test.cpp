#include <QComboBox>
#include <QSlider>
#include <QToolButton>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "app/driven_window.h"
#include "app/motion_panel.h"
#include "app/motion_words.h"
#include "phantom/head_phantom.h"
#include "render/turning_rings.h"

namespace gnathion::test {
namespace {

using Eigen::Vector3d;

double distance(const RigidMotion& a, const RigidMotion& b) {
  const Vector3d chin(0, -90, -75);
  return (a.rotation - b.rotation).norm() + (a(chin) - b(chin)).norm();
}

}  // namespace

/// Moving segments in the window as a user does: mouse, keys, numbers.
class MotionTest : public QObject, private DrivenWindow {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanupTestCase();

  void ringTurnsTheSegmentAboutThePivot();
  void secondRingGoesOnExactlyFromTheFirst();
  void ballStillShiftsAndKeepsTheTurn();
  void undoAndRedoGiveTheExactNumbers();
  void lockKeepsTheGripsToOneAxis();
  void numbersBeyondTheirHundredthsAreKept();
  void anotherPivotLeavesTheBone();
  void pivotThatTakesTooLargeAShiftIsRefused();
  void hingeIsFoundAndTurnsAboutTheCondyles();
  void hingeAxisCanBeTyped();
  void hingeStopsAtTheLimits();
  void ghostShowsWhereTheSegmentWas();
  void collisionsAreSaidAndMarked();
  void clickOnASegmentChoosesIt();
  void stepThatIsLeftTakesItsMarksAlong();

 private:
  const BoneSegment& bone() const {
    return model().loaded().anatomy->segments[model().active_segment()];
  }
  RigidMotion pose() const { return rigid_motion(model().motion(), bone().pivot); }

  /// On the ring about an axis, where it is by now.
  Vector3d on_ring(int axis, double degrees) const {
    Vector3d p = pose()(bone().pivot);
    const double angle = degrees * std::numbers::pi / 180;
    p[(axis + 1) % 3] += TurningRings::radius * std::cos(angle);
    p[(axis + 2) % 3] += TurningRings::radius * std::sin(angle);
    return p;
  }
  void choose_pivot(int row) const {
    auto* box = find<QComboBox>("pivot_box");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < row; ++i) QTest::keyClick(box, Qt::Key_Down);
    settle();
  }
  QString plain_;
};

void MotionTest::initTestCase() {
  make_demo();
  plain_ = changed_case("plain.json", [](SurgicalCase& plan) { plan.segments[0].motion = {}; });
  start_window({1280, 900});
}

void MotionTest::init() {
  activate();
  // Opening is slow; what a test has left behind is taken back where that is possible.
  const bool as_it_was = model().has_case() && model().plan().segments.size() == 1 &&
                         !model().plan().segments[0].pivot;
  if (!as_it_was) open(plain_);
  QVERIFY(model().has_model());
  find<QAbstractButton>("reset_button")->click();
  model().hold_motion(false);
  find<QSlider>("opacity_slider")->setValue(100);
}

void MotionTest::cleanupTestCase() {
  window_.reset();
}

void MotionTest::ringTurnsTheSegmentAboutThePivot() {
  look_from("left_action");
  // The left profile looks along the pitch ring: its upper front, towards the top.
  const QPoint from = pixel_of(on_ring(0, 155));
  drag(from, pixel_of(on_ring(0, 147)));
  const JawMotion motion = model().motion();
  QVERIFY2(std::abs(motion.pitch_deg - 8) < 1.2, qPrintable(motion_words(motion)));
  QCOMPARE(motion, (JawMotion{.pitch_deg = motion.pitch_deg}));
  QVERIFY(std::abs(10 * motion.pitch_deg - std::round(10 * motion.pitch_deg)) < 1e-9);
  QCOMPARE(box("pitch_box")->value(), std::round(100 * motion.pitch_deg) / 100);
  QVERIFY(distance(model().response().poses[0], pose()) < 1e-12);
  QCOMPARE(model().history().undo_name().substr(0, 4), std::string("Move"));
}

void MotionTest::secondRingGoesOnExactlyFromTheFirst() {
  model().set_motion({.forward_mm = 3, .pitch_deg = 6, .roll_deg = 4, .yaw_deg = -7});
  QTest::qWait(300);
  const RigidMotion before = pose();
  const Vector3d centre = before(bone().pivot);
  look_from("front_action");
  // The front looks along the roll ring (y); its left upper part, upwards: the left side rises.
  drag(pixel_of(on_ring(1, 60)), pixel_of(on_ring(1, 50)));
  const RigidMotion after = model().response().poses[0];
  const Eigen::AngleAxisd turn(after.rotation * before.rotation.transpose());
  const double degrees = turn.angle() * 180 / std::numbers::pi;
  QVERIFY2(degrees > 8.5 && degrees < 11.5, qPrintable(QString::number(degrees)));
  QVERIFY((turn.axis() - Vector3d(0, -1, 0)).norm() < 1e-9);
  QVERIFY((after(bone().pivot) - centre).norm() < 1e-9);
  QVERIFY(distance(after, pose()) < 1e-12);
}

void MotionTest::ballStillShiftsAndKeepsTheTurn() {
  model().set_motion({.pitch_deg = 5, .yaw_deg = 2.125});
  look_from("left_action");
  // The one-axis grip for up is above the yellow ball, which lies before the chin.
  QPoint ball(-1, -1);
  const QImage image = canvas()->grabFramebuffer();
  for (int y = 0; y < image.height() && ball.x() < 0; ++y) {
    for (int x = 0; x < image.width() && ball.x() < 0; ++x) {
      const QColor c = image.pixelColor(x, y);
      if (c.red() > 200 && c.green() > 130 && c.blue() < 60) ball = QPoint(x, y + 6);
    }
  }
  QVERIFY(ball.x() > 0);
  drag(ball, ball + QPoint(-20, 0));
  QVERIFY(model().motion().forward_mm > 1);
  QCOMPARE(model().motion().pitch_deg, 5.0);
  QCOMPARE(model().motion().yaw_deg, 2.125);
}

void MotionTest::undoAndRedoGiveTheExactNumbers() {
  type("forward_box", "6");
  QTest::qWait(300);  // the motion rests: a step
  look_from("left_action");
  drag(pixel_of(on_ring(0, 155)), pixel_of(on_ring(0, 149)));
  const JawMotion first = model().motion();
  look_from("front_action");
  drag(pixel_of(on_ring(1, 60)), pixel_of(on_ring(1, 55)));
  const JawMotion second = model().motion();
  QVERIFY(first != (JawMotion{.forward_mm = 6}));
  QVERIFY(first != second);
  model().undo();
  QVERIFY(model().motion() == first);
  model().undo();
  QVERIFY(model().motion() == (JawMotion{.forward_mm = 6}));
  model().undo();
  QVERIFY(model().motion() == JawMotion{});
  for (int i = 0; i < 3; ++i) model().redo();
  QVERIFY(model().motion() == second);
  QVERIFY(distance(model().response().poses[0], pose()) == 0);
}

void MotionTest::lockKeepsTheGripsToOneAxis() {
  look_from("left_action");
  canvas()->setFocus();
  QTest::keyClick(canvas(), Qt::Key_Z);
  QVERIFY(find<QToolButton>("lock_z_button")->isChecked());
  // The pitch ring is gone: the camera turns instead.
  const Vector3d eye(window_->face_view().renderer()->GetActiveCamera()->GetPosition());
  drag(pixel_of(on_ring(0, 135)), pixel_of(on_ring(0, 135)) + QPoint(-20, 0));
  QVERIFY(model().motion() == JawMotion{});
  const Vector3d turned_eye(window_->face_view().renderer()->GetActiveCamera()->GetPosition());
  QVERIFY((eye - turned_eye).norm() > 5);
  QTest::keyClick(canvas(), Qt::Key_X);
  QVERIFY(find<QToolButton>("lock_x_button")->isChecked());
  QVERIFY(!find<QToolButton>("lock_z_button")->isChecked());
  click("lock_x_button");
  QVERIFY(!find<QToolButton>("lock_x_button")->isChecked());
  look_from("left_action");
  drag(pixel_of(on_ring(0, 135)), pixel_of(on_ring(0, 130)));
  QVERIFY(model().motion().pitch_deg > 1);
}

void MotionTest::numbersBeyondTheirHundredthsAreKept() {
  model().set_motion({.forward_mm = 1.23456789, .yaw_deg = 0.333333});
  QCOMPARE(box("forward_box")->value(), 1.23);
  type("up_box", "2");
  QVERIFY(model().motion() ==
          (JawMotion{.forward_mm = 1.23456789, .up_mm = 2, .yaw_deg = 0.333333}));
  QCOMPARE(motion_words(model().motion()), QString("1.23 mm forward, 2 mm up, 0.33° chin to left"));
  QCOMPARE(motion_words({.forward_mm = 1e-14}), QString("not moved"));
}

void MotionTest::anotherPivotLeavesTheBone() {
  const Vector3d centre = bone().pivot;
  model().set_motion({.forward_mm = 4, .pitch_deg = 9, .roll_deg = -3, .yaw_deg = 5});
  QTest::qWait(300);
  const JawMotion told = model().motion();
  const RigidMotion before = pose();
  const FaceModel* face_model = model().loaded().model.get();
  Points face;
  face_model->predict(std::array{before}, face);
  choose_pivot(2);  // the most forward point
  QVERIFY((bone().pivot - centre).norm() > 10);
  QVERIFY(distance(pose(), before) < 1e-12);
  QVERIFY(model().motion().forward_mm != told.forward_mm);
  QCOMPARE(model().motion().pitch_deg, told.pitch_deg);
  QCOMPARE(find<QComboBox>("pivot_box")->currentIndex(), 2);
  QVERIFY(std::abs(box("pivot_y_box")->value() - bone().pivot.y()) < 0.051);
  QCOMPARE(model().history().undo_name(), std::string("Set the pivot"));
  Points after;
  model().loaded().model->predict(std::array{pose()}, after);
  QVERIFY((after - face).cwiseAbs().maxCoeff() < 1e-9);
  QVERIFY(model().loaded().model.get() == face_model);  // nothing was computed anew

  type("pivot_z_box", "-60");
  settle();
  QCOMPARE(bone().pivot.z(), -60.0);
  QVERIFY(distance(pose(), before) < 1e-12);
  QCOMPARE(find<QComboBox>("pivot_box")->currentIndex(), 3);
  // Each choice that the keys went through is a step.
  while (model().history().undo_name() == "Set the pivot") {
    model().undo();
    settle();
  }
  QVERIFY(bone().pivot == centre);
  QVERIFY(model().motion() == told);
  QCOMPARE(find<QComboBox>("pivot_box")->currentIndex(), 0);
}

void MotionTest::pivotThatTakesTooLargeAShiftIsRefused() {
  model().set_motion({.pitch_deg = 25});
  QTest::qWait(300);
  const RigidMotion before = pose();
  type("pivot_y_box", "200");
  QVERIFY(!model().is_working());
  QVERIFY(distance(pose(), before) == 0);
  QVERIFY(label("pivot_note").contains("30 mm"));
  QVERIFY(std::abs(box("pivot_y_box")->value() - bone().pivot.y()) < 0.051);
}

void MotionTest::hingeIsFoundAndTurnsAboutTheCondyles() {
  const auto* panel = find<MotionPanel>("motion_panel");
  QTRY_VERIFY_WITH_TIMEOUT(panel->hinge().has_value(), patience);
  const HingeAxis hinge = *panel->hinge();
  const PhantomTruth truth = phantom_truth();
  // The truth is the condyles' tops, the axis runs through their middles.
  const Vector3d left = truth.landmarks.at("condyle_left") - Vector3d(0, 0, 5);
  const Vector3d right = truth.landmarks.at("condyle_right") - Vector3d(0, 0, 5);
  QVERIFY2((hinge.left - left).norm() < 3.5, qPrintable(label("hinge_note")));
  QVERIFY((hinge.right - right).norm() < 3.5);
  type("hinge_box", "-4");
  const RigidMotion opened = with_hinge_angle({}, hinge, -4);
  QVERIFY(distance(model().response().poses[0], opened) < 1e-11);
  QVERIFY(model().response().poses[0](bone().pivot).z() < bone().pivot.z() - 2);
  QCOMPARE(box("hinge_box")->value(), -4.0);
  // What is done besides leaves its number; nought takes the turn back.
  type("forward_box", "6");
  QCOMPARE(box("hinge_box")->value(), -4.0);
  type("hinge_box", "0");
  QVERIFY(std::abs(model().motion().pitch_deg) < 1e-10);
  // About the hinge the same turn is pitch alone, of a head that is straight.
  find<QAbstractButton>("reset_button")->click();
  choose_pivot(1);
  QVERIFY((bone().pivot - hinge.middle()).norm() < 1e-9);
  type("hinge_box", "3");
  QVERIFY(std::abs(model().motion().pitch_deg - 3) < 0.05);
  QVERIFY(std::abs(model().motion().forward_mm) < 1e-9);
}

void MotionTest::hingeAxisCanBeTyped() {
  QTRY_VERIFY_WITH_TIMEOUT(find<MotionPanel>("motion_panel")->hinge().has_value(), patience);
  click("axis_button");
  QVERIFY(find<QWidget>("axis_group")->isVisible());
  type("axis_right_x_box", "-52");
  type("axis_left_x_box", "48");
  type("axis_left_y_box", "-20");
  click("axis_use_button");
  const HingeAxis hinge = *find<MotionPanel>("motion_panel")->hinge();
  QCOMPARE(hinge.right.x(), -52.0);
  QCOMPARE(hinge.left.x(), 48.0);
  QCOMPARE(hinge.left.y(), -20.0);
  QVERIFY(label("hinge_note").contains("typed"));
  QVERIFY(model().plan().hinge == hinge);  // it is kept with the case, and a step
  trigger("undo_action");
  QVERIFY(!model().plan().hinge && !box("hinge_box")->isEnabled());
  trigger("redo_action");
  QVERIFY(*find<MotionPanel>("motion_panel")->hinge() == hinge);
  type("hinge_box", "5");
  QVERIFY(distance(model().response().poses[0], with_hinge_angle({}, hinge, 5)) < 1e-11);
  // The wrong way round is refused.
  type("axis_left_x_box", "-60");
  click("axis_use_button");
  QVERIFY(label("hinge_note").contains("left"));
  QVERIFY(*find<MotionPanel>("motion_panel")->hinge() == hinge);
  click("axis_find_button");
  QVERIFY(!box("hinge_box")->isEnabled());
  QTRY_VERIFY_WITH_TIMEOUT(box("hinge_box")->isEnabled(), patience);
  QVERIFY(label("hinge_note").contains("found"));
  click("axis_button");
}

void MotionTest::hingeStopsAtTheLimits() {
  QTRY_VERIFY_WITH_TIMEOUT(find<MotionPanel>("motion_panel")->hinge().has_value(), patience);
  const HingeAxis hinge = *find<MotionPanel>("motion_panel")->hinge();
  type("hinge_box", "29");
  const double reached = box("hinge_box")->value();
  QVERIFY2(reached > 10 && reached < 29, qPrintable(QString::number(reached)));
  const RigidMotion moved = model().response().poses[0];
  QVERIFY(distance(moved, with_hinge_angle({}, hinge, hinge_angle(moved, hinge))) < 1e-9);
}

void MotionTest::ghostShowsWhereTheSegmentWas() {
  look_from("left_action");
  find<QSlider>("opacity_slider")->setValue(30);
  FaceView& view = window_->face_view();
  auto* check = find<QCheckBox>("ghost_check");
  QVERIFY(check->isChecked());
  // At rest there is none.
  const Picture rest = view.picture();
  check->click();
  QVERIFY(differing_pixels(rest, view.picture()) < 20);
  check->click();
  model().set_motion({.forward_mm = 8});
  await_answer();
  const Picture with = view.picture();
  check->click();
  const Picture without = view.picture();
  QVERIFY(differing_pixels(with, without) > 400);
  check->click();
  QVERIFY(differing_pixels(with, view.picture()) < 20);
  // Skin that is opaque hides it.
  find<QSlider>("opacity_slider")->setValue(100);
  const Picture opaque = view.picture();
  check->click();
  QVERIFY(differing_pixels(opaque, view.picture()) < 20);
  check->click();
}

void MotionTest::collisionsAreSaidAndMarked() {
  const CollisionWatch& watch = find<MotionPanel>("motion_panel")->collision_watch();
  QTRY_VERIFY_WITH_TIMEOUT(watch.is_up_to_date(), patience);
  QCOMPARE(label("collision_label"), QString("No bone runs into other bone."));
  find<QSlider>("opacity_slider")->setValue(30);
  look_from("left_action");
  // Forward and down nothing is in the way of the jaw's body.
  type("forward_box", "5");
  type("up_box", "-3");
  QTRY_VERIFY(watch.is_up_to_date());
  QVERIFY2(watch.collisions().empty(), qPrintable(label("collision_label")));
  // Back by 2 mm it runs into the rami that stay; nowhere deeper than that, and less where their
  // sides are nearer than the cut.
  type("up_box", "0");
  type("forward_box", "-2");
  QTRY_VERIFY(watch.is_up_to_date());
  QCOMPARE(watch.collisions().size(), std::size_t{1});
  const QString said = label("collision_label");
  QVERIFY2(watch.collisions()[0].depth > 1.2 && watch.collisions()[0].depth < 2.01,
           qPrintable(said));
  QVERIFY2(said.contains("runs") && said.contains("mm into the fixed bone (both sides)"),
           qPrintable(said));
  // Turned to the left about its middle only one side does.
  type("forward_box", "0");
  type("left_box", "0");
  type("yaw_box", "4");
  QTRY_VERIFY(watch.is_up_to_date());
  QVERIFY(!watch.collisions().empty());
  const bool left = watch.collisions()[0].deepest.x() > 0;
  QVERIFY2(label("collision_label").contains(left ? "(left)" : "(right)"),
           qPrintable(label("collision_label")));
  const Picture marked = window_->face_view().picture();
  int red = 0;
  for (std::size_t i = 0; i < marked.rgb.size(); i += 3) {
    if (marked.rgb[i] > 190 && marked.rgb[i + 1] < 40 && marked.rgb[i + 2] < 40) ++red;
  }
  QVERIFY2(red > 20, qPrintable(QString::number(red)));
  click("reset_button");
  QTRY_VERIFY(watch.is_up_to_date());
  QCOMPARE(label("collision_label"), QString("No bone runs into other bone."));
}

void MotionTest::clickOnASegmentChoosesIt() {
  open(changed_case("two.json", cut_in_halves));
  const CollisionWatch& watch = find<MotionPanel>("motion_panel")->collision_watch();
  QTRY_VERIFY_WITH_TIMEOUT(watch.is_ready(), patience);
  QCOMPARE(model().active_segment(), std::size_t{0});
  look_from("front_action");
  const auto on_segment = [&](std::size_t s) {
    const Points& points = model().loaded().anatomy->segments[s].mesh.vertices;
    Eigen::Index front = 0;
    points.col(1).minCoeff(&front);
    // Beside the grips, which lie before the middle.
    Vector3d at = points.row(front);
    Eigen::Index best = front;
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      const Vector3d p = points.row(v);
      if (std::abs(p.z() - at.z()) > 2 || std::abs(p.x()) > 26) continue;
      if (std::abs(p.x()) > std::abs(points(best, 0)) && p.y() < at.y() + 14) best = v;
    }
    return pixel_of(points.row(best).transpose());
  };
  // Skin that hides the bone is no bone.
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, on_segment(1));
  QCOMPARE(model().active_segment(), std::size_t{0});
  find<QSlider>("opacity_slider")->setValue(30);
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, on_segment(1));
  QCOMPARE(model().active_segment(), std::size_t{1});
  QCOMPARE(find<QComboBox>("segment_box")->currentText(), QString("right"));
  // Its own numbers; the halves collide when they are moved together.
  type("left_box", "2");
  QTRY_VERIFY(watch.is_up_to_date());
  QVERIFY2(label("collision_label").contains("Left and right run"),
           qPrintable(label("collision_label")));
  QVERIFY(model().motions()[0] == JawMotion{});
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, on_segment(0));
  QCOMPARE(model().active_segment(), std::size_t{0});
  QCOMPARE(box("left_box")->value(), 0.0);
}

void MotionTest::stepThatIsLeftTakesItsMarksAlong() {
  auto* steps = find<QTabWidget>("steps");
  const int move = steps->currentIndex();
  look_from("left_action");
  const QPoint ring = pixel_of(on_ring(0, 135));
  steps->setCurrentIndex(steps->count() - 1);
  drag(ring, ring + QPoint(0, -8));
  QVERIFY(model().motion() == JawMotion{});
  steps->setCurrentIndex(move);
  look_from("left_action");
  drag(ring, pixel_of(on_ring(0, 130)));
  QVERIFY(model().motion() != JawMotion{});
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  return gnathion::test::run<gnathion::test::MotionTest>(argc, argv);
}

#include "motion_test.moc"
