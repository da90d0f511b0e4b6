// The surgeon's hour from beginning to end, by mouse and keyboard: open the demo case, cut, paint,
// drag, compare, undo, redo, save, open again, export; what is asserted is the model's state and
// the files. With GNATHION_SHOTS set to a folder it leaves a picture of each step there: those of
// docs/user-guide.md (./run pictures).
#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <memory>

#include "app/display.h"
#include "app/user.h"
#include "geometry/triangle_mesh.h"
#include "io/case_file.h"
#include "io/files.h"
#include "io/obj_document.h"

namespace gnathion::test {

/// Each step goes on where the one before ended.
class HourTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
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
  User user() const { return {*window_}; }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void HourTest::initTestCase() {
  window_ = std::make_unique<MainWindow>();
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  QApplication::setActiveWindow(window_.get());
}

void HourTest::openTheDemo() {
  const User user = this->user();
  QCOMPARE(user.find<QStackedWidget>("pages")->currentWidget()->objectName(),
           QString("welcome_page"));
  user.shoot("welcome");
  user.action("demo_action")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(user.model().has_model(), User::patience);
  user.settle();
  user.shoot("opened");
}

void HourTest::cutTheChin() {
  const User user = this->user();
  user.choose_step("BonePanel");
  user.shoot("bone");
  user.click("remove_segment_button");
  user.settle();
  QVERIFY(!user.model().has_segments());
  user.click("chin_button");
  QTRY_VERIFY_WITH_TIMEOUT(user.find<QAbstractButton>("cut_button")->isEnabled(), User::patience);
  user.shoot("chin_cut");
  user.click("cut_button");
  user.settle();
  QVERIFY(user.model().has_segments());
  const BoneSegment& chin = user.model().loaded().anatomy->segments[0];
  QVERIFY(chin.volume_mm3 > 1000 && chin.volume_mm3 < 20000);
  user.shoot("cut");
}

void HourTest::paintTheRegion() {
  const User user = this->user();
  user.choose_step("RegionPanel");
  user.settle();
  const std::size_t before = user.model().loaded().model->problem().face_vertices.size();
  user.action("front_action")->trigger();
  QTest::qWait(500);
  user.shoot("region");
  const auto& landmarks = user.model().plan().landmarks;
  user.click("paint_button");
  user.drag(user.pixel_of(landmarks.at("mouth_corner_left")),
            user.pixel_of(landmarks.at("nose_tip")));
  user.settle();
  QVERIFY(user.model().has_model());
  QVERIFY(user.model().loaded().model->problem().face_vertices.size() > before);
  user.shoot("region_painted");
}

void HourTest::dragTheChin() {
  const User user = this->user();
  user.choose_step("motion_page");
  user.action("left_action")->trigger();
  QTest::qWait(500);
  const QPoint grip = user.grip();
  const Points rest = user.model().loaded().anatomy->face.mesh.surface.vertices;
  user.drag(grip, grip + QPoint(-30, 0), [&] {
    QVERIFY(user.model().motion().forward_mm > 1);
    QVERIFY((user.model().response().face - rest).rowwise().norm().maxCoeff() > 1);
  });
  user.type("forward_box", "6");
  user.type("up_box", "1");
  QCOMPARE(user.model().motion().forward_mm, 6.0);
  user.action("three_quarter_action")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::done, User::patience);
  QVERIFY(user.model().refined()->answer.error.total.p95 > 0);
  user.shoot("moved");
}

void HourTest::compare() {
  const User user = this->user();
  user.choose_step("ComparePanel");
  auto* mode = user.find<QComboBox>("mode_box");
  for (int i = 0; i < mode->count(); ++i) {
    mode->setCurrentIndex(i);
    user.shoot(qPrintable("compare_" + QString::number(i)));
  }
  mode->setCurrentIndex(0);
  QVERIFY(user.find<QTableWidget>("numbers_table")->item(0, 0) != nullptr);
  user.choose_step("motion_page");
}

void HourTest::undoAndRedoAll() {
  const User user = this->user();
  const SurgicalCase last = user.model().plan();
  const Points face = user.model().refined()->face_points;
  const std::size_t steps = user.model().history().steps().size();
  QVERIFY(steps >= 5);  // opened, segment removed, cut, painted, moved
  while (user.action("undo_action")->isEnabled()) {
    user.action("undo_action")->trigger();
    user.settle();
  }
  QCOMPARE(user.model().history().position(), std::size_t{0});
  QCOMPARE(user.model().plan().segments.size(), std::size_t{1});
  QCOMPARE(user.model().plan().segments[0].name, std::string("segment"));
  while (user.action("redo_action")->isEnabled()) {
    user.action("redo_action")->trigger();
    user.settle();
  }
  QVERIFY(user.model().plan() == last);
  QCOMPARE(user.model().history().steps().size(), steps);
  QTRY_VERIFY_WITH_TIMEOUT(user.model().refinement() == Refinement::done, User::patience);
  QVERIFY((user.model().refined()->face_points - face).cwiseAbs().maxCoeff() < 1e-6);
}

void HourTest::saveAndReopen() {
  const User user = this->user();
  const SurgicalCase plan = user.model().plan();
  const std::size_t steps = user.model().history().steps().size();
  const Points face = user.model().refined()->face_points;
  const QSignalSpy saved(&user.model(), &CaseController::saved);
  const QString file = folder_.filePath("hour.json");
  user.answer("save_as_action", "save_dialog", file);
  QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, User::patience);
  QVERIFY(!user.model().is_modified());

  MainWindow again;
  const User other{again};
  again.resize(1280, 800);
  again.show();
  again.open_case(file);
  QTRY_VERIFY_WITH_TIMEOUT(other.model().has_model(), User::patience);
  other.settle();
  SurgicalCase reopened = other.model().plan();
  // The demo's own files are copied beside the case when it is saved.
  reopened.ct = plan.ct;
  reopened.photograph->obj = plan.photograph->obj;
  QVERIFY(reopened == plan);
  QCOMPARE(other.model().history().steps().size(), steps);
  QTRY_VERIFY_WITH_TIMEOUT(other.model().refinement() == Refinement::done, User::patience);
  QVERIFY((other.model().refined()->face_points - face).cwiseAbs().maxCoeff() < 1e-6);
  other.action("undo_action")->trigger();
  other.settle();
  QCOMPARE(other.model().history().position(), steps - 2);
}

void HourTest::exportTheFace() {
  const User user = this->user();
  const QSignalSpy exported(&user.model(), &CaseController::exported);
  const QString folder = folder_.filePath("face");
  user.answer("export_action", "export_dialog", folder);
  QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, User::patience);
  const ObjDocument face = ObjDocument::read(folder.toStdString() + "/predicted.obj");
  const Face& original = user.model().loaded().anatomy->face;
  const Points expected = original.file_vertices(user.model().refined()->face_points);
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
  QCoreApplication::setApplicationName("gnathion");
  const QTemporaryDir home;  // settings, cache and recovery are written there
  for (const char* folder : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
    qputenv(folder, home.path().toLocal8Bit());
  }
  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  Q_INIT_RESOURCE(gnathion);
  gnathion::use_c_numbers();
  gnathion::test::HourTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "hour_test.moc"
