#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <memory>
#include <numbers>

#include "app/display.h"
#include "app/driven_window.h"
#include "app/face_view.h"
#include "app/main_window.h"
#include "app/photographs_dialog.h"
#include "app/picture_pane.h"
#include "app/registration_panel.h"
#include "io/case_file.h"
#include "io/input_kind.h"
#include "scan/scan_import.h"
#include "support/photo_scene.h"
#include "user.h"

namespace gnathion::test {
namespace {

using Eigen::Vector3d;

/// 15° and 12 mm off, about the face.
Similarity disturbed(const Similarity& place) {
  const Vector3d middle(0, -90, -10);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(15 * std::numbers::pi / 180, Vector3d(0.5, 0.4, 0.77).normalized())
          .toRotationMatrix();
  const Vector3d shift = 12 * Vector3d(0.6, -0.5, 0.62).normalized();
  return {place.scale, turn * place.rotation, turn * (place.translation - middle) + middle + shift};
}

}  // namespace

/// The step "Photograph", driven as a user would: the demo case, its photograph out of place. Each
/// test goes on where the one before ended.
class RegistrationTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void placeOfThePlanIsMeasured();
  void cancelledFitChangesNothing();
  void automaticFitIsOnlyAProposal();
  void rejectedFitChangesNothing();
  void acceptedFitIsRightAndAStep();
  void undoAndRedoRestoreTheBits();
  void landmarksArePickedByClicks();
  void landmarksAreKeptAndUndone();
  void landmarkFitIsAProposal();
  void refinementJudgesTheLandmarks();
  void stableRegionIsPainted();
  void paintedRegionIsUndoneByStroke();
  void savedPicksAreReopened();
  void photographIsMovedByNumbers();
  void acceptedNudgeIsAStep();
  void exchangedLandmarksAreRefused();
  void shapeThatIsNoFaceIsRefused();
  void skinTakesThePhotographsPlace();
  void photographsCameraIsFoundFromClicks();
  void photographsAreShownBeforeTheyAreApplied();
  void appliedPhotographsAreAStep();
  void photographIsAddedAndFitted();
  void faceIsExportedInEachFormat();
  void otherStepShowsTheFaceAgain();
  void cleanupTestCase();

 private:
  User user() const { return {*window_}; }
  const RegistrationEditor& editor() const {
    return window_->findChild<RegistrationPanel*>()->editor();
  }
  const PhotographsDialog& projection() const {
    return *user().find<PhotographsDialog>("photographs_dialog");
  }
  /// As User::shoot().
  void shoot_projection(const char* name) const {
    const QString shots = qEnvironmentVariable("GNATHION_SHOTS");
    if (shots.isEmpty()) return;
    user().find<PhotographsDialog>("photographs_dialog")->grab().save(shots + "/" + name + ".png");
  }
  const StableRegionEditor& stable() const {
    return window_->findChild<RegistrationPanel*>()->stable_region();
  }
  /// Drags the mouse from where `at` is seen.
  void stroke(const Vector3d& at, QPoint way) const {
    const QPoint from = user().pixel_of(at);
    user().drag(from, from + way);
    QTest::qWait(1);
  }
  Similarity planned() const { return user().model().plan().photograph->lps_from_photograph; }
  void rest() const {
    user().settle();
    QTRY_VERIFY_WITH_TIMEOUT(!editor().is_fitting() && !editor().is_measuring(), User::patience);
    QTest::qWait(1);  // what was computed is shown
  }
  void fit(const char* button) const {
    user().click(button);
    rest();
  }
  /// mm from where `place` puts the demo's landmarks to where they are.
  double error(const Similarity& place) const {
    double worst = 0;
    for (const auto& [name, lps] : user().model().plan().landmarks) {
      const Vector3d own = true_.displacement_to_source(lps - true_.translation);
      worst = std::max(worst, (place(own) - lps).norm());
    }
    return worst;
  }
  QString cell(const char* table, int row, int column) const {
    return user().find<QTableWidget>(table)->item(row, column)->text();
  }
  /// Clicks the landmark in the row where `at` is.
  void pick(int row, const Vector3d& at) const {
    user().find<QTableWidget>("registration_landmark_table")->setCurrentCell(row, 0);
    QTest::qWait(1);
    const QPoint pixel = user().pixel_of(at);
    QTest::mouseClick(user().canvas(), Qt::LeftButton, {}, pixel);
    QTest::qWait(1);
  }
  bool message_visible() const { return user().find<QWidget>("message_bar")->isVisible(); }

  QTemporaryDir folder_;
  QString demo_;
  Similarity true_;
  std::unique_ptr<MainWindow> window_;
};

void RegistrationTest::initTestCase() {
  demo_ = folder_.filePath("demo");
  copy_demo_case(demo_.toStdString());
  SurgicalCase plan = read_case_file(demo_.toStdString() + "/case.json");
  plan.tissue.strain = Strain::small;
  plan.tissue.elements = Elements::linear;
  plan.tissue.edge_mm = 4;
  true_ = plan.photograph->lps_from_photograph;
  plan.photograph->lps_from_photograph = disturbed(true_);
  const QString file = demo_ + "/aside.json";
  write_case_file(plan, file.toStdString());
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  window_->open_case(file);
  user().settle();
  QVERIFY(user().model().has_case());
  QVERIFY(error(planned()) > 10);
  user().choose_step("RegistrationPanel");
  user().action("front_action")->trigger();
}

void RegistrationTest::placeOfThePlanIsMeasured() {
  QVERIFY(!editor().present().is_measured);
  QElapsedTimer clock;
  clock.start();
  rest();
  qInfo("skin and measure: %lld ms", clock.elapsed());
  QVERIFY(editor().present().is_measured);
  QVERIFY(editor().present().quality.rms_mm > 3);
  QCOMPARE(cell("quality_table", 0, 1), QString::number(editor().present().quality.rms_mm, 'f', 2));
  QCOMPARE(cell("quality_table", 0, 2), QString("–"));
  QVERIFY(!user().find<QPushButton>("accept_fit_button")->isEnabled());
  user().shoot("registration_aside");
}

void RegistrationTest::cancelledFitChangesNothing() {
  const Similarity before = planned();
  user().click("fit_auto_button");
  QVERIFY(editor().is_fitting());
  QTest::qWait(1);
  QVERIFY(!user().find<QPushButton>("fit_auto_button")->isEnabled());
  user().click("cancel_fit_button");
  QVERIFY(!editor().is_fitting());
  rest();
  QVERIFY(editor().proposal() == nullptr);
  QCOMPARE(planned() == before, true);
  QVERIFY(!message_visible());
  QVERIFY(user().find<QPushButton>("fit_auto_button")->isEnabled());
}

void RegistrationTest::automaticFitIsOnlyAProposal() {
  const Similarity before = planned();
  const Picture aside = window_->face_view().picture();
  QElapsedTimer clock;
  clock.start();
  fit("fit_auto_button");
  qInfo("automatic fit: %lld ms", clock.elapsed());
  QVERIFY2(editor().proposal() != nullptr, qPrintable(user().find<QLabel>("doubt_label")->text()));
  const Placement& proposal = *editor().proposal();
  qInfo("error %.3f mm, RMS %.3f mm, median %.3f mm, 95th percentile %.3f mm, %zu doubts",
        error(proposal.lps_from_photograph), proposal.quality.rms_mm, proposal.quality.median_mm,
        proposal.quality.p95_mm, proposal.doubts.size());
  QVERIFY(proposal.quality.converged);
  QVERIFY(error(proposal.lps_from_photograph) < 1);
  QCOMPARE(cell("quality_table", 0, 2), QString::number(proposal.quality.rms_mm, 'f', 2));
  QVERIFY(user().find<QLabel>("doubt_label")->isVisible());
  QVERIFY(window_->face_view().picture().rgb != aside.rgb);
  QVERIFY(planned() == before);
  QVERIFY(window_->face_view().caption().contains("not accepted yet"));
  user().shoot("registration_proposal");
}

void RegistrationTest::rejectedFitChangesNothing() {
  const Similarity before = planned();
  user().click("reject_fit_button");
  rest();
  QVERIFY(editor().proposal() == nullptr);
  QVERIFY(planned() == before);
  QVERIFY(!user().model().history().can_undo());
  QCOMPARE(cell("quality_table", 0, 2), QString("–"));
}

void RegistrationTest::acceptedFitIsRightAndAStep() {
  fit("fit_auto_button");
  QVERIFY(editor().proposal() != nullptr);
  const Similarity fitted = editor().proposal()->lps_from_photograph;
  user().click("accept_fit_button");
  rest();
  QVERIFY(planned() == fitted);
  QVERIFY(error(planned()) < 1);
  QVERIFY(editor().proposal() == nullptr);
  QCOMPARE(QString::fromStdString(user().model().history().undo_name()),
           QString("Fit the photograph"));
  const Face& face = user().model().loaded().anatomy->face;
  QVERIFY(face.lps_from_file == fitted);
  QVERIFY(user().model().has_model());
  user().shoot("registration_accepted");
}

void RegistrationTest::undoAndRedoRestoreTheBits() {
  const Similarity fitted = planned();
  user().action("undo_action")->trigger();
  rest();
  QVERIFY(planned() == disturbed(true_));
  QVERIFY(user().model().loaded().anatomy->face.lps_from_file == disturbed(true_));
  user().action("redo_action")->trigger();
  rest();
  QVERIFY(planned() == fitted);
  user().action("undo_action")->trigger();
  rest();
  QVERIFY(planned() == disturbed(true_));
}

void RegistrationTest::landmarksArePickedByClicks() {
  const auto& places = user().model().plan().landmarks;
  const std::pair<int, const char*> rows[] = {
      {1, "nose_tip"}, {6, "mouth_corner_right"}, {7, "mouth_corner_left"}, {8, "pogonion_soft"}};
  const auto computed = user().model().shared_case();
  auto* table = user().find<QTableWidget>("registration_landmark_table");
  QVERIFY(!user().find<QPushButton>("fit_landmarks_button")->isEnabled());
  user().click("pick_button");
  QVERIFY(user().find<QPushButton>("show_photograph_button")->isChecked());
  for (const auto& [row, name] : rows) {
    const Vector3d own = true_.displacement_to_source(places.at(name) - true_.translation);
    pick(row, planned()(own));
    const auto& picked = editor().landmarks()[static_cast<std::size_t>(row)].at.photograph;
    QVERIFY2(picked.has_value(), name);
    QVERIFY2((*picked - own).norm() < 2, qPrintable(QString::number((*picked - own).norm())));
    QCOMPARE(cell("registration_landmark_table", row, 1), QString("✓"));
  }
  user().shoot("registration_landmarks_photograph");
  user().click("show_ct_button");
  for (const auto& [row, name] : rows) {
    QVERIFY(!user().find<QPushButton>("fit_landmarks_button")->isEnabled() || row > 7);
    pick(row, places.at(name));
    const auto& picked = editor().landmarks()[static_cast<std::size_t>(row)].at.lps;
    QVERIFY2(picked.has_value(), name);
    QVERIFY((*picked - places.at(name)).norm() < 2);
    QVERIFY(table->currentRow() != row || row == 8);  // the next one
  }
  user().shoot("registration_landmarks_ct");
  QVERIFY(cell("registration_landmark_table", 1, 4).toDouble() > 5);
  QVERIFY(user().find<QPushButton>("fit_landmarks_button")->isEnabled());
  QVERIFY(user().model().shared_case() == computed);  // nothing follows from landmarks
}

void RegistrationTest::landmarksAreKeptAndUndone() {
  const auto& kept = user().model().plan().photograph->landmarks;
  QCOMPARE(kept.size(), std::size_t{4});
  for (const PickedLandmark& landmark : editor().landmarks()) {
    if (landmark.at.lps) QVERIFY(kept.at(landmark.name) == landmark.at);
  }
  QCOMPARE(QString::fromStdString(user().model().history().undo_name()),
           QString("Pick a landmark"));
  // The last row's places go, and come back to the bit.
  const PickedPlace chin = editor().landmarks()[8].at;
  user().find<QTableWidget>("registration_landmark_table")->setCurrentCell(8, 0);
  user().click("clear_landmark_button");
  QCOMPARE(editor().complete_landmarks(), std::size_t{3});
  user().action("undo_action")->trigger();
  QCOMPARE(editor().complete_landmarks(), std::size_t{4});
  QVERIFY(editor().landmarks()[8].at == chin);
  QCOMPARE(cell("registration_landmark_table", 8, 2), QString("✓"));
  user().action("undo_action")->trigger();  // its place on the CT was the last pick
  QVERIFY(!editor().landmarks()[8].at.lps && editor().landmarks()[8].at.photograph);
  QCOMPARE(cell("registration_landmark_table", 8, 2), QString("–"));
  QCOMPARE(editor().complete_landmarks(), std::size_t{3});
}

void RegistrationTest::landmarkFitIsAProposal() {
  fit("fit_landmarks_button");
  QVERIFY(editor().proposal() != nullptr);
  QVERIFY2(error(editor().shown().lps_from_photograph) < 5,
           qPrintable(QString::number(error(editor().shown().lps_from_photograph))));
  QVERIFY(cell("registration_landmark_table", 1, 3).toDouble() > 5);
  QVERIFY(cell("registration_landmark_table", 1, 4).toDouble() < 2);
  QVERIFY(editor().proposal()->is_measured);
  user().click("show_both_button");
  user().shoot("registration_landmark_fit");
}

void RegistrationTest::refinementJudgesTheLandmarks() {
  const QString before = cell("registration_landmark_table", 1, 4);
  fit("refine_button");
  QVERIFY(editor().proposal() != nullptr);
  const double upper = error(editor().shown().lps_from_photograph);
  QCOMPARE(cell("registration_landmark_table", 1, 3), before);
  user().find<QComboBox>("fit_region_box")->setCurrentIndex(1);
  fit("refine_button");
  const double whole = error(editor().shown().lps_from_photograph);
  qInfo("after refinement: forehead and bridge %.2f mm, whole face %.2f mm", upper, whole);
  QVERIFY2(upper < 2, qPrintable(QString::number(upper)));
  QVERIFY(whole < 1);
  QVERIFY(cell("registration_landmark_table", 1, 4).toDouble() < 2);
  user().click("reject_fit_button");
  rest();
}

void RegistrationTest::stableRegionIsPainted() {
  user().find<QComboBox>("fit_region_box")->setCurrentIndex(0);
  auto* words = user().find<QLabel>("stable_region_label");
  QVERIFY2(words->text().startsWith("Proposed"), qPrintable(words->text()));
  const Selection proposed = stable().region();
  QVERIFY(proposed == editor().proposed_region());
  QVERIFY(std::count(proposed.begin(), proposed.end(), true) > 300);
  user().click("stable_paint_button");
  QVERIFY(user().find<QPushButton>("show_photograph_button")->isChecked());
  user().find<QDoubleSpinBox>("stable_radius_box")->setValue(12);
  user().shoot("registration_stable_proposed");
  const Vector3d chin = user().model().plan().landmarks.at("pogonion_soft");
  const Vector3d own = true_.displacement_to_source(chin - true_.translation);
  stroke(planned()(own), {40, 0});
  QVERIFY2(words->text().startsWith("Painted"), qPrintable(words->text()));
  const Selection painted = stable().region();
  const auto count = [](const Selection& s) { return std::count(s.begin(), s.end(), true); };
  QVERIFY(count(painted) > count(proposed) + 20);
  QVERIFY(user().model().plan().photograph->stable_vertices == vertices_of(painted));
  QCOMPARE(QString::fromStdString(user().model().history().undo_name()),
           QString("Paint the stable region"));
  user().shoot("registration_stable_painted");
  user().click("stable_erase_button");
  stroke(planned()(own), {20, 0});
  QVERIFY(count(stable().region()) < count(painted));
  QVERIFY(count(stable().region()) > count(proposed));
  // The fit is by what is painted: too small a region is told.
  fit("refine_button");
  QVERIFY(editor().proposal() != nullptr);
  user().click("reject_fit_button");
  rest();
}

void RegistrationTest::paintedRegionIsUndoneByStroke() {
  const Selection after = stable().region();
  user().action("undo_action")->trigger();
  const Selection before = stable().region();
  QVERIFY(before != after);
  user().action("redo_action")->trigger();
  QVERIFY(stable().region() == after);
  user().click("stable_propose_button");
  QVERIFY(user().model().plan().photograph->stable_vertices.empty());
  QVERIFY(stable().region() == editor().proposed_region());
  user().action("undo_action")->trigger();
  QVERIFY(stable().region() == after);
  // Escape drops the stroke that is being painted.
  const Vector3d tip = user().model().plan().landmarks.at("nose_tip");
  const Vector3d own = true_.displacement_to_source(tip - true_.translation);
  const QPoint pixel = user().pixel_of(planned()(own));
  QTest::mousePress(user().canvas(), Qt::LeftButton, {}, pixel);
  QVERIFY(stable().is_stroke());
  QTest::keyClick(user().canvas(), Qt::Key_Escape);
  QTest::mouseRelease(user().canvas(), Qt::LeftButton, {}, pixel);
  QVERIFY(stable().region() == after);
}

void RegistrationTest::savedPicksAreReopened() {
  const PhotographSource saved = *user().model().plan().photograph;
  QVERIFY(!saved.landmarks.empty() && !saved.stable_vertices.empty());
  const QString file = demo_ + "/picked.json";
  user().model().save_case(file.toStdString());
  window_->open_case(file);
  rest();
  QVERIFY(*user().model().plan().photograph == saved);
  QCOMPARE(editor().complete_landmarks(), std::size_t{3});
  QVERIFY(vertices_of(stable().region()) == saved.stable_vertices);
  QVERIFY(!user().model().is_modified());
  user().find<QComboBox>("fit_region_box")->setCurrentIndex(1);
  user().click("show_both_button");
}

void RegistrationTest::photographIsMovedByNumbers() {
  const Similarity before = planned();
  user().type("nudge_forward_box", "5");
  rest();
  QVERIFY(editor().proposal() != nullptr);
  Similarity wanted = before;
  wanted.translation.y() -= 5;
  const Similarity& nudged = editor().proposal()->lps_from_photograph;
  QVERIFY((nudged.translation - wanted.translation).norm() < 1e-9);
  QVERIFY((nudged.rotation - wanted.rotation).norm() < 1e-12);
  user().type("nudge_yaw_box", "10");
  const Similarity turned = editor().proposal()->lps_from_photograph;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(turned.rotation * before.rotation.transpose()));
  QVERIFY(std::abs(turn.angle() * 180 / std::numbers::pi - 10) < 1e-9);
  QVERIFY(planned() == before);
  user().type("nudge_yaw_box", "0");
  user().type("nudge_forward_box", "0");
  QVERIFY(editor().proposal() == nullptr);
}

void RegistrationTest::acceptedNudgeIsAStep() {
  const Similarity before = planned();
  user().type("nudge_up_box", "2.5");
  rest();
  user().click("accept_fit_button");
  rest();
  QVERIFY(std::abs(planned().translation.z() - before.translation.z() - 2.5) < 1e-9);
  QCOMPARE(user().find<QDoubleSpinBox>("nudge_up_box")->value(), 0.0);
  user().action("undo_action")->trigger();
  rest();
  QVERIFY(planned() == before);
}

void RegistrationTest::exchangedLandmarksAreRefused() {
  const auto& places = user().model().plan().landmarks;
  const Similarity before = planned();
  user().click("show_ct_button");
  user().click("pick_button");
  pick(6, places.at("nose_tip"));  // where another one is already
  pick(7, places.at("nose_tip"));
  user().click("fit_landmarks_button");
  QVERIFY(message_visible());
  QVERIFY(editor().proposal() == nullptr);
  QVERIFY(planned() == before);
  user().find<QWidget>("message_bar")->hide();
  user().click("show_both_button");
}

void RegistrationTest::shapeThatIsNoFaceIsRefused() {
  const QString file = folder_.filePath("plate.obj");
  std::ofstream obj(file.toStdString());
  constexpr int side = 20;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) obj << "v " << 5 * i << " " << 5 * j << " 400\n";
  }
  for (int i = 1; i < side; ++i) {
    for (int j = 1; j < side; ++j) {
      const int a = (i - 1) * side + j, b = a + side;
      obj << "f " << a << " " << b << " " << b + 1 << "\nf " << a << " " << b + 1 << " " << a + 1
          << "\n";
    }
  }
  obj.close();
  SurgicalCase plan = user().model().plan();
  plan.photograph = PhotographSource{file.toStdString(), {}};
  user().model().edit("Add a plate", plan);
  rest();
  QVERIFY(user().model().plan().photograph->obj == file.toStdString());
  QCOMPARE(editor().complete_landmarks(), std::size_t{0});  // they were another photograph's
  user().find<QWidget>("message_bar")->hide();
  fit("fit_auto_button");
  const bool refused = message_visible() && editor().proposal() == nullptr;
  const bool doubted = editor().proposal() != nullptr && !editor().proposal()->doubts.empty() &&
                       user().find<QPushButton>("accept_fit_button")->text().contains("all the");
  qInfo("a plate is %s", refused ? "refused" : doubted ? "doubted" : "taken");
  QVERIFY(refused || doubted);
  QVERIFY(planned() == Similarity{});
  user().shoot("registration_plate");
  user().find<QWidget>("message_bar")->hide();
  user().action("undo_action")->trigger();
  rest();
  QVERIFY(planned() == disturbed(true_));
}

void RegistrationTest::skinTakesThePhotographsPlace() {
  user().click("use_skin_button");
  rest();
  QVERIFY(!user().model().plan().photograph);
  QVERIFY(!user().model().loaded().anatomy->face.is_photograph);
  QVERIFY(!user().find<QPushButton>("fit_auto_button")->isEnabled());
  QVERIFY(!user().find<QPushButton>("use_skin_button")->isEnabled());
  QVERIFY(user().find<QLabel>("photograph_state_label")->text().contains("No photograph"));
  QVERIFY(!window_->face_view().scene().bone_names().empty());
  user().shoot("registration_skin");
}

void RegistrationTest::photographsCameraIsFoundFromClicks() {
  const SkinSight skin(user().model().loaded().anatomy->face.mesh.surface);
  const PhotoCamera camera = camera_from(0, 2, 0, 1200, 70, 900);
  const std::string png = png_of(photograph(camera, skin, FacePaint(HeadModel(), 1)));
  QFile file(folder_.filePath("von vorn.png"));
  QVERIFY(file.open(QIODevice::WriteOnly));
  QCOMPARE(file.write(png.data(), static_cast<qint64>(png.size())),
           static_cast<qint64>(png.size()));
  file.close();
  user().look_from("front_action");
  user().click("project_photographs_button");
  QVERIFY(projection().isVisible());
  user().click("photographs_add_button");
  user().answer("photographs_file_dialog", file.fileName());
  QTRY_COMPARE(projection().editor().photos().size(), std::size_t{1});
  QVERIFY(!user().find<QPushButton>("photographs_preview_button")->isEnabled());
  auto* table = user().find<QTableWidget>("photographs_table");
  auto* pane = user().find<PicturePane>("photographs_picture");
  const auto places = picked_places();
  const char* names[] = {
      "nasion_soft",         "nose_tip",           "subnasale",          "canthus_outer_right",
      "canthus_inner_right", "canthus_inner_left", "canthus_outer_left", "mouth_corner_right",
      "mouth_corner_left",   "pogonion_soft"};
  QTRY_VERIFY(!projection().editor().is_fitting());  // the skin is ready
  for (int row = 0; row < 10; ++row) {
    QCOMPARE(table->currentRow(), row);
    const Vector3d at = places.at(names[row]);
    QTest::mouseClick(pane, Qt::LeftButton, {}, pane->place_of(camera.pixel(at)).toPoint());
    QCOMPARE(table->currentRow(), row + 1);
    QCOMPARE(cell("photographs_table", row, 2), QString("✓"));
  }
  for (int row = 0; row < 10; ++row) {
    table->setCurrentCell(row, 0);
    QTest::mouseClick(user().canvas(), Qt::LeftButton, {}, user().pixel_of(places.at(names[row])));
    QCOMPARE(cell("photographs_table", row, 1), QString("✓"));
  }
  QTRY_VERIFY(projection().editor().is_ready());
  const CameraFit& fit = *projection().editor().photos()[0].fit;
  qInfo("camera: %.2f mm RMS, sure to %.2f mm", fit.rms_mm, fit.uncertainty_mm);
  QVERIFY(fit.rms_mm < 1.5);
  QVERIFY(cell("photographs_table", 1, 4) != "–");
  QVERIFY(user().label("photographs_state_label").contains("Camera found"));
  user().shoot("photographs_picked");
  shoot_projection("photographs_dialog");
}

void RegistrationTest::photographsAreShownBeforeTheyAreApplied() {
  auto* pane = user().find<PicturePane>("photographs_picture");
  const double whole = pane->zoom();
  const std::size_t picks = projection().editor().photos()[0].pixels.size();
  user().wheel(pane, {200, 200}, 3);
  QVERIFY(pane->zoom() > 1.5 * whole);
  Stroke over_pane;
  over_pane.over = pane;
  user().drag({200, 200}, {260, 230}, over_pane);  // moves the picture, picks nothing
  QCOMPARE(projection().editor().photos()[0].pixels.size(), picks);
  QTest::keyClick(pane, Qt::Key_0);
  QCOMPARE(pane->zoom(), whole);
  user().click("photographs_preview_button");
  user().click("photographs_cancel_button");
  QTRY_VERIFY(!projection().editor().is_projecting());
  QVERIFY(projection().editor().preview() == nullptr);
  const Picture plain = window_->face_view().picture();
  user().click("photographs_preview_button");
  QTRY_VERIFY_WITH_TIMEOUT(projection().editor().preview() != nullptr, User::patience);
  QVERIFY(user().caption().contains("not applied yet"));
  QVERIFY(window_->face_view().picture().rgb != plain.rgb);
  QVERIFY(!user().model().plan().photograph);
  user().shoot("photographs_preview");
  shoot_projection("photographs_dialog_preview");
}

void RegistrationTest::appliedPhotographsAreAStep() {
  user().click("photographs_apply_button");
  user().answer("photographs_folder_dialog", folder_.filePath("gemalt"));
  QTRY_VERIFY_WITH_TIMEOUT(user().model().plan().photograph.has_value(), User::patience);
  rest();
  QVERIFY(!projection().isVisible());
  QVERIFY(user().model().loaded().anatomy->face.is_photograph);
  QCOMPARE(QFile::decodeName(user().model().plan().photograph->obj.c_str()),
           folder_.filePath("gemalt/photograph.obj"));
  QCOMPARE(QString::fromStdString(user().model().history().undo_name()),
           QString("Project photographs"));
  QVERIFY(!user().find<QPushButton>("project_photographs_button")->isEnabled());
  QVERIFY(!user().message_visible());
  user().shoot("photographs_applied");
  user().trigger("undo_action");
  rest();
  QVERIFY(!user().model().plan().photograph);
  QCOMPARE(projection().editor().photos().size(), std::size_t{1});  // to be mended
}

void RegistrationTest::photographIsAddedAndFitted() {
  user().click("add_photograph_button");
  auto* dialog = user().find<QFileDialog>("photograph_file_dialog");
  for (const char* ending : scan_endings) {
    QVERIFY2(dialog->nameFilters().first().contains("*" + QString(ending)), ending);
  }
  dialog->findChild<QLineEdit*>("fileNameEdit")->setText(demo_ + "/photograph/face.obj");
  for (QAbstractButton* button : dialog->findChild<QDialogButtonBox*>("buttonBox")->buttons()) {
    const auto* box = dialog->findChild<QDialogButtonBox*>("buttonBox");
    if (box->buttonRole(button) != QDialogButtonBox::AcceptRole) continue;
    QTest::mouseClick(button, Qt::LeftButton);
    break;
  }
  QTRY_VERIFY(window_->findChild<QDialog*>("photograph_dialog") != nullptr);
  auto* add = user().find<QPushButton>("photograph_add_button");
  auto* proposal = user().find<QLabel>("photograph_proposal_label");
  QTRY_VERIFY_WITH_TIMEOUT(proposal->text().contains("mm"), User::patience);
  QVERIFY(!add->isEnabled());
  user().find<QComboBox>("photograph_unit_box")->setCurrentIndex(1);
  QVERIFY(!add->isEnabled());
  user().find<QRadioButton>("photograph_fit_button")->click();
  QVERIFY(add->isEnabled());
  const QString folder = qEnvironmentVariable("GNATHION_SHOTS");
  if (!folder.isEmpty())
    window_->findChild<QDialog*>("photograph_dialog")
        ->grab()
        .save(folder + "/registration_dialog.png");
  add->click();
  user().settle();
  QTest::qWait(10);  // the fit begins by itself
  rest();
  QVERIFY2(!message_visible(), "the photograph was not added");
  QVERIFY(editor().proposal() != nullptr);
  user().shoot("registration_added");
  QVERIFY2(error(editor().proposal()->lps_from_photograph) < 1,
           qPrintable(QString::number(error(editor().proposal()->lps_from_photograph))));
  user().click("accept_fit_button");
  rest();
  QVERIFY(error(planned()) < 1);
}

void RegistrationTest::faceIsExportedInEachFormat() {
  QVERIFY(user().model().has_model());
  const char* names[] = {"predicted.obj", "predicted.glb", "predicted.ply"};
  for (int format = 0; format < 3; ++format) {
    user().action("export_action")->trigger();
    auto* dialog = user().find<QFileDialog>("export_dialog");
    QCOMPARE(dialog->nameFilters().size(), 3);
    dialog->selectNameFilter(dialog->nameFilters()[format]);
    const QString folder = folder_.filePath(QString("exported %1").arg(format));
    user().answer("export_dialog", folder);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder + "/report.json"), User::patience);
    Progress progress;
    const ObjDocument face = read_scan((folder + "/" + names[format]).toStdString(), progress);
    QCOMPARE(face.mesh().surface.triangles.rows(), editor().photograph().triangles.rows());
    rest();
    user().find<QWidget>("message_bar")->hide();
  }
}

void RegistrationTest::otherStepShowsTheFaceAgain() {
  const QString caption = window_->face_view().caption();
  user().choose_step("motion_page");
  QVERIFY(window_->face_view().tool() == nullptr);
  QVERIFY(window_->face_view().caption() != caption);
  QVERIFY((window_->face_view().face_points() - user().model().response().face).norm() == 0);
  user().shoot("registration_left");
  user().choose_step("RegistrationPanel");
  QTest::qWait(1);
  QVERIFY(window_->face_view().caption() == caption);
}

void RegistrationTest::cleanupTestCase() {
  window_.reset();
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  gnathion::use_c_numbers();
  gnathion::test::RegistrationTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "registration_test.moc"
