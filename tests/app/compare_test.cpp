#include <QComboBox>
#include <QDir>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "app/compare_panel.h"
#include "app/driven_window.h"
#include "app/exports.h"
#include "app/histogram_view.h"
#include "app/place_words.h"
#include "geometry/bsp_tree.h"
#include "geometry/triangle_mesh.h"
#include "io/files.h"
#include "io/obj_document.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

/// A part of a picture between fractions of its width, without the words above and below.
Picture columns(const Picture& picture, double from, double to) {
  const int left = static_cast<int>(from * picture.width);
  const int wide = static_cast<int>((to - from) * picture.width);
  const int top = picture.height / 5, bottom = 17 * picture.height / 20;
  Picture part{wide, bottom - top, {}};
  for (int y = top; y < bottom; ++y) {
    const std::uint8_t* row = picture.at(left, y);
    part.rgb.insert(part.rgb.end(), row, row + static_cast<std::ptrdiff_t>(3 * wide));
  }
  return part;
}

/// A binary STL as triangles with vertices of their own.
TriangleMesh read_stl(const fs::path& path, std::string& header) {
  const std::string bytes = read_text_file(path);
  header = bytes.substr(0, 80);
  std::uint32_t count = 0;
  std::memcpy(&count, &bytes[80], 4);
  TriangleMesh mesh;
  mesh.triangles.resize(count, 3);
  mesh.vertices.resize(3 * static_cast<Eigen::Index>(count), 3);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), &bytes[static_cast<std::size_t>(84 + 50 * f)], 48);
    for (int c = 0; c < 3; ++c) {
      mesh.triangles(f, c) = static_cast<int>(3 * f + c);
      for (int k = 0; k < 3; ++k) {
        mesh.vertices(3 * f + c, k) =
            static_cast<double>(numbers[static_cast<std::size_t>(3 + 3 * c + k)]);
      }
    }
  }
  return mesh;
}

}  // namespace

class CompareTest : public QObject, private DrivenWindow {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanupTestCase();

  void stepBringsTheFaceBeforeAndTakesItAway();
  void sideBySideShowsBothThroughOneCamera();
  void dividerIsDraggedInTheView();
  void blendGoesFromOneFaceToTheOther();
  void profileShowsBothOutlines();
  void colourMapHasAFixedOrAutomaticRange();
  void numbersAreThoseOfTheAnswer();
  void quickAnswerSaysSo();
  void pointUnderTheMouseIsReadOnBothSides();
  void distanceIsMeasuredByTwoClicks();
  void placesAreSaidInWords();
  void bonesAreExportedInTheirPlannedPlaces();
  void exportsNeverOverwrite();
  void faceIsExportedExactly();
  void turntableIsAFilmOrPictures();
  void turntableCanBeCancelled();
  void largerPictureShowsTheSame();
  void windowMayCloseWhileComparing();

 private:
  ComparePanel& panel() const { return *window_->findChild<ComparePanel*>(); }
  void choose_mode(const QString& words) const {
    auto* box = find<QComboBox>("mode_box");
    box->setCurrentIndex(box->findText(words));
    QTest::qWait(50);
  }
  void advance(double forward_mm) const {
    JawMotion motion;
    motion.forward_mm = forward_mm;
    model().set_motion(motion);
  }
  void wait_for_refined() const {
    await_answer();
    QTRY_VERIFY_WITH_TIMEOUT(panel().compare_view().can_point(), patience);
  }
  QPoint at(double x, double y) const {
    return {static_cast<int>(x * canvas()->width()), static_cast<int>(y * canvas()->height())};
  }
};

void CompareTest::initTestCase() {
  make_demo();
  start_window();
  open(changed_case("plain.json", [](SurgicalCase&) {}));
  QVERIFY(model().has_case());
  action("slices_action")->setChecked(false);
}

void CompareTest::init() {
  activate();
  advance(6);
  choose_step("Compare");
  find<QCheckBox>("colour_check")->setChecked(false);
  box("range_box")->setValue(0);
  find<QPushButton>("distance_button")->setChecked(false);
  choose_mode("Side by side");
  view().look_from(CameraPreset::three_quarter);
  wait_for_refined();
}

void CompareTest::cleanupTestCase() {
  window_.reset();
}

void CompareTest::stepBringsTheFaceBeforeAndTakesItAway() {
  shoot("compare_side_by_side");
  const Picture both = view().picture();
  choose_step("Move");
  QVERIFY(view().tool() == nullptr);
  view().look_from(CameraPreset::three_quarter);
  const Picture alone = view().picture();
  QVERIFY(differing_pixels(both, alone) > both.width * both.height / 20);
  choose_step("Compare");
  QVERIFY(view().tool() != nullptr);
  QVERIFY(differing_pixels(alone, view().picture()) > both.width * both.height / 20);
}

void CompareTest::sideBySideShowsBothThroughOneCamera() {
  action("bone_action")->setChecked(false);
  view().look_from(CameraPreset::left);
  const Picture moved = view().picture();
  const Picture left = columns(moved, 0.0, 0.5), right = columns(moved, 0.5, 1.0);
  shoot("compare_side_by_side_left");
  // Words aside, without motion both halves are the same picture.
  advance(0);
  wait_for_refined();
  const Picture rest = view().picture();
  const int apart = differing_pixels(left, right);
  const int at_rest = differing_pixels(columns(rest, 0.0, 0.5), columns(rest, 0.5, 1.0));
  QVERIFY2(apart > 2 * at_rest + 500, qPrintable(QString("%1 %2").arg(apart).arg(at_rest)));
  // The mouse over the face before turns both.
  const double before = view().renderer()->GetActiveCamera()->GetPosition()[0];
  drag(at(0.25, 0.5), at(0.32, 0.5));
  QVERIFY(std::abs(view().renderer()->GetActiveCamera()->GetPosition()[0] - before) > 1);
  const Picture turned = view().picture();
  QVERIFY(differing_pixels(columns(turned, 0.0, 0.5), columns(rest, 0.0, 0.5)) > 500);
  QVERIFY(differing_pixels(columns(turned, 0.0, 0.5), columns(turned, 0.5, 1.0)) <
          2 * at_rest + 500);
  action("bone_action")->setChecked(true);
}

void CompareTest::dividerIsDraggedInTheView() {
  choose_mode("Predicted face alone");
  const Picture predicted = view().picture();
  choose_mode("Wipe");
  auto* slider = find<QSlider>("wipe_slider");
  slider->setValue(50);
  shoot("compare_wipe");
  const Eigen::Vector3d eye(view().renderer()->GetActiveCamera()->GetPosition());
  drag(at(0.5, 0.6), at(0.25, 0.6));
  QVERIFY(std::abs(panel().compare_view().scene().wipe() - 0.25) < 0.01);
  QCOMPARE(slider->value(), 25);
  QCOMPARE(Eigen::Vector3d(view().renderer()->GetActiveCamera()->GetPosition()), eye);
  // Right of the divider the picture is the predicted face's own, place by place.
  const Picture wiped = view().picture();
  const int same = differing_pixels(columns(wiped, 0.5, 0.85), columns(predicted, 0.5, 0.85));
  QVERIFY2(same < wiped.width * wiped.height / 200, qPrintable(QString::number(same)));
  // Left of it, that of the face before.
  slider->setValue(97);
  const Picture rest = view().picture();
  slider->setValue(50);
  const Picture half = view().picture();
  const int left = differing_pixels(columns(half, 0.12, 0.48), columns(rest, 0.12, 0.48));
  QVERIFY2(left < wiped.width * wiped.height / 200, qPrintable(QString::number(left)));
  QVERIFY(differing_pixels(columns(rest, 0.2, 0.8), columns(predicted, 0.2, 0.8)) > 500);
  // Beside the divider the mouse turns the camera.
  drag(at(0.7, 0.3), at(0.75, 0.3));
  QVERIFY((Eigen::Vector3d(view().renderer()->GetActiveCamera()->GetPosition()) - eye).norm() > 1);
}

void CompareTest::blendGoesFromOneFaceToTheOther() {
  choose_mode("Predicted face alone");
  const Picture predicted = columns(view().picture(), 0.2, 0.8);
  choose_mode("Wipe");
  find<QSlider>("wipe_slider")->setValue(97);
  const Picture before = columns(view().picture(), 0.2, 0.8);
  choose_mode("Blend");
  auto* slider = find<QSlider>("blend_slider");
  slider->setValue(50);
  shoot("compare_blend");
  slider->setValue(0);
  const Picture none = columns(view().picture(), 0.2, 0.8);
  slider->setValue(100);
  const Picture all = columns(view().picture(), 0.2, 0.8);
  const int whole = before.width * before.height;
  QVERIFY(differing_pixels(none, predicted) < whole / 50);
  QVERIFY2(differing_pixels(all, before) < differing_pixels(all, predicted),
           qPrintable(QString("%1 %2")
                          .arg(differing_pixels(all, before))
                          .arg(differing_pixels(all, predicted))));
}

void CompareTest::profileShowsBothOutlines() {
  const Picture faces = view().picture();
  choose_mode("Profile outlines");
  shoot("compare_profile");
  const Profile& profile = panel().compare_view().profile();
  QVERIFY(!profile.before.empty());
  QVERIFY(!profile.after.empty());
  QVERIFY(profile.landmarks.size() >= 5);
  const double x = panel().compare_view().middle_x();
  double foremost_before = 1e9, foremost_after = 1e9;
  const double chin = model().plan().landmarks.at("pogonion_soft").z();
  const auto foremost = [&](const std::vector<Points>& chains) {
    double y = 1e9;
    for (const Points& chain : chains) {
      for (const auto point : chain.rowwise()) {
        if (std::abs(point.x() - x) > 1e-6) qFatal("a point off the plane");
        if (std::abs(point.z() - chin) < 4) y = std::min(y, point.y());
      }
    }
    return y;
  };
  foremost_before = foremost(profile.before);
  foremost_after = foremost(profile.after);
  const double chin_moves = model().response().landmarks.at("pogonion_soft").displacement.norm();
  QVERIFY(std::abs((foremost_before - foremost_after) - chin_moves) < 0.5);
  for (const ProfileLandmark& landmark : profile.landmarks) {
    if (landmark.name != "Pogonion soft") continue;
    QVERIFY(std::abs((landmark.after - landmark.before).norm() - chin_moves) < 1e-6);
  }
  QVERIFY(differing_pixels(faces, view().picture()) > 1000);
  // The paper follows the mouse; another plane gives another outline.
  const Picture paper = view().picture();
  drag(at(0.5, 0.5), at(0.6, 0.4));
  QVERIFY(differing_pixels(paper, view().picture()) > 500);
  box("section_box")->setValue(20);
  QVERIFY(std::abs(panel().compare_view().profile().before[0](0, 0) - (x + 20)) < 1e-6);
  box("section_box")->setValue(0);
}

void CompareTest::colourMapHasAFixedOrAutomaticRange() {
  const Picture photograph = view().picture();
  click("colour_check");
  QVERIFY(view().is_colour_map_visible());
  QVERIFY(action("colour_map_action")->isChecked());
  shoot("compare_colour_map");
  const Picture automatic = view().picture();
  QVERIFY(differing_pixels(photograph, automatic) > 500);
  box("range_box")->setValue(20);
  QVERIFY(differing_pixels(automatic, view().picture()) > 500);
  action("colour_map_action")->trigger();
  QVERIFY(!find<QCheckBox>("colour_check")->isChecked());
}

void CompareTest::numbersAreThoseOfTheAnswer() {
  const Prediction& refined = *model().refined();
  auto* table = find<QTableWidget>("numbers_table");
  const auto shown = [&](int row, int column) {
    return table->item(row, column)->text().toDouble();
  };
  const auto near = [](double a, double b) { return std::abs(a - b) < 0.051; };
  QVERIFY(near(shown(0, 0), refined.displacement.mean));
  QVERIFY(near(shown(0, 1), refined.displacement.p95));
  QVERIFY(near(shown(0, 2), refined.displacement.max));
  QVERIFY(near(shown(2, 1), refined.answer.error.total.p95));
  const std::vector<int>& moving = model().loaded().model->moving_vertices();
  const DistanceStatistics change = distance_statistics(refined.signed_distance(moving));
  QVERIFY(near(shown(1, 0), change.mean));
  QVERIFY(near(shown(1, 2), change.max));
  QVERIFY(label("answer_label").contains("Refined"));
  // The chin comes forward by 6 mm: the face gains.
  QVERIFY(panel().change().volume_mm3 > 1000);
  auto* histogram = find<HistogramView>("histogram_view");
  QCOMPARE(histogram->histogram().total(), change.count);
  QCOMPARE(std::abs(histogram->marks()[2].mm), change.max);
  QCOMPARE(std::abs(histogram->marks()[1].mm), change.p95);
  find<QComboBox>("quantity_box")->setCurrentIndex(1);
  QCOMPARE(histogram->histogram().total(), static_cast<Eigen::Index>(moving.size()));
  QCOMPARE(histogram->marks()[0].mm, refined.displacement.mean);
  QVERIFY(histogram->histogram().high() >= refined.displacement.max);
  find<QComboBox>("quantity_box")->setCurrentIndex(0);
}

void CompareTest::quickAnswerSaysSo() {
  advance(4);
  QVERIFY(label("answer_label").contains("not refined yet"));
  QVERIFY(label("volume_label").contains("quick answer"));
  auto* table = find<QTableWidget>("numbers_table");
  QVERIFY(std::abs(table->item(0, 2)->text().toDouble() - model().response().displacement.max) <
          0.051);
  QCOMPARE(table->item(1, 0)->text(), QString(QChar(0x2013)));
  QVERIFY(find<HistogramView>("histogram_view")->histogram().counts.empty());
  wait_for_refined();
  QVERIFY(label("answer_label").contains("Refined"));
  QVERIFY(!find<HistogramView>("histogram_view")->histogram().counts.empty());
}

void CompareTest::pointUnderTheMouseIsReadOnBothSides() {
  view().look_from(CameraPreset::front);
  view().picture();
  const CompareView& compare = panel().compare_view();
  const auto left = compare.reading_at(at(0.25, 0.6));
  const auto right = compare.reading_at(at(0.75, 0.6));
  QVERIFY(left && right);
  QVERIFY(left->on_before && !right->on_before);
  // The same line of sight meets the two faces at places that it joins.
  const Eigen::Vector3d eye(view().renderer()->GetActiveCamera()->GetPosition());
  const double angle = std::acos(
      std::min(1.0, (left->before - eye).normalized().dot((right->after - eye).normalized())));
  QVERIFY2(angle < 1e-3, qPrintable(QString::number(angle)));
  // Measured on the model itself.
  const TriangleMesh& rest = model().loaded().anatomy->face.mesh.surface;
  const ViewPoint sight = view().view_point(at(0.75, 0.6));
  const auto hit =
      BspTree({model().response().face, rest.triangles}).first_hit(sight.eye, sight.direction, 1e5);
  QVERIFY(hit);
  const Eigen::Vector3d place = sight.eye + hit->distance * sight.direction;
  QVERIFY((place - right->after).norm() < 1e-6);
  double mm = 0;
  for (int c = 0; c < 3; ++c) {
    mm +=
        hit->barycentric[c] * model().refined()->signed_distance[rest.triangles(hit->triangle, c)];
  }
  QVERIFY(right->signed_mm && std::abs(*right->signed_mm - mm) < 1e-9);
  QVERIFY(!compare.reading_at(at(0.99, 0.02)));
  QTest::mouseMove(canvas(), at(0.74, 0.6));
  QTest::mouseMove(canvas(), at(0.75, 0.6));
  QTRY_VERIFY(label("reading_label").contains("moves"));
  QVERIFY(find<QLabel>("cursor_words")->isVisible());
  shoot("compare_reading");
}

void CompareTest::distanceIsMeasuredByTwoClicks() {
  view().look_from(CameraPreset::front);
  const Picture plain = view().picture();
  const CompareView& compare = panel().compare_view();
  click("distance_button");
  // One end on the predicted face, the other on the face before.
  const QPoint first = at(0.75, 0.62), second = at(0.25, 0.45);
  const auto a = compare.reading_at(first), b = compare.reading_at(second);
  QVERIFY(a && b);
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, first);
  QVERIFY(!compare.distance());
  QVERIFY(label("distance_label").contains("second"));
  QTest::mouseClick(canvas(), Qt::LeftButton, {}, second);
  QVERIFY(compare.distance());
  QVERIFY(std::abs(compare.distance()->before - (a->before - b->before).norm()) < 1e-9);
  QVERIFY(std::abs(compare.distance()->after - (a->after - b->after).norm()) < 1e-9);
  QVERIFY(label("distance_label").contains(mm_words(compare.distance()->after)));
  shoot("compare_distance");
  QVERIFY(differing_pixels(plain, view().picture()) > 100);
  advance(3);  // the ends stay on the skin
  QVERIFY(std::abs(compare.distance()->after - (a->after - b->after).norm()) > 0.1);
  click("clear_button");
  QVERIFY(!compare.distance());
}

void CompareTest::placesAreSaidInWords() {
  QCOMPARE(direction_words({12.34, -5, 0.01}), QString("12.3 mm left, 5.0 mm forward"));
  QCOMPARE(direction_words({-1, 2, -3}), QString("1.0 mm right, 2.0 mm back, 3.0 mm down"));
  QCOMPARE(direction_words({0, 0, 0}), QString("0.0 mm"));
  QCOMPARE(mm_words(-0.04, true), QString("0.0 mm"));
  QCOMPARE(mm_words(1.25, true).left(2), QString("+1"));
}

void CompareTest::bonesAreExportedInTheirPlannedPlaces() {
  const QString target = path("bones");
  answer("bones_action", "bones_dialog", target);
  QTRY_VERIFY_WITH_TIMEOUT(QDir(target).exists(), patience);
  const BoneSegment& segment = model().loaded().anatomy->segments[0];
  std::string header;
  const TriangleMesh written =
      read_stl(target.toStdString() + "/segment_" + segment.name + ".stl", header);
  QVERIFY(header.find("mm") != std::string::npos && header.find("LPS") != std::string::npos);
  QVERIFY(header.rfind("solid", 0) == std::string::npos);
  QCOMPARE(written.triangles.rows(), segment.mesh.triangles.rows());
  QVERIFY(std::abs(signed_volume(written) / segment.volume_mm3 - 1) < 1e-4);
  const Eigen::Vector3d expected = model().response().poses[0](centre_of_volume(segment.mesh));
  QVERIFY((centre_of_volume(written) - expected).norm() < 0.01);
  const TriangleMesh remainder = read_stl(target.toStdString() + "/remainder.stl", header);
  QCOMPARE(remainder.triangles.rows(), model().loaded().anatomy->remainder.triangles.rows());
}

void CompareTest::exportsNeverOverwrite() {
  const QString target = path("taken");
  QVERIFY(QDir().mkpath(target));
  Exports exports(model(), view(), window_.get());
  QSignalSpy failed(&exports, &Exports::failed);
  exports.save_bones(target.toStdString());
  QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, patience);
  QVERIFY(failed[0][0].value<Failure>().subject.contains("taken"));
  TurntableWish wish;
  for (const auto form : {TurntableWish::Form::film, TurntableWish::Form::pictures}) {
    wish.form = form;
    wish.target = target.toStdString();
    exports.save_turntable(wish);
  }
  QCOMPARE(failed.count(), 3);
  QVERIFY(QDir(target).isEmpty());
}

void CompareTest::faceIsExportedExactly() {
  const fs::path target = path("face").toStdString();
  model().export_face(target);
  QTRY_VERIFY_WITH_TIMEOUT(!model().is_exporting(), patience);
  const ObjDocument document = ObjDocument::read(target / "predicted.obj");
  const Points expected =
      model().loaded().anatomy->face.file_vertices(model().refined()->face_points);
  const Points written = document.mesh().surface.vertices;
  QCOMPARE(written.rows(), expected.rows());
  QVERIFY((written - expected).cwiseAbs().maxCoeff() < 1e-6);
}

void CompareTest::turntableIsAFilmOrPictures() {
  Exports exports(model(), view(), window_.get());
  QSignalSpy done(&exports, &Exports::exported), failed(&exports, &Exports::failed);
  TurntableWish wish;
  wish.pictures = 4;
  wish.side = 200;
  wish.form = TurntableWish::Form::pictures;
  wish.target = path("turn").toStdString();
  exports.save_turntable(wish);
  QVERIFY(!QDir(path("turn")).exists());  // whole or not at all
  QTRY_COMPARE_WITH_TIMEOUT(done.count() + failed.count(), 1, patience);
  QCOMPARE(failed.count(), 0);
  const Picture front = read_picture_file(wish.target / "turn_0001.png");
  const Picture left = read_picture_file(wish.target / "turn_0002.png");
  QCOMPARE(front.width, 400);
  QCOMPARE(front.height, 200);
  QVERIFY(differing_pixels(front, left) > 2000);
  QVERIFY(QFileInfo::exists(path("turn/turn_0004.png")));
  QVERIFY(!QFileInfo::exists(path("turn/turn_0005.png")));
  wish.form = TurntableWish::Form::film;
  wish.target = path("turn.avi").toStdString();
  exports.save_turntable(wish);
  QTRY_COMPARE_WITH_TIMEOUT(done.count() + failed.count(), 2, patience);
  QCOMPARE(failed.count(), 0);
  const std::string film = read_text_file(wish.target);
  QCOMPARE(QString::fromStdString(film.substr(0, 4) + film.substr(8, 4)), QString("RIFFAVI "));
  // The view goes on as it was.
  QVERIFY(view().picture().width > 0);
}

void CompareTest::turntableCanBeCancelled() {
  Exports exports(model(), view(), window_.get());
  QSignalSpy done(&exports, &Exports::exported), failed(&exports, &Exports::failed);
  TurntableWish wish;
  wish.pictures = 700;
  wish.side = 160;
  wish.target = path("never.avi").toStdString();
  exports.save_turntable(wish);
  QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QProgressDialog*>("export_progress") != nullptr &&
                               find<QProgressDialog>("export_progress")->isVisible(),
                           patience);
  auto* progress = find<QProgressDialog>("export_progress");
  QTRY_VERIFY_WITH_TIMEOUT(progress->value() > 0, patience);
  QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
  QTRY_VERIFY(!exports.is_running());
  QCOMPARE(done.count() + failed.count(), 0);
  QVERIFY(!QFileInfo::exists(path("never.avi")));
  QVERIFY(!QFileInfo::exists(path("never.avi.part")));
}

void CompareTest::largerPictureShowsTheSame() {
  const Picture once = view().picture();
  const Picture twice = view().picture(2);
  QCOMPARE(twice.width, 2 * once.width);
  QCOMPARE(twice.height, 2 * once.height);
  Picture shrunk{once.width, once.height, {}};
  for (int y = 0; y < once.height; ++y) {
    for (int x = 0; x < once.width; ++x) {
      for (int k = 0; k < 3; ++k) shrunk.rgb.push_back(twice.at(2 * x, 2 * y)[k]);
    }
  }
  const int apart = differing_pixels(once, shrunk);
  QVERIFY2(apart < once.width * once.height / 10, qPrintable(QString::number(apart)));
  QVERIFY(differing_pixels(once, view().picture()) < once.width * once.height / 500);
}

void CompareTest::windowMayCloseWhileComparing() {
  auto window = std::make_unique<MainWindow>();
  window->show();
  User(*window).open(demo_ + "/plain.json");
  auto* steps = window->findChild<QTabWidget*>("steps");
  steps->setCurrentIndex(steps->count() - 1);
  Exports* exports = window->findChild<Exports*>();
  QVERIFY(exports != nullptr);
  TurntableWish wish;
  wish.target = path("closed.avi").toStdString();
  exports->save_turntable(wish);
  QTest::qWait(700);
  window.reset();
  QVERIFY(!QFileInfo::exists(path("closed.avi")));
  QVERIFY(!QFileInfo::exists(path("closed.avi.part")));
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  return gnathion::test::run<gnathion::test::CompareTest>(argc, argv);
}

#include "compare_test.moc"
