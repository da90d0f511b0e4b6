#include <QComboBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QUrl>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/driven_window.h"
#include "app/theme.h"
#include "imaging/ct_import.h"
#include "imaging/dicom_series.h"
#include "io/files.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

/// Every second voxel along each axis, as a .mha file: quick to read.
void write_small_volume(const CtVolume& ct, const fs::path& file) {
  const Eigen::Vector3i dims = ct.dims() / 2;
  std::vector<int16_t> values;
  for (int k = 0; k < dims.z(); ++k) {
    for (int j = 0; j < dims.y(); ++j) {
      for (int i = 0; i < dims.x(); ++i) values.push_back(ct.at(2 * i, 2 * j, 2 * k));
    }
  }
  std::ofstream stream(file, std::ios::binary);
  stream << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         << "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = "
         << ct.lps(Eigen::Vector3d::Zero()).transpose()
         << "\nElementSpacing = " << (2 * ct.steps()).transpose()
         << "\nDimSize = " << dims.transpose()
         << "\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
  stream.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(int16_t)));
}

}  // namespace

class StartTest : public QObject, private DrivenWindow {
  Q_OBJECT

 private slots:
  void initTestCase();
  void init();
  void cleanup();

  void recentCasesAreListedAndForgotten();
  void recentListClears();
  void demoSavesWithItsOwnImages();
  void droppedCaseOpens();
  void droppedVolumeIsImported();
  void droppedFolderListsItsSeries();
  void descriptionsAreShownWhenAsked();
  void listingCanBeCancelled();
  void onlyCtsCanBeChosen();
  void brokenFolderLeavesTheOpenCase();
  void unknownFilesAreRefused();
  void photographNeedsACase();
  void photographIsAddedWhenUnitAndFrameAreStated();
  void changesAreSavedBeforeAnotherCase();
  void changesAreDiscardedWhenAsked();
  void cancelKeepsTheCase();
  void closingAsksToo();
  void saveWithoutAFileAsksForOne();
  void themeChangesTheColours();
  void changesAreKeptAndRemoved();
  void crashedWindowIsRecovered();
  void leftBehindCanBeDiscarded();

 private:
  QString page() const { return find<QStackedWidget>("pages")->currentWidget()->objectName(); }
  bool drop(const QStringList& files, QWidget* where) const;
  bool drop(const QString& file) const { return drop({file}, find<QWidget>("pages")); }
  /// A dialog or box that is open; null: none.
  template <typename T>
  T* shown(const char* name) const {
    T* found = window_->findChild<T*>(name);
    return found != nullptr && found->isVisible() ? found : nullptr;
  }
  void open_case(const QString& file) const {
    open(file);
    QVERIFY2(model().has_case(), qPrintable(message()));
  }
  void change() const;
  /// A case that is quick to open: a small volume, nothing cut.
  QString small_case(const QString& name) const;
  QString recovery_root() const { return Recovery::default_root(); }
  QStringList kept() const {
    return QDir(recovery_root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  }
  void crash_after_import() const;

  QString volume_;
};

void StartTest::initTestCase() {
  make_demo();
  Progress progress;
  volume_ = path("small head.mha");
  write_small_volume(read_ct(demo_.toStdString() + "/ct", {}, progress), volume_.toStdString());
}

void StartTest::init() {
  start_window();
}

void StartTest::cleanup() {
  window_.reset();
  QCOMPARE(kept(), QStringList());  // whoever closes as he should leaves nothing behind
}

QString StartTest::small_case(const QString& name) const {
  SurgicalCase plan;
  plan.name = name.toStdString();
  plan.ct.path = volume_.toStdString();
  const QString file = path(name + ".gnathion.json");
  write_case_file(plan, file.toStdString());
  return file;
}

/// Drops files on a widget of the window, as the display's server would: on the window's own
/// surface, at the widget's place. False when the window does not take them.
bool StartTest::drop(const QStringList& files, QWidget* where) const {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files) urls << QUrl::fromLocalFile(file);
  data.setUrls(urls);
  const QPoint at = where->mapTo(window_.get(), where->rect().center());
  QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QApplication::sendEvent(window_->windowHandle(), &enter);
  if (!enter.isAccepted()) return false;
  QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_->windowHandle(), &move);
  QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_->windowHandle(), &dropped);
  return dropped.isAccepted();
}

/// Changes the open case: the change is not saved.
void StartTest::change() const {
  SurgicalCase plan = model().plan();
  plan.name += " changed";
  model().edit("Rename", plan);
  settle();
  QVERIFY(model().is_modified());
}

void StartTest::recentCasesAreListedAndForgotten() {
  const QString first = small_case("first"), second = small_case("second");
  open_case(first);
  open_case(second);
  open_case(first);
  QVERIFY(QFile::remove(second));
  start_window();  // the next one
  auto* list = find<QListWidget>("recent_list");
  QVERIFY(list->isVisible());
  QVERIFY(list->item(0)->text().startsWith("first.gnathion.json"));
  QVERIFY(list->item(1)->text().startsWith("second.gnathion.json"));
  QVERIFY(list->item(1)->text().contains("moved or deleted"));
  list->setCurrentRow(1);
  QVERIFY(!find<QPushButton>("recent_open_button")->isEnabled());
  click("recent_forget_button");
  for (int row = 0; row < list->count(); ++row) {
    QVERIFY(!list->item(row)->text().startsWith("second"));
  }
  list->setCurrentRow(0);
  click("recent_open_button");
  settle();
  QCOMPARE(model().plan().name, std::string("first"));
  QCOMPARE(page(), QString("view_page"));
}

void StartTest::recentListClears() {
  open_case(small_case("listed"));
  start_window();
  QVERIFY(find<QListWidget>("recent_list")->count() > 0);
  click("recent_clear_button");
  QCOMPARE(find<QListWidget>("recent_list")->count(), 0);
  QVERIFY(!find<QWidget>("recent_group")->isVisible());
  QVERIFY(!MainWindow().findChild<QWidget*>("recent_menu")->isEnabled());
}

void StartTest::demoSavesWithItsOwnImages() {
  const fs::path cache = path("cache").toStdString();
  model().open_demo_case(cache);
  settle();
  QVERIFY(!model().is_modified());
  model().set_motion({.forward_mm = 4});
  QVERIFY(model().is_modified());
  const QString file = path("mine.gnathion.json");
  trigger("save_action");
  answer("save_dialog", file);
  QVERIFY(!model().is_modified());
  const LoadedCase* loaded = &model().loaded();
  // The next build's first demo removes the cache; the saved case does not need it.
  fs::remove_all(cache);
  model().undo();
  QCOMPARE(&model().loaded(), loaded);  // nothing had to be computed anew
  model().redo();
  trigger("save_action");
  QVERIFY(!fs::exists(path("mine_images_2").toStdString()));  // copied once
  QVERIFY(fs::exists(path("mine_images/ct").toStdString()));
  open_case(file);
  QCOMPARE(model().motion(), (JawMotion{.forward_mm = 4}));
  QVERIFY(!model().loaded().anatomy->face.mesh.materials.empty());
  QVERIFY(!message_visible());
}

void StartTest::droppedCaseOpens() {
  QVERIFY(drop({small_case("dropped")}, find<QLabel>("drop_label")));
  settle();
  QCOMPARE(model().plan().name, std::string("dropped"));
  // Also on the 3D view of an open case.
  QVERIFY(drop({small_case("another")}, find<QWidget>("face_canvas")));
  settle();
  QCOMPARE(model().plan().name, std::string("another"));
  QMimeData text;
  text.setText("a letter");
  QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QApplication::sendEvent(window_->windowHandle(), &enter);
  QVERIFY(!enter.isAccepted());
}

void StartTest::droppedVolumeIsImported() {
  QVERIFY(drop(volume_));
  QVERIFY(model().is_working());
  settle();
  QVERIFY2(model().has_case(), qPrintable(message()));
  QCOMPARE(model().plan().ct.path, fs::path(volume_.toStdString()));
  QVERIFY(!model().has_segments());
  QVERIFY(model().is_modified());
  QVERIFY(model().file().empty());
  QCOMPARE(page(), QString("view_page"));
}

void StartTest::droppedFolderListsItsSeries() {
  QVERIFY(drop(demo_ + "/ct"));
  auto* dialog = shown<QDialog>("series_dialog");
  QVERIFY(dialog != nullptr);
  QVERIFY(!model().is_working());
  auto* table = find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  Progress progress;
  const SeriesSummary series = list_series(demo_.toStdString() + "/ct", progress).at(0);
  QCOMPARE(table->item(0, 0)->text(), QString("CT"));
  QCOMPARE(table->item(0, 2)->text(), QString::number(series.slices));
  QCOMPARE(table->item(0, 3)->text(), QString("%1 × %2").arg(series.size.x()).arg(series.size.y()));
  QVERIFY(table->item(0, 5)->text().contains("can be imported"));
  QVERIFY(find<QPushButton>("series_import_button")->isEnabled());  // the only one: chosen
  click("series_import_button");
  settle();
  QVERIFY2(model().has_case(), qPrintable(message()));
  QCOMPARE(model().plan().ct.series_uid, std::optional(series.uid));
  QVERIFY(shown<QDialog>("series_dialog") == nullptr);
}

void StartTest::descriptionsAreShownWhenAsked() {
  QVERIFY(drop(demo_ + "/ct"));
  auto* table = find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  Progress progress;
  const SeriesSummary series = list_series(demo_.toStdString() + "/ct", progress).at(0);
  const QString description = QString::fromStdString(series.description);
  QVERIFY(!description.isEmpty());
  QVERIFY(!table->item(0, 1)->text().contains(description));
  auto* box = find<QCheckBox>("show_descriptions_box");
  QVERIFY(!box->isChecked());
  box->click();
  QCOMPARE(table->item(0, 1)->text(), description);
  box->click();
  QVERIFY(!table->item(0, 1)->text().contains(description));
  click("series_cancel_button");
  QVERIFY(!model().is_working());
  QVERIFY(!model().has_case());
}

void StartTest::listingCanBeCancelled() {
  QVERIFY(drop(demo_ + "/ct"));
  click("series_cancel_button");
  QTest::qWait(200);
  QVERIFY(shown<QDialog>("series_dialog") == nullptr);
  QVERIFY(!message_visible());
  // The window may close while a folder is read.
  QVERIFY(drop(demo_ + "/ct"));
  window_.reset();
}

void StartTest::onlyCtsCanBeChosen() {
  // The same slices as another modality: the letters stand as CS in each file.
  const QString mr = path("mr");
  QVERIFY(QDir().mkpath(mr));
  int copied = 0;
  for (const auto& entry : fs::directory_iterator(demo_.toStdString() + "/ct")) {
    std::string bytes = read_text_file(entry.path());
    const std::string tag{'\x08', '\0', '\x60', '\0', 'C', 'S', '\x02', '\0', 'C', 'T'};
    const std::size_t at = bytes.find(tag);
    QVERIFY(at != std::string::npos);
    bytes.replace(at + 8, 2, "MR");
    write_text_file(fs::path(mr.toStdString()) / entry.path().filename(), bytes);
    if (++copied == 4) break;
  }
  QVERIFY(drop(mr));
  auto* table = find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  QCOMPARE(table->item(0, 0)->text(), QString("MR"));
  QVERIFY(table->item(0, 5)->text().contains("not a CT"));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                    table->visualItemRect(table->item(0, 0)).center());
  QVERIFY(!find<QPushButton>("series_import_button")->isEnabled());
  QVERIFY(find<QLabel>("series_stage")->text().contains("None"));
  click("series_cancel_button");
}

void StartTest::brokenFolderLeavesTheOpenCase() {
  open_case(small_case("open"));
  const LoadedCase* loaded = &model().loaded();
  const QString empty = path("no images here");
  QVERIFY(QDir().mkpath(empty));
  write_text_file(empty.toStdString() + "/letter.txt", "no image");
  QVERIFY(drop(empty));
  QTRY_VERIFY_WITH_TIMEOUT(message_visible(), patience);
  QVERIFY2(message().contains("no images here"), qPrintable(message()));
  QVERIFY(shown<QDialog>("series_dialog") == nullptr);
  // A series with a slice missing is found when it is read.
  const QString gap = path("gap");
  fs::copy(demo_.toStdString() + "/ct", gap.toStdString());
  auto middle = QDir(gap).entryList(QDir::Files).at(40);
  QVERIFY(QFile::remove(gap + "/" + middle));
  find<QWidget>("message_bar")->hide();
  QVERIFY(drop(gap));
  auto* table = find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  click("series_import_button");
  settle();
  QVERIFY(message_visible());
  QVERIFY2(message().contains("missing"), qPrintable(message()));
  QCOMPARE(&model().loaded(), loaded);
}

void StartTest::unknownFilesAreRefused() {
  const QString letter = path("letter.docx");
  write_text_file(letter.toStdString(), "a letter");
  QVERIFY(drop(letter));
  QVERIFY(message_visible());
  QVERIFY2(message().contains("letter.docx"), qPrintable(message()));
  QVERIFY(message().contains(".nii.gz"));
  find<QWidget>("message_bar")->hide();
  QVERIFY(drop({letter, volume_}, find<QWidget>("pages")));
  QVERIFY(message_visible());
  QVERIFY(message().contains("one"));
  QVERIFY(!model().is_working());
}

void StartTest::photographNeedsACase() {
  QVERIFY(drop(demo_ + "/photograph/face.obj"));
  QVERIFY(message_visible());
  QVERIFY2(message().contains("open a case or import a CT first"), qPrintable(message()));
  QVERIFY(shown<QDialog>("photograph_dialog") == nullptr);
}

void StartTest::photographIsAddedWhenUnitAndFrameAreStated() {
  QVERIFY(drop(volume_));
  settle();
  QVERIFY(model().has_case());
  // The CT's own skin in centimetres.
  const Face skin = model().loaded().anatomy->face;
  QVERIFY(!skin.is_photograph);
  skin.document.write(folder_.path().toStdString(), "face_cm.obj", skin.mesh.surface.vertices / 10);
  QVERIFY(drop(path("face_cm.obj")));
  auto* add = find<QPushButton>("photograph_add_button");
  auto* unit = find<QComboBox>("photograph_unit_box");
  QVERIFY(!add->isEnabled());  // nothing is assumed
  unit->setCurrentIndex(2);
  QVERIFY(!add->isEnabled());
  find<QRadioButton>("photograph_on_ct_button")->click();
  QVERIFY(add->isEnabled());
  unit->setCurrentIndex(0);
  QVERIFY(!add->isEnabled());
  unit->setCurrentIndex(2);
  add->click();
  settle();
  QVERIFY2(!message_visible(), qPrintable(message()));
  const Face& face = model().loaded().anatomy->face;
  QVERIFY(face.is_photograph);
  QCOMPARE(model().plan().photograph->lps_from_photograph.scale, 10.0);
  QVERIFY((face.mesh.surface.vertices - skin.mesh.surface.vertices).cwiseAbs().maxCoeff() < 1e-3);
  QCOMPARE(find<QAction>("undo_action")->text(), QString("&Undo: Add the photograph"));
  trigger("undo_action");
  settle();
  QVERIFY(!model().loaded().anatomy->face.is_photograph);
}

void StartTest::changesAreSavedBeforeAnotherCase() {
  const QString first = small_case("first to save"), second = small_case("second to open");
  open_case(first);
  change();
  QVERIFY(window_->isWindowModified());
  QVERIFY(drop(second));
  QVERIFY(!model().is_working());
  QVERIFY(shown<QMessageBox>("unsaved_box") != nullptr);
  click("unsaved_save_button");
  settle();
  QCOMPARE(model().plan().name, std::string("second to open"));
  QVERIFY(!window_->isWindowModified());
  QCOMPARE(read_case_file(first.toStdString()).name, std::string("first to save changed"));
}

void StartTest::changesAreDiscardedWhenAsked() {
  const QString first = small_case("first to discard"), second = small_case("second to open");
  open_case(first);
  change();
  QVERIFY(drop(second));
  click("unsaved_discard_button");
  settle();
  QCOMPARE(model().plan().name, std::string("second to open"));
  QCOMPARE(read_case_file(first.toStdString()).name, std::string("first to discard"));
}

void StartTest::cancelKeepsTheCase() {
  const QString first = small_case("first to keep"), second = small_case("second not to open");
  open_case(first);
  change();
  for (const bool with_escape : {false, true}) {
    QVERIFY(drop(second));
    auto* box = shown<QMessageBox>("unsaved_box");
    QVERIFY(box != nullptr);
    if (with_escape) {
      QTest::keyClick(box, Qt::Key_Escape);
    } else {
      click("unsaved_cancel_button");
    }
    QTRY_VERIFY(shown<QMessageBox>("unsaved_box") == nullptr);
    QTest::qWait(20);
    QVERIFY(!model().is_working());
    QCOMPARE(model().plan().name, std::string("first to keep changed"));
    QVERIFY(model().is_modified());
  }
  QCOMPARE(read_case_file(first.toStdString()).name, std::string("first to keep"));
}

void StartTest::closingAsksToo() {
  const QString file = small_case("to close");
  open_case(file);
  change();
  window_->close();
  QVERIFY(window_->isVisible());
  click("unsaved_cancel_button");
  QTest::qWait(20);
  QVERIFY(window_->isVisible());
  window_->close();
  click("unsaved_save_button");
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(read_case_file(file.toStdString()).name, std::string("to close changed"));
  start_window();
  open_case(file);
  change();
  window_->close();
  click("unsaved_discard_button");
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(read_case_file(file.toStdString()).name, std::string("to close changed"));
}

void StartTest::saveWithoutAFileAsksForOne() {
  QVERIFY(drop(volume_));
  settle();
  const QString other = small_case("other");
  // Cancelling the dialog, or a place that cannot be written, opens nothing.
  QVERIFY(drop(other));
  click("unsaved_save_button");
  QVERIFY(shown<QFileDialog>("save_dialog") != nullptr);
  find<QFileDialog>("save_dialog")->reject();
  QTRY_VERIFY(shown<QFileDialog>("save_dialog") == nullptr);
  QVERIFY(!model().is_working());
  QTRY_VERIFY(window_->findChild<QFileDialog*>("save_dialog") == nullptr);
  model().save_case(path("no such folder/case.json").toStdString());
  QVERIFY(message_visible());
  QVERIFY(model().is_modified());
  // A save that has nothing to do with the question must not open what was wanted then.
  const fs::path own = path("own.json").toStdString();
  model().save_case(own);
  QVERIFY(!model().is_working());
  QVERIFY(!model().is_modified());
  QCOMPARE(model().file(), own);
}

void StartTest::themeChangesTheColours() {
  const auto lightness = [this] { return window_->palette().color(QPalette::Window).lightness(); };
  trigger("dark_theme_action");
  QVERIFY(lightness() < 90);
  QVERIFY(warning_colour(window_->palette()).lightness() > 150);
  QCOMPARE(chosen_theme(), Theme::dark);
  QVERIFY(MainWindow().findChild<QAction*>("dark_theme_action")->isChecked());
  trigger("light_theme_action");
  QVERIFY(lightness() > 200);
  QVERIFY(warning_colour(window_->palette()).lightness() < 110);
  trigger("system_theme_action");
  QCOMPARE(chosen_theme(), Theme::system);
}

void StartTest::changesAreKeptAndRemoved() {
  const QString file = small_case("kept");
  open_case(file);
  QTest::qWait(2500);
  QCOMPARE(kept(), QStringList());  // nothing to lose
  change();
  QTRY_COMPARE_WITH_TIMEOUT(kept().size(), 1, 6000);
  const QString folder = recovery_root() + "/" + kept().at(0);
  QTRY_COMPARE(read_case_file(folder.toStdString() + "/1/case.json").name,
               std::string("kept changed"));
  // It is this window's: no other one offers it.
  {
    MainWindow other;
    other.show();
    QVERIFY(!other.findChild<QWidget*>("left_behind_group")->isVisible());
    QCOMPARE(kept().size(), 1);
  }
  trigger("save_action");
  QTRY_COMPARE(kept(), QStringList());
  change();
  trigger("undo_action");
  QTest::qWait(2500);
  QCOMPARE(kept(), QStringList());
}

/// A program of its own imports a CT, keeps it, and is killed.
void StartTest::crash_after_import() const {
  QProcess program;
  program.setProcessChannelMode(QProcess::ForwardedChannels);
  program.start(GNATHION_PROGRAM, {volume_});
  QVERIFY(program.waitForStarted());
  const auto copy_is_there = [this] {
    const QStringList folders = kept();
    return !folders.isEmpty() &&
           QFile::exists(recovery_root() + "/" + folders.at(0) + "/1/about.json");
  };
  QTRY_VERIFY_WITH_TIMEOUT(copy_is_there(), patience);
  program.kill();
  QVERIFY(program.waitForFinished());
  QCOMPARE(program.exitStatus(), QProcess::CrashExit);
}

void StartTest::crashedWindowIsRecovered() {
  crash_after_import();
  start_window();
  auto* list = find<QListWidget>("left_behind_list");
  QVERIFY(find<QWidget>("left_behind_group")->isVisible());
  QCOMPARE(list->count(), 1);
  QVERIFY2(list->item(0)->text().contains("was not saved yet"), qPrintable(list->item(0)->text()));
  click("recover_button");
  settle();
  QVERIFY2(model().has_case(), qPrintable(message()));
  QCOMPARE(model().plan().ct.path, fs::path(volume_.toStdString()));
  QVERIFY(model().is_modified());
  QVERIFY(model().file().empty());
  // The old copy goes when this window has one of its own.
  QTRY_COMPARE_WITH_TIMEOUT(list->count(), 0, 10000);
  QCOMPARE(kept().size(), 1);
  model().save_case(path("recovered.json").toStdString());
  QTRY_COMPARE(kept(), QStringList());
}

void StartTest::leftBehindCanBeDiscarded() {
  crash_after_import();
  // A copy that cannot be read: the message says so, and it stays to be discarded.
  const QString copy = recovery_root() + "/" + kept().at(0) + "/1/case.json";
  write_text_file(copy.toStdString(), "{\"gnathion_case\": 1, \"ct\": {");
  start_window();
  click("recover_button");
  settle();
  QVERIFY(message_visible());
  QVERIFY(!model().has_case());
  QCOMPARE(kept().size(), 1);
  click("discard_button");
  QCOMPARE(kept(), QStringList());
  QVERIFY(!find<QWidget>("left_behind_group")->isVisible());
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  return gnathion::test::run<gnathion::test::StartTest>(argc, argv);
}

#include "start_test.moc"
