#include <QElapsedTimer>
#include <QGroupBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>

#include "app/bone_panel.h"
#include "app/driven_window.h"
#include "bone/cut_box.h"
#include "geometry/triangle_mesh.h"

namespace gnathion::test {
/// The step "Bone", driven as a user would. Each test goes on where the one before ended.
class BoneTest : public QObject, private DrivenWindow {
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
  QString result() const { return label("cut_result_label"); }
  bool cut_is_open() const { return find<QGroupBox>("cut_group")->isVisibleTo(window_.get()); }
  void open_cut(const char* button) const {
    click(button);
    QTRY_VERIFY_WITH_TIMEOUT(cut_is_open(), patience);
  }
  CutEditor& editor() const { return *window_->findChild<BonePanel*>()->findChild<CutEditor*>(); }
};

void BoneTest::initTestCase() {
  make_demo();
  // The face is of no account here: a small region.
  const QString file =
      changed_case("plain.json", [](SurgicalCase& plan) { plan.region.reach_mm = 15; });
  start_window();
  open(file);
  QVERIFY(model().has_segments());
  choose_step("BonePanel");
  QCOMPARE(find<QTableWidget>("segment_table")->rowCount(), 1);
  const double cm3 = model().loaded().anatomy->segments[0].volume_mm3 / 1000;
  QCOMPARE(find<QTableWidget>("segment_table")->item(0, 1)->text(),
           QString("%1 cm³").arg(cm3, 0, 'f', 1));
}

void BoneTest::removingTheSegmentLeavesTheBoneWhole() {
  click("remove_segment_button");
  QVERIFY(!find<QWidget>("new_cut_group")->isEnabled());  // meanwhile
  settle();
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
  settle();
  QVERIFY(!preview->is_shown());
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Bone from 600 HU"));
  QVERIFY(signed_volume(model().loaded().anatomy->bone) > 1e5);
  trigger("undo_action");
  settle();
  QCOMPARE(slider->value(), 250);
}

void BoneTest::levelThatHoldsNoBoneIsTakenBack() {
  // More than any voxel has: metal only.
  SurgicalCase plan = model().plan();
  plan.bone.minimum_component_volume = 5e6;
  model().edit("Drop everything", plan);
  settle();
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
  QCOMPARE(box("cut_up_box")->value(), 0.0);
  QVERIFY(!model().has_segments());
}

void BoneTest::numbersMoveTheCut() {
  const Eigen::Vector3d before = box_of(editor().cut()).centre;
  const double volume = editor().preview().segment_mm3;
  type("cut_up_box", "2.5");
  QVERIFY((box_of(editor().cut()).centre - before - Eigen::Vector3d(0, 0, 2.5)).norm() < 1e-9);
  QVERIFY(editor().preview().segment_mm3 > volume + 500);
  type("cut_roll_box", "3");
  QCOMPARE(box("cut_roll_box")->value(), 3.0);
  QCOMPARE(box("cut_up_box")->value(), 2.5);
  type("cut_roll_box", "0");
  type("cut_up_box", "0");
  QVERIFY(std::abs(editor().preview().segment_mm3 - volume) < 1);
  const double width = box("cut_width_box")->value();
  type("cut_width_box", QString::number(width + 4));
  QCOMPARE(2 * box_of(editor().cut()).half_extents.x(), width + 4);
}

void BoneTest::refusedCutSaysWhy() {
  const double width = box("cut_width_box")->value();
  type("cut_width_box", "20");
  QVERIFY2(result().contains("does not pass through the whole bone"), qPrintable(result()));
  QVERIFY(!find<QPushButton>("cut_button")->isEnabled());
  type("cut_width_box", QString::number(width));
  QVERIFY(find<QPushButton>("cut_button")->isEnabled());
  const double length = box("cut_length_box")->value();
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
  look_from("left_action");
  const BoxCut blade = box_of(editor().cut());
  // The ball stands 14 mm before the blade's front side.
  const Eigen::Vector3d front = blade.axes.col(1);
  const QPoint ball =
      pixel_of(blade.centre - (blade.half_extents.y() + 14) * front * (front.y() > 0 ? 1 : -1));
  drag(ball, ball + QPoint(0, -8));
  const double up = box("cut_up_box")->value();
  QVERIFY2(up > 0.5 && up < 8, qPrintable(QString::number(up)));
  QVERIFY(std::abs(box("cut_left_box")->value()) < 0.2);
  type("cut_up_box", "0");
  type("cut_forward_box", "0");
  type("cut_left_box", "0");
  QVERIFY((box_of(editor().cut()).centre - blade.centre).norm() < 0.2);
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
  settle();
  QVERIFY(!cut_is_open());
  QVERIFY(model().has_segments());
  const BoneSegment& segment = model().loaded().anatomy->segments[0];
  QCOMPARE(QString::fromStdString(segment.name), QString("my chin"));
  QVERIFY(std::abs(segment.volume_mm3 - volume) < 0.01 * volume);
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Cut the my chin"));
  QCOMPARE(find<QTableWidget>("segment_table")->item(0, 0)->text(), QString("my chin"));
}

void BoneTest::undoAndRedoGoThroughTheSteps() {
  trigger("undo_action");
  settle();
  QVERIFY(!model().has_segments());
  trigger("undo_action");
  settle();
  QCOMPARE(QString::fromStdString(model().loaded().anatomy->segments.at(0).name),
           QString("segment"));
  trigger("redo_action");
  settle();
  trigger("redo_action");
  settle();
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
  settle();
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
  settle();
  QCOMPARE(model().loaded().anatomy->segments.size(), std::size_t{2});
  auto* table = find<QTableWidget>("segment_table");
  QCOMPARE(table->rowCount(), 2);
  // Their colours differ.
  const QColor first = table->item(0, 0)->icon().pixmap(8).toImage().pixelColor(4, 4);
  const QColor second = table->item(1, 0)->icon().pixmap(8).toImage().pixelColor(4, 4);
  QVERIFY(first != second);
  const Picture before = view().picture();
  table->item(1, 0)->setCheckState(Qt::Unchecked);
  QVERIFY(view().picture().rgb != before.rgb);
  table->item(1, 0)->setCheckState(Qt::Checked);
  table->item(0, 0)->setText("maxilla");  // taken
  QCOMPARE(table->item(0, 0)->text(), QString("my chin"));
  table->item(0, 0)->setText("genioplasty");
  settle();
  QCOMPARE(QString::fromStdString(model().plan().segments[0].name), QString("genioplasty"));
  QCOMPARE(table->item(0, 0)->text(), QString("genioplasty"));
}

void BoneTest::otherStepClosesTheCut() {
  open_cut("blade_button");
  auto* steps = find<QTabWidget>("steps");
  QWidget* bone = steps->currentWidget();
  steps->setCurrentWidget(find<QWidget>("motion_page"));
  QVERIFY(!editor().is_open());
  QVERIFY(view().tool() == nullptr);
  steps->setCurrentWidget(bone);
  QVERIFY(!cut_is_open());
}

void BoneTest::freeBoxAndBladeAndEscape() {
  open_cut("box_button");
  QVERIFY(!find<QCheckBox>("other_side_box")->isVisibleTo(window_.get()));
  QCOMPARE(find<QLineEdit>("cut_name_edit")->text(), QString("segment"));
  QVERIFY(!result().isEmpty());
  const Picture with_box = view().picture();
  QTest::keyClick(find<QLineEdit>("cut_name_edit"), Qt::Key_Escape);
  QVERIFY(!cut_is_open());
  QVERIFY(view().picture().rgb != with_box.rgb);
}

void BoneTest::cleanupTestCase() {
  window_.reset();
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  return gnathion::test::run<gnathion::test::BoneTest>(argc, argv);
}

#include "bone_test.moc"
