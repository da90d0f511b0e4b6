// The surgeon's hour from beginning to end, by mouse and keyboard: open the demo case, cut, paint,
// drag, compare, undo, redo, save, open again, export; what is asserted is the model's state and
// the files. With GNATHION_SHOTS set to a folder it leaves a picture of each step there: those of
// docs/user-guide.md (./run pictures).
#include <QComboBox>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>

#include "app/driven_window.h"
#include "io/files.h"
#include "io/obj_document.h"

namespace gnathion::test {

/// Each step goes on where the one before ended.
class HourTest : public QObject, private DrivenWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { start_window(); }
  void openTheDemo();
  void cutTheChin();
  void paintTheRegion();
  void dragTheChin();
  void compare();
  void undoAndRedoAll();
  void saveAndReopen();
  void exportTheFace();
  void cleanupTestCase() { window_.reset(); }

 private:
  Points moved_;  ///< the face predicted for the chin that was dragged
};

void HourTest::openTheDemo() {
  QCOMPARE(find<QStackedWidget>("pages")->currentWidget()->objectName(), QString("welcome_page"));
  shoot("welcome");
  trigger("demo_action");
  QTRY_VERIFY_WITH_TIMEOUT(model().has_model(), patience);
  settle();
  shoot("opened");
}

void HourTest::cutTheChin() {
  choose_step("BonePanel");
  shoot("bone");
  click("remove_segment_button");
  settle();
  QVERIFY(!model().has_segments());
  click("chin_button");
  QTRY_VERIFY_WITH_TIMEOUT(find<QAbstractButton>("cut_button")->isEnabled(), patience);
  shoot("chin_cut");
  click("cut_button");
  settle();
  QVERIFY(model().has_segments());
  const BoneSegment& chin = model().loaded().anatomy->segments[0];
  QVERIFY(chin.volume_mm3 > 1000 && chin.volume_mm3 < 20000);
  shoot("cut");
}

void HourTest::paintTheRegion() {
  choose_step("RegionPanel");
  settle();
  const std::size_t before = model().loaded().model->problem().face_vertices.size();
  look_from("front_action");
  shoot("region");
  const auto& landmarks = model().plan().landmarks;
  click("paint_button");
  drag(pixel_of(landmarks.at("mouth_corner_left")), pixel_of(landmarks.at("nose_tip")));
  settle();
  QVERIFY(model().has_model());
  QVERIFY(model().loaded().model->problem().face_vertices.size() > before);
  shoot("region_painted");
}

void HourTest::dragTheChin() {
  choose_step("motion_page");
  look_from("left_action");
  const QPoint ball = grip();
  const Points rest = model().loaded().anatomy->face.mesh.surface.vertices;
  drag(ball, ball + QPoint(-30, 0), [&] {
    QVERIFY(model().motion().forward_mm > 1);
    QVERIFY((model().response().face - rest).rowwise().norm().maxCoeff() > 1);
  });
  type("forward_box", "6");
  type("up_box", "1");
  QCOMPARE(model().motion().forward_mm, 6.0);
  trigger("three_quarter_action");
  await_answer();
  QVERIFY(model().refined()->answer.error.total.p95 > 0);
  moved_ = model().refined()->face_points;
  shoot("moved");
}

void HourTest::compare() {
  choose_step("ComparePanel");
  auto* mode = find<QComboBox>("mode_box");
  for (int i = 0; i < mode->count(); ++i) {
    mode->setCurrentIndex(i);
    shoot(qPrintable("compare_" + QString::number(i)));
  }
  mode->setCurrentIndex(0);
  QVERIFY(find<QTableWidget>("numbers_table")->item(0, 0) != nullptr);
  choose_step("motion_page");
}

void HourTest::undoAndRedoAll() {
  const SurgicalCase last = model().plan();
  const std::size_t steps = model().history().steps().size();
  QVERIFY(steps >= 5);  // opened, segment removed, cut, painted, moved
  while (action("undo_action")->isEnabled()) {
    trigger("undo_action");
    settle();
  }
  QCOMPARE(model().history().position(), std::size_t{0});
  QCOMPARE(model().plan().segments.size(), std::size_t{1});
  QCOMPARE(model().plan().segments[0].name, std::string("segment"));
  while (action("redo_action")->isEnabled()) {
    trigger("redo_action");
    settle();
  }
  QVERIFY(model().plan() == last);
  QCOMPARE(model().history().steps().size(), steps);
}

void HourTest::saveAndReopen() {
  const SurgicalCase plan = model().plan();
  const std::size_t steps = model().history().steps().size();
  const QSignalSpy saved(&model(), &CaseController::saved);
  const QString file = path("hour.json");
  answer("save_as_action", "save_dialog", file);
  QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, patience);
  QVERIFY(!model().is_modified());

  MainWindow again;
  const User other{again};
  again.resize(1280, 800);
  again.show();
  again.open_case(file);
  QTRY_VERIFY_WITH_TIMEOUT(other.model().has_model(), patience);
  other.settle();
  SurgicalCase reopened = other.model().plan();
  // The demo's own files are copied beside the case when it is saved.
  reopened.ct = plan.ct;
  reopened.photograph->obj = plan.photograph->obj;
  QVERIFY(reopened == plan);
  QCOMPARE(other.model().history().steps().size(), steps);
  other.await_answer();
  QVERIFY((other.model().refined()->face_points - moved_).cwiseAbs().maxCoeff() < 1e-6);
  other.trigger("undo_action");
  other.settle();
  QCOMPARE(other.model().history().position(), steps - 2);
}

void HourTest::exportTheFace() {
  await_answer();
  QVERIFY((model().refined()->face_points - moved_).cwiseAbs().maxCoeff() < 1e-6);
  const QSignalSpy exported(&model(), &CaseController::exported);
  const QString folder = path("face");
  answer("export_action", "export_dialog", folder);
  QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, patience);
  const ObjDocument face = ObjDocument::read(folder.toStdString() + "/predicted.obj");
  const Face& original = model().loaded().anatomy->face;
  const Points expected = original.file_vertices(model().refined()->face_points);
  QVERIFY((face.mesh().surface.vertices - expected).cwiseAbs().maxCoeff() < 1e-5);
  // All that is not a vertex stays to the letter. (Not the triangles: quads are cut along their
  // shorter diagonal, which a motion may change.)
  const auto lines = [](const std::filesystem::path& file) {
    return QString::fromStdString(read_text_file(file)).split('\n');
  };
  const QStringList before = lines(original.document.path()),
                    after = lines(folder.toStdString() + "/predicted.obj");
  QCOMPARE(after.size(), before.size());
  for (int i = 0; i < before.size(); ++i) {
    if (!before[i].startsWith("v ")) QCOMPARE(after[i], before[i]);
  }
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  return gnathion::test::run<gnathion::test::HourTest>(argc, argv);
}

#include "hour_test.moc"
