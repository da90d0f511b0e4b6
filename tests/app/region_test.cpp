#include <QComboBox>
#include <QElapsedTimer>
#include <QPushButton>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "app/driven_window.h"
#include "app/region_panel.h"
#include "geometry/triangle_mesh.h"

namespace gnathion::test {
/// The region of the demo case, painted with the mouse.
class RegionTest : public QObject, private DrivenWindow {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanupTestCase();

  void suggestionIsShown();
  void strokePaintsAndUndoRestores();
  void strokesFollowEachOtherWhileTheModelIsMade();
  void fastStrokeHasNoGaps();
  void eraseAndShiftTakeAway();
  void pressBesideTheFaceTurnsTheView();
  void radiusByBoxWheelAndKeys();
  void escapeDropsTheStroke();
  void growShrinkAndSmoothAreSteps();
  void mirrorMakesBothSidesAlike();
  void clearLeavesNothingAndSuggestBringsBack();
  void twoPiecesKeepTheCaseAndSayWhy();
  void slidingTissueIsPainted();
  void readoutsAreTheModels();
  void lipLineIsTracedWithClicksAsOneStep();
  void lipLineIsProposedAndRemoved();
  void leavingTheStepDropsTheLipLine();
  void leavingTheStepTakesTheBrushAway();
  void strokeStaysWithinAFrame();

 private:
  const RegionEditor& editor() const { return region_panel()->editor(); }
  RegionPanel* region_panel() const {
    auto* panel = window_->findChild<RegionPanel*>();
    if (panel == nullptr) qFatal("no region panel");
    return panel;
  }
  QPoint landmark(const char* name) const { return pixel_of(model().plan().landmarks.at(name)); }
  const std::vector<int>& vertices() const { return model().plan().region.vertices; }
  int vertex_at(const char* name) const {
    const Points& points = model().loaded().anatomy->face.mesh.surface.vertices;
    const Eigen::RowVector3d place = model().plan().landmarks.at(name).transpose();
    Eigen::Index nearest = 0;
    (points.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
  }
  bool has(const char* landmark_name) const {
    return editor().region()[static_cast<std::size_t>(vertex_at(landmark_name))];
  }
  QString words() const { return label("state_label"); }

  SurgicalCase plain_;
};

void RegionTest::initTestCase() {
  make_demo();
  const QString file =
      changed_case("plain.json", [](SurgicalCase& plan) { plan.segments[0].motion = {}; });
  start_window();
  open(file);
  QVERIFY(model().has_model());
  plain_ = model().plan();
}

/// Every test begins with the case as it is in the file, the brush in the hand.
void RegionTest::init() {
  activate();
  choose_step("motion_page");
  if (model().plan() != plain_) model().edit("As in the file", plain_);
  settle();
  QVERIFY(model().has_model());
  choose_step("RegionPanel");
  look_from("front_action");
  click("paint_button");
  type("radius_box", "8");
}

void RegionTest::cleanupTestCase() {
  window_.reset();
}

void RegionTest::suggestionIsShown() {
  QVERIFY(vertices().empty());
  QCOMPARE(vertices_of(editor().region()), [&] {
    std::vector<int> suggested = model().loaded().model->problem().face_vertices;
    std::sort(suggested.begin(), suggested.end());
    return suggested;
  }());
  QVERIFY(has("pogonion_soft"));
  QVERIFY(!has("nose_tip"));
  QVERIFY(words().contains("the face follows"));
  shoot("suggested");
}

void RegionTest::strokePaintsAndUndoRestores() {
  const Selection before = editor().region();
  const SurgicalCase plan = model().plan();
  QVERIFY(!has("nose_tip"));
  drag(landmark("upper_lip"), landmark("nose_tip"));
  QVERIFY(has("nose_tip"));
  QVERIFY(!vertices().empty());
  QCOMPARE(vertices(), vertices_of(editor().region()));
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Paint the region"));
  for (std::size_t v = 0; v < before.size(); ++v) QVERIFY(!before[v] || editor().region()[v]);
  settle();
  QVERIFY(model().has_model());
  std::vector<int> meshed = model().loaded().model->problem().face_vertices;
  QVERIFY(std::binary_search(meshed.begin(), meshed.end(), vertex_at("nose_tip")));
  shoot("painted");
  trigger("undo_action");
  settle();
  QVERIFY(model().plan() == plan);
  QVERIFY(editor().region() == before);
  trigger("redo_action");
  settle();
  QVERIFY(has("nose_tip"));
}

void RegionTest::strokesFollowEachOtherWhileTheModelIsMade() {
  drag(landmark("upper_lip"), landmark("nose_tip"));
  QVERIFY(model().is_editing());
  const std::vector<int> first = vertices();
  drag(landmark("nose_tip"), landmark("nose_tip") - QPoint(60, 0));
  QVERIFY(vertices().size() > first.size());
  QVERIFY(std::includes(vertices().begin(), vertices().end(), first.begin(), first.end()));
  settle();
  QCOMPARE(model().loaded().plan.region.vertices, vertices());
  // Also a stroke in the middle of which the model of the last one arrives.
  trigger("undo_action");
  QTest::mousePress(canvas(), Qt::LeftButton, {}, landmark("nose_tip"));
  settle();
  QVERIFY(editor().is_stroke());
  move(landmark("nose_tip") + QPoint(30, 0));
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, landmark("nose_tip") + QPoint(30, 0));
  QVERIFY(!editor().is_stroke());
  QVERIFY(has("nose_tip"));
  settle();
  QCOMPARE(vertices(), vertices_of(editor().region()));
}

void RegionTest::fastStrokeHasNoGaps() {
  type("radius_box", "4");
  const QPoint from = landmark("mouth_corner_left"), to = from - QPoint(0, 130);
  drag(from, to, {.steps = 1});  // one move of the mouse, 130 pixels
  settle();
  QVERIFY2(editor().faults().empty(), qPrintable(words()));
  QVERIFY(model().has_model());
}

void RegionTest::eraseAndShiftTakeAway() {
  click("erase_button");
  QVERIFY(has("pogonion_soft"));
  drag(landmark("pogonion_soft"), landmark("pogonion_soft") + QPoint(5, 0), {.steps = 2});
  QVERIFY(!has("pogonion_soft"));
  drag(landmark("pogonion_soft"), landmark("pogonion_soft") + QPoint(5, 0),
       {.keys = Qt::ShiftModifier, .steps = 2});
  QVERIFY(has("pogonion_soft"));
  click("paint_button");
  drag(landmark("pogonion_soft"), landmark("pogonion_soft") + QPoint(5, 0),
       {.keys = Qt::ShiftModifier, .steps = 2});
  QVERIFY(!has("pogonion_soft"));
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Erase from the region"));
  settle();
}

void RegionTest::pressBesideTheFaceTurnsTheView() {
  const Selection before = editor().region();
  const Eigen::Vector3d eye = view().view_point({5, 5}).eye;
  drag({10, canvas()->height() / 2}, {90, canvas()->height() / 2});
  QVERIFY(!view().view_point({5, 5}).eye.isApprox(eye, 1e-3));
  QVERIFY(editor().region() == before);
  QVERIFY(vertices().empty());
  click("turn_button");
  QVERIFY(view().tool() == nullptr);
}

void RegionTest::radiusByBoxWheelAndKeys() {
  const QDoubleSpinBox* radius = box("radius_box");
  QCOMPARE(radius->value(), 8.0);
  wheel(canvas(), landmark("pogonion_soft"), 1, Qt::ControlModifier);
  QVERIFY(std::abs(radius->value() - 8.8) < 0.06);
  canvas()->setFocus();
  QTest::keyClick(canvas(), Qt::Key_BracketRight);
  QCOMPARE(radius->value(), 10.0);
  QTest::keyClick(canvas(), Qt::Key_BracketLeft);
  QTest::keyClick(canvas(), Qt::Key_BracketLeft);
  QCOMPARE(radius->value(), 8.0);
  QCOMPARE(find<QSlider>("radius_slider")->value(), 8);
  type("radius_box", "99");
  QVERIFY(radius->value() <= 40);
  // A larger brush paints more.
  find<QSlider>("radius_slider")->setValue(3);
  drag(landmark("nose_tip"), landmark("nose_tip"), {.steps = 1});
  const std::size_t little = vertices().size();
  trigger("undo_action");
  find<QSlider>("radius_slider")->setValue(15);
  drag(landmark("nose_tip"), landmark("nose_tip"), {.steps = 1});
  QVERIFY(vertices().size() > little + 50);
}

void RegionTest::escapeDropsTheStroke() {
  const Selection before = editor().region();
  QTest::mousePress(canvas(), Qt::LeftButton, {}, landmark("nose_tip"));
  QVERIFY(has("nose_tip"));
  QTest::keyClick(canvas(), Qt::Key_Escape);
  QVERIFY(!has("nose_tip"));
  move(landmark("nose_tip") + QPoint(10, 0));
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, landmark("nose_tip"));
  QVERIFY(editor().region() == before);
  QVERIFY(vertices().empty());
}

void RegionTest::growShrinkAndSmoothAreSteps() {
  const double area = editor().outline().area_mm2;
  type("amount_box", "5");
  click("grow_button");
  const double larger = editor().outline().area_mm2;
  QVERIFY(larger > 1.04 * area);
  settle();
  click("shrink_button");
  QVERIFY(std::abs(editor().outline().area_mm2 / area - 1) < 0.08);
  settle();
  click("smooth_button");
  settle();
  QVERIFY(model().has_model());
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Smooth the region"));
  for (int i = 0; i < 3; ++i) trigger("undo_action");
  settle();
  QVERIFY(vertices().empty());
  QCOMPARE(editor().outline().area_mm2, area);
}

void RegionTest::mirrorMakesBothSidesAlike() {
  click("erase_button");
  type("radius_box", "15");
  drag(landmark("mouth_corner_left"), landmark("mouth_corner_left") + QPoint(0, 60));
  QVERIFY(!has("mouth_corner_left"));
  QVERIFY(has("mouth_corner_right"));
  settle();
  click("mirror_button");
  QTRY_VERIFY_WITH_TIMEOUT(has("mouth_corner_left"), patience);
  QVERIFY(has("mouth_corner_right"));
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Mirror the region"));
  settle();
  QVERIFY(find<QWidget>("message_bar")->isVisible());
}

void RegionTest::clearLeavesNothingAndSuggestBringsBack() {
  click("region_clear_button");
  QVERIFY(model().plan().region.erased);
  QVERIFY(vertices().empty());
  QCOMPARE(editor().outline().triangles.rows(), 0L);
  settle();
  QVERIFY(!model().has_model());
  QVERIFY(words().contains("Nothing is painted"));
  QVERIFY(!find<QWidget>("grow_button")->isEnabled());
  type("reach_box", "25");
  click("suggest_button");
  QVERIFY(words().contains("being computed"));
  settle();
  QVERIFY(model().has_model());
  QCOMPARE(model().plan().region.reach_mm, 25.0);
  QVERIFY(has("pogonion_soft"));
  trigger("undo_action");
  settle();
  QVERIFY(model().plan().region.erased);
  QCOMPARE(editor().outline().triangles.rows(), 0L);
}

void RegionTest::twoPiecesKeepTheCaseAndSayWhy() {
  type("radius_box", "5");
  drag(landmark("nose_tip"), landmark("nose_tip"), {.steps = 1});
  settle();
  QVERIFY(model().has_case());
  QVERIFY(!model().has_model());
  QCOMPARE(editor().faults().size(), std::size_t{1});
  QVERIFY(words().contains("2 pieces"));
  QVERIFY(words().contains("cannot follow"));
  shoot("two_pieces");
  click("tidy_button");
  settle();
  QVERIFY(model().has_model());
  QVERIFY(!has("nose_tip"));
}

void RegionTest::slidingTissueIsPainted() {
  find<QComboBox>("target_box")->setCurrentIndex(1);
  const int sliding = model().loaded().model->problem().sliding_count;
  drag(landmark("pogonion_soft") - QPoint(20, 0), landmark("pogonion_soft") + QPoint(20, 0));
  find<QComboBox>("target_box")->setCurrentIndex(0);
  QVERIFY(!model().plan().tissue.sliding_vertices.empty());
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Paint sliding tissue"));
  settle();
  QVERIFY(model().loaded().model->problem().sliding_count > sliding + 5);
  shoot("sliding");
  trigger("undo_action");
  settle();
  QVERIFY(model().plan().tissue.sliding_vertices.empty());
  QCOMPARE(model().loaded().model->problem().sliding_count, sliding);
}

void RegionTest::readoutsAreTheModels() {
  const TissueProblem& problem = model().loaded().model->problem();
  QCOMPARE(label("attached_value"), QLocale().toString(problem.attached_count));
  QCOMPARE(label("sliding_value"), QLocale().toString(problem.sliding_count));
  QCOMPARE(label("rim_value"),
           QString("%1 mm").arg(QLocale().toString(problem.rim_to_segment, 'f', 0)));
  const double area =
      surface_area({editor().brush().face().vertices, editor().outline().triangles});
  QCOMPARE(label("area_value"),
           QString("%1 cm², %2 triangles")
               .arg(QLocale().toString(area / 100, 'f', 1),
                    QLocale().toString(static_cast<int>(editor().outline().triangles.rows()))));
}

void RegionTest::lipLineIsTracedWithClicksAsOneStep() {
  QVERIFY(model().loaded().model->problem().slit.empty());
  QVERIFY(!find<QPushButton>("remove_lips_button")->isEnabled());
  click("trace_lips_button");
  QVERIFY(region_panel()->lips().is_tracing());
  const auto& places = model().plan().landmarks;
  const Eigen::Vector3d right = places.at("mouth_corner_right"), stomion = places.at("stomion"),
                        left = places.at("mouth_corner_left");
  for (const Eigen::Vector3d& place :
       {right, Eigen::Vector3d((right + stomion) / 2 + Eigen::Vector3d(0, -4, 0)), stomion,
        Eigen::Vector3d((left + stomion) / 2 + Eigen::Vector3d(0, -4, 0)), left}) {
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, pixel_of(place));
  }
  QCOMPARE(region_panel()->lips().traced_count(), 5);
  QVERIFY(!find<QPushButton>("paint_button")->isChecked());
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, pixel_of(places.at("nose_tip")));
  QTest::keyClick(canvas(), Qt::Key_Backspace);
  QCOMPARE(region_panel()->lips().traced_count(), 5);
  QVERIFY(model().plan().region.lip_line.empty());
  shoot("lips-traced");
  QTest::keyClick(canvas(), Qt::Key_Return);
  QVERIFY(!region_panel()->lips().is_tracing());
  QVERIFY(!find<QPushButton>("trace_lips_button")->isChecked());
  QVERIFY(find<QPushButton>("paint_button")->isChecked());
  const auto line = model().plan().region.lip_line;
  QCOMPARE(int(line.size()), 5);
  QVERIFY((line[0] - right).norm() < 2);
  QVERIFY((line[2] - stomion).norm() < 2);
  QVERIFY((line[4] - left).norm() < 2);
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Trace the lip line"));
  settle();
  QVERIFY(model().has_model());
  QVERIFY(model().loaded().model->problem().slit.size() > 8);
  shoot("lips-cut");
  trigger("undo_action");
  settle();
  QVERIFY(model().plan().region.lip_line.empty());
  QVERIFY(model().loaded().model->problem().slit.empty());
}

void RegionTest::lipLineIsProposedAndRemoved() {
  QElapsedTimer clock;
  clock.start();
  click("propose_lips_button");
  QVERIFY(clock.elapsed() < 500);
  const auto line = model().plan().region.lip_line;
  QVERIFY(line.size() > 8);
  QVERIFY((line.front() - model().plan().landmarks.at("mouth_corner_right")).norm() < 2);
  settle();
  QVERIFY(model().loaded().model->problem().slit.size() > 8);
  QVERIFY(label("lips_label").contains("Cut open"));
  shoot("lips-proposed");
  QVERIFY(find<QPushButton>("remove_lips_button")->isEnabled());
  click("remove_lips_button");
  QCOMPARE(QString::fromStdString(model().history().undo_name()), QString("Remove the lip line"));
  settle();
  QVERIFY(model().plan().region.lip_line.empty());
  QVERIFY(model().loaded().model->problem().slit.empty());
}

void RegionTest::leavingTheStepDropsTheLipLine() {
  click("trace_lips_button");
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, landmark("stomion"));
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, landmark("mouth_corner_left"));
  QCOMPARE(region_panel()->lips().traced_count(), 2);
  choose_step("motion_page");
  QVERIFY(!region_panel()->lips().is_tracing());
  QVERIFY(model().plan().region.lip_line.empty());
}

void RegionTest::leavingTheStepTakesTheBrushAway() {
  QVERIFY(view().tool() != nullptr);
  const QImage shown = canvas()->grabFramebuffer();
  choose_step("motion_page");
  QVERIFY(view().tool() == nullptr);
  const Selection before = editor().region();
  drag(landmark("nose_tip"), landmark("nose_tip") + QPoint(0, 20));
  QVERIFY(editor().region() == before);
  QVERIFY(vertices().empty());
  choose_step("RegionPanel");
  QVERIFY(view().tool() != nullptr);
}

/// What a stroke costs a frame is printed; it must not block the window.
void RegionTest::strokeStaysWithinAFrame() {
  const QPoint from = landmark("nose_tip");
  QTest::mousePress(canvas(), Qt::LeftButton, {}, from);
  double paint = 0, draw = 0;
  constexpr int kMoves = 30;
  for (int i = 1; i <= kMoves; ++i) {
    QElapsedTimer timer;
    timer.start();
    move(from + QPoint(2 * i, -i));
    paint += static_cast<double>(timer.nsecsElapsed()) / 1e6;
    timer.restart();
    view().interactor()->Render();
    canvas()->grabFramebuffer();
    draw += static_cast<double>(timer.nsecsElapsed()) / 1e6;
  }
  QTest::mouseRelease(canvas(), Qt::LeftButton, {}, from + QPoint(60, -30));
  qInfo("stroke on %d triangles: %.1f ms to paint, %.1f ms to draw a frame",
        static_cast<int>(editor().brush().face().triangles.rows()), paint / kMoves, draw / kMoves);
  QVERIFY(paint / kMoves < 100);
  settle();
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  return gnathion::test::run<gnathion::test::RegionTest>(argc, argv);
}

#include "region_test.moc"
