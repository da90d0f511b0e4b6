#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include <vtkRenderer.h>

#include "app/bone_panel.h"
#include "app/display.h"
#include "app/face_view.h"
#include "app/main_window.h"
#include "bone/cut_box.h"
#include "demo/demo_case.h"
#include "geometry/triangle_mesh.h"
#include "io/case_file.h"

namespace gnathion::test {
namespace {

constexpr int patience = 120000;  // ms, for work beside the window

}  // namespace

/// The step "Bone", driven as a user would. Each test goes on where the one before ended.
class BoneTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void removingTheSegmentLeavesTheBoneWhole();
  void levelFollowsTheSliderAndBecomesAStep();
  void levelThatHoldsNoBoneIsTakenBack();
  void presetShowsWhatComesOff();
  void numbersMoveTheCut();
  void refusedCutSaysWhy();
  void gripMovesTheCut();
  void otherSideOfTheBladeIsTaken();
  void cutMakesTheSegment();
  void undoAndRedoGoThroughTheSteps();
  void cutMayBeChanged();
  void segmentsAreNamedAndHidden();
  void otherStepClosesTheCut();
  void freeBoxAndBladeAndEscape();
  void cleanupTestCase();

 private:
  template <typename T>
  T* find(const char* name) const {
    T* found = window_->findChild<T*>(name);
    if (found == nullptr) qFatal("no widget %s", name);
    return found;
  }
  CaseController& model() const { return window_->controller(); }
  void click(const char* button) const {
    auto* widget = find<QAbstractButton>(button);
    if (!widget->isEnabled()) qFatal("%s is disabled", button);
    widget->click();
  }
  QString result() const { return find<QLabel>("cut_result_label")->text(); }
  bool cut_is_open() const { return find<QGroupBox>("cut_group")->isVisibleTo(window_.get()); }
  void type(const char* box_name, const QString& text) const {
    auto* spin = find<QAbstractSpinBox>(box_name);
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, text);
    QTest::keyClick(spin, Qt::Key_Return);
  }
  void open_cut(const char* button) const {
    click(button);
    QTRY_VERIFY_WITH_TIMEOUT(cut_is_open(), patience);
  }
  void wait_for_edit() const { QTRY_VERIFY_WITH_TIMEOUT(!model().is_working(), patience); }
  CutEditor& editor() const { return *window_->findChild<BonePanel*>()->findChild<CutEditor*>(); }
  QPoint pixel_of(const Eigen::Vector3d& place) const {
    vtkRenderer* renderer = window_->face_view().renderer();
    renderer->SetWorldPoint(place.x(), place.y(), place.z(), 1);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    const QWidget* canvas = window_->face_view().canvas();
    return {static_cast<int>(at[0]), canvas->height() - 1 - static_cast<int>(at[1])};
  }
  void drag(QPoint from, QPoint to) const {
    QWidget* canvas = window_->face_view().canvas();
    QTest::mouseMove(canvas, from);
    QTest::mousePress(canvas, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step) {
      const QPoint at = from + (to - from) * step / 5;
      QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       {});
      QApplication::sendEvent(canvas, &move);
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, to);
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void BoneTest::initTestCase() {
  const QString demo = folder_.filePath("demo");
  Progress progress;
  write_demo_case(1, demo.toStdString(), progress);
  SurgicalCase plan = read_case_file(demo.toStdString() + "/case.json");
  plan.tissue.strain = Strain::small;
  plan.tissue.elements = Elements::linear;
  const QString file = demo + "/plain.json";
  write_case_file(plan, file.toStdString());
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  QApplication::setActiveWindow(window_.get());
  window_->open_case(file);
  QTRY_VERIFY_WITH_TIMEOUT(!model().is_working(), patience);
  QVERIFY(model().has_segments());
  find<QTabWidget>("steps")->setCurrentWidget(window_->findChild<BonePanel*>());
  QCOMPARE(find<QTableWidget>("segment_table")->rowCount(), 1);
  const double cm3 = model().loaded().anatomy->segments[0].volume_mm3 / 1000;
  QCOMPARE(find<QTableWidget>("segment_table")->item(0, 1)->text(),
           QString("%1 cm³").arg(cm3, 0, 'f', 1));
}

void BoneTest::removingTheSegmentLeavesTheBoneWhole() {
  click("remove_segment_button");
  QVERIFY(!find<QWidget>("new_cut_group")->isEnabled());  // meanwhile
  wait_for_edit();
  QVERIFY(!model().has_segments());
  QCOMPARE(find<QTableWidget>("segment_table")->rowCount(), 0);
  QVERIFY(!find<QWidget>("remove_segment_button")->isEnabled());
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Remove the segment"));
  QCOMPARE(model().loaded().anatomy->remainder.vertices.rows(),
           model().loaded().anatomy->bone.vertices.rows());
}

void BoneTest::levelFollowsTheSliderAndBecomesAStep() {
  auto* slider = find<QSlider>("level_slider");
  QCOMPARE(slider->value(), 250);
  auto* preview = window_->findChild<BonePanel*>()->findChild<LevelPreview*>();
  slider->setSliderDown(true);
  slider->setSliderPosition(400);
  QCOMPARE(find<QSpinBox>("level_box")->value(), 400);
  QElapsedTimer clock;
  clock.start();
  QTRY_VERIFY_WITH_TIMEOUT(preview->is_shown(), patience);
  qInfo("first look at another level after %lld ms", clock.elapsed());
  clock.start();
  slider->setSliderPosition(600);
  QSignalSpy shown(preview, &LevelPreview::shown);
  QTRY_COMPARE_WITH_TIMEOUT(shown.count(), 1, patience);
  qInfo("next look after %lld ms", clock.elapsed());
  QCOMPARE(shown[0][0].toDouble(), 600.0);
  QCOMPARE(model().plan().bone.hu, 250.0);  // not before it is let go
  slider->setSliderDown(false);
  QCOMPARE(model().plan().bone.hu, 600.0);
  wait_for_edit();
  QVERIFY(!preview->is_shown());
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Bone from 600 HU"));
  QVERIFY(signed_volume(model().loaded().anatomy->bone) > 1e5);
  find<QAction>("undo_action")->trigger();
  wait_for_edit();
  QCOMPARE(slider->value(), 250);
}

void BoneTest::levelThatHoldsNoBoneIsTakenBack() {
  // More than any voxel has: metal only.
  SurgicalCase plan = model().plan();
  plan.bone.minimum_component_volume = 5e6;
  model().edit("Drop everything", plan);
  wait_for_edit();
  QVERIFY(find<QWidget>("message_bar")->isVisible());
  QCOMPARE(model().plan().bone.minimum_component_volume, 1000.0);
  QVERIFY(find<QWidget>("new_cut_group")->isEnabled());
}

void BoneTest::presetShowsWhatComesOff() {
  QVERIFY(!cut_is_open());
  open_cut("chin_button");
  QCOMPARE(find<QLineEdit>("cut_name_edit")->text(), QString("chin"));
  QVERIFY2(result().contains("Comes off"), qPrintable(result()));
  QVERIFY(find<QPushButton>("cut_button")->isEnabled());
  QCOMPARE(find<QDoubleSpinBox>("cut_up_box")->value(), 0.0);
  QVERIFY(!model().has_segments());
}

void BoneTest::numbersMoveTheCut() {
  const Eigen::Vector3d before = box_of(editor().cut()).centre;
  const double volume = editor().preview().segment_mm3;
  type("cut_up_box", "2.5");
  QVERIFY((box_of(editor().cut()).centre - before - Eigen::Vector3d(0, 0, 2.5)).norm() < 1e-9);
  QVERIFY(editor().preview().segment_mm3 > volume + 500);
  type("cut_roll_box", "3");
  QCOMPARE(find<QDoubleSpinBox>("cut_roll_box")->value(), 3.0);
  QCOMPARE(find<QDoubleSpinBox>("cut_up_box")->value(), 2.5);
  type("cut_roll_box", "0");
  type("cut_up_box", "0");
  QVERIFY(std::abs(editor().preview().segment_mm3 - volume) < 1);
  const double width = find<QDoubleSpinBox>("cut_width_box")->value();
  type("cut_width_box", QString::number(width + 4));
  QCOMPARE(2 * box_of(editor().cut()).half_extents.x(), width + 4);
}

void BoneTest::refusedCutSaysWhy() {
  const double width = find<QDoubleSpinBox>("cut_width_box")->value();
  type("cut_width_box", "20");
  QVERIFY2(result().contains("does not pass through the whole bone"), qPrintable(result()));
  QVERIFY(!find<QPushButton>("cut_button")->isEnabled());
  type("cut_width_box", QString::number(width));
  QVERIFY(find<QPushButton>("cut_button")->isEnabled());
  const double length = find<QDoubleSpinBox>("cut_length_box")->value();
  type("cut_pitch_box", "12");  // level, and as far as the spine
  type("cut_length_box", "260");
  QVERIFY2(result().contains("also cuts bone that does not belong to the segment"),
           qPrintable(result()));
  QVERIFY(result().contains("behind it"));
  QVERIFY(!find<QPushButton>("cut_button")->isEnabled());
  type("cut_length_box", QString::number(length));
  type("cut_pitch_box", "0");
  find<QLineEdit>("cut_name_edit")->clear();
  QTest::keyClicks(find<QLineEdit>("cut_name_edit"), " ");
  QVERIFY2(result().contains("Give a name"), qPrintable(result()));
  QVERIFY(!find<QPushButton>("cut_button")->isEnabled());
  find<QLineEdit>("cut_name_edit")->clear();
  QTest::keyClicks(find<QLineEdit>("cut_name_edit"), "my chin");
  QVERIFY(find<QPushButton>("cut_button")->isEnabled());
}

void BoneTest::gripMovesTheCut() {
  find<QAction>("left_action")->trigger();
  QTest::qWait(500);
  const BoxCut box = box_of(editor().cut());
  // The ball stands 14 mm before the blade's front side.
  const Eigen::Vector3d front = box.axes.col(1);
  const QPoint ball =
      pixel_of(box.centre - (box.half_extents.y() + 14) * front * (front.y() > 0 ? 1 : -1));
  drag(ball, ball + QPoint(0, -8));
  const double up = find<QDoubleSpinBox>("cut_up_box")->value();
  QVERIFY2(up > 0.5 && up < 8, qPrintable(QString::number(up)));
  QVERIFY(std::abs(find<QDoubleSpinBox>("cut_left_box")->value()) < 0.2);
  type("cut_up_box", "0");
  type("cut_forward_box", "0");
  type("cut_left_box", "0");
  QVERIFY((box_of(editor().cut()).centre - box.centre).norm() < 0.2);
}

void BoneTest::otherSideOfTheBladeIsTaken() {
  const double volume = editor().preview().segment_mm3;
  click("other_side_box");
  QVERIFY(editor().preview().segment_mm3 > 3 * volume);
  click("other_side_box");
  QVERIFY(std::abs(editor().preview().segment_mm3 - volume) < 1);
}

void BoneTest::cutMakesTheSegment() {
  const double volume = editor().preview().segment_mm3;
  click("cut_button");
  wait_for_edit();
  QVERIFY(!cut_is_open());
  QVERIFY(model().has_segments());
  const BoneSegment& segment = model().loaded().anatomy->segments[0];
  QCOMPARE(QString::fromStdString(segment.name), QString("my chin"));
  QVERIFY(std::abs(segment.volume_mm3 - volume) < 0.01 * volume);
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Cut the my chin"));
  QCOMPARE(find<QTableWidget>("segment_table")->item(0, 0)->text(), QString("my chin"));
}

void BoneTest::undoAndRedoGoThroughTheSteps() {
  find<QAction>("undo_action")->trigger();
  wait_for_edit();
  QVERIFY(!model().has_segments());
  find<QAction>("undo_action")->trigger();
  wait_for_edit();
  QCOMPARE(QString::fromStdString(model().loaded().anatomy->segments.at(0).name),
           QString("segment"));
  find<QAction>("redo_action")->trigger();
  wait_for_edit();
  find<QAction>("redo_action")->trigger();
  wait_for_edit();
  QCOMPARE(QString::fromStdString(model().loaded().anatomy->segments.at(0).name),
           QString("my chin"));
}

void BoneTest::cutMayBeChanged() {
  const double before = model().loaded().anatomy->segments[0].volume_mm3;
  open_cut("change_cut_button");
  QCOMPARE(find<QLineEdit>("cut_name_edit")->text(), QString("my chin"));
  QVERIFY(std::abs(editor().preview().segment_mm3 - before) < 0.01 * before);
  type("cut_up_box", "1.5");
  click("cut_button");
  wait_for_edit();
  QCOMPARE(model().loaded().anatomy->segments.size(), std::size_t{1});
  QVERIFY(model().loaded().anatomy->segments[0].volume_mm3 > before + 300);
  QCOMPARE(QString::fromStdString(model().history().undo_name()),
           QString("Change the cut of the my chin"));
}

void BoneTest::segmentsAreNamedAndHidden() {
  open_cut("le_fort_button");
  QCOMPARE(find<QLineEdit>("cut_name_edit")->text(), QString("maxilla"));
  find<QLineEdit>("cut_name_edit")->setText("");
  QTest::keyClicks(find<QLineEdit>("cut_name_edit"), "my chin");
  QVERIFY(!find<QPushButton>("cut_button")->isEnabled());  // the name is taken
  find<QLineEdit>("cut_name_edit")->setText("");
  QTest::keyClicks(find<QLineEdit>("cut_name_edit"), "maxilla");
  click("cut_button");
  wait_for_edit();
  QCOMPARE(model().loaded().anatomy->segments.size(), std::size_t{2});
  auto* table = find<QTableWidget>("segment_table");
  QCOMPARE(table->rowCount(), 2);
  // Their colours differ.
  const QColor first = table->item(0, 0)->icon().pixmap(8).toImage().pixelColor(4, 4);
  const QColor second = table->item(1, 0)->icon().pixmap(8).toImage().pixelColor(4, 4);
  QVERIFY(first != second);
  const Picture before = window_->face_view().picture();
  table->item(1, 0)->setCheckState(Qt::Unchecked);
  QVERIFY(window_->face_view().picture().rgb != before.rgb);
  table->item(1, 0)->setCheckState(Qt::Checked);
  table->item(0, 0)->setText("maxilla");  // taken
  QCOMPARE(table->item(0, 0)->text(), QString("my chin"));
  table->item(0, 0)->setText("genioplasty");
  wait_for_edit();
  QCOMPARE(QString::fromStdString(model().plan().segments[0].name), QString("genioplasty"));
  QCOMPARE(table->item(0, 0)->text(), QString("genioplasty"));
}

void BoneTest::otherStepClosesTheCut() {
  open_cut("blade_button");
  auto* steps = find<QTabWidget>("steps");
  QWidget* bone = steps->currentWidget();
  steps->setCurrentWidget(find<QWidget>("motion_page"));
  QVERIFY(!editor().is_open());
  QVERIFY(window_->face_view().tool() == nullptr);
  steps->setCurrentWidget(bone);
  QVERIFY(!cut_is_open());
}

void BoneTest::freeBoxAndBladeAndEscape() {
  open_cut("box_button");
  QVERIFY(!find<QCheckBox>("other_side_box")->isVisibleTo(window_.get()));
  QCOMPARE(find<QLineEdit>("cut_name_edit")->text(), QString("segment"));
  QVERIFY(!result().isEmpty());
  const Picture with_box = window_->face_view().picture();
  QTest::keyClick(find<QLineEdit>("cut_name_edit"), Qt::Key_Escape);
  QVERIFY(!cut_is_open());
  QVERIFY(window_->face_view().picture().rgb != with_box.rgb);
}

void BoneTest::cleanupTestCase() {
  window_.reset();
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  gnathion::use_c_numbers();
  gnathion::test::BoneTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "bone_test.moc"
