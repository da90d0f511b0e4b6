#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

#include "app/display.h"
#include "app/main_window.h"
#include "app/theme.h"
#include "demo/demo_case.h"
#include "imaging/ct_import.h"
#include "imaging/dicom_series.h"
#include "io/case_file.h"
#include "io/files.h"

namespace gnathion::test {
namespace {

namespace fs = std::filesystem;

constexpr int patience = 60000;  // ms, for work beside the window

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

/// The window as a user has it.
struct User {
  MainWindow& window;

  template <typename T>
  T* find(const char* name) const {
    T* found = window.findChild<T*>(name);
    if (found == nullptr) qFatal("no widget %s", name);
    return found;
  }
  CaseController& model() const { return window.controller(); }
  void click(const char* button) const {
    QTest::mouseClick(find<QAbstractButton>(button), Qt::LeftButton);
  }
  void trigger(const char* action) const { find<QAction>(action)->trigger(); }
  QString page() const { return find<QStackedWidget>("pages")->currentWidget()->objectName(); }
  bool message_visible() const { return find<QWidget>("message_bar")->isVisible(); }
  QString message() const {
    return find<QLabel>("message_title")->text() + "\n" + find<QLabel>("message_text")->text() +
           "\n" + find<QLabel>("message_remedy")->text();
  }
  /// Drops files on a widget of the window, as the display's server would: on the window's own
  /// surface, at the widget's place. False when the window does not take them.
  bool drop(const QStringList& files, QWidget* where) const {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    const QPoint at = where->mapTo(&window, where->rect().center());
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QApplication::sendEvent(window.windowHandle(), &enter);
    if (!enter.isAccepted()) return false;
    QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.windowHandle(), &move);
    QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window.windowHandle(), &dropped);
    return dropped.isAccepted();
  }
  bool drop(const QString& file) const { return drop({file}, find<QWidget>("pages")); }
  /// A dialog or box that is open; null: none.
  template <typename T>
  T* open(const char* name) const {
    T* found = window.findChild<T*>(name);
    return found != nullptr && found->isVisible() ? found : nullptr;
  }
  /// Answers a file dialog that is open.
  void answer(const char* dialog_name, const QString& file) const {
    auto* dialog = find<QFileDialog>(dialog_name);
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
    auto* buttons = dialog->findChild<QDialogButtonBox*>("buttonBox");
    for (QAbstractButton* button : buttons->buttons()) {
      if (buttons->buttonRole(button) != QDialogButtonBox::AcceptRole) continue;
      QTest::mouseClick(button, Qt::LeftButton);
      break;
    }
    QTRY_VERIFY(window.findChild<QFileDialog*>(dialog_name) == nullptr);
  }
  void wait() const { QTRY_VERIFY_WITH_TIMEOUT(!model().is_working(), patience); }
  void open_case(const QString& file) const {
    window.open_case(file);
    wait();
    QVERIFY2(model().has_case(), qPrintable(message()));
  }
  /// Changes the open case: the change is not saved.
  void change() const {
    SurgicalCase plan = model().plan();
    plan.name += " changed";
    model().edit("Rename", plan);
    wait();
    QVERIFY(model().is_modified());
  }
};

}  // namespace

class StartTest : public QObject {
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
  QString path(const QString& name) const { return folder_.filePath(name); }
  User user() const { return {*window_}; }
  /// The demo case under a name of its own, with a face that is quick to compute.
  QString demo_case(const QString& name) const;
  QString recovery_root() const { return Recovery::default_root(); }
  QStringList kept() const {
    return QDir(recovery_root()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
  }
  void crash_after_import() const;

  QTemporaryDir folder_;
  QString demo_, volume_;
  std::unique_ptr<MainWindow> window_;
};

void StartTest::initTestCase() {
  demo_ = path("a demo, übung");
  Progress progress;
  write_demo_case(1, demo_.toStdString(), progress);
  volume_ = path("small head.mha");
  write_small_volume(read_ct(demo_.toStdString() + "/ct", {}, progress), volume_.toStdString());
}

void StartTest::init() {
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  QApplication::setActiveWindow(window_.get());
}

void StartTest::cleanup() {
  window_.reset();
  QCOMPARE(kept(), QStringList());  // whoever closes as he should leaves nothing behind
}

QString StartTest::demo_case(const QString& name) const {
  SurgicalCase plan = read_case_file(demo_.toStdString() + "/case.json");
  plan.tissue.strain = Strain::small;
  plan.name = name.toStdString();
  const QString file = demo_ + "/" + name + ".gnathion.json";
  write_case_file(plan, file.toStdString());
  return file;
}

void StartTest::recentCasesAreListedAndForgotten() {
  const QString first = demo_case("first"), second = demo_case("second");
  user().open_case(first);
  user().open_case(second);
  user().open_case(first);
  QVERIFY(QFile::remove(second));
  window_ = std::make_unique<MainWindow>();  // the next start
  window_->show();
  auto* list = user().find<QListWidget>("recent_list");
  QVERIFY(list->isVisible());
  QVERIFY(list->item(0)->text().startsWith("first.gnathion.json"));
  QVERIFY(list->item(1)->text().startsWith("second.gnathion.json"));
  QVERIFY(list->item(1)->text().contains("moved or deleted"));
  list->setCurrentRow(1);
  QVERIFY(!user().find<QPushButton>("recent_open_button")->isEnabled());
  user().click("recent_forget_button");
  for (int row = 0; row < list->count(); ++row) {
    QVERIFY(!list->item(row)->text().startsWith("second"));
  }
  list->setCurrentRow(0);
  user().click("recent_open_button");
  user().wait();
  QCOMPARE(user().model().plan().name, std::string("first"));
  QCOMPARE(user().page(), QString("view_page"));
}

void StartTest::recentListClears() {
  user().open_case(demo_case("listed"));
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(user().find<QListWidget>("recent_list")->count() > 0);
  user().click("recent_clear_button");
  QCOMPARE(user().find<QListWidget>("recent_list")->count(), 0);
  QVERIFY(!user().find<QWidget>("recent_group")->isVisible());
  QVERIFY(!MainWindow().findChild<QWidget*>("recent_menu")->isEnabled());
}

void StartTest::demoSavesWithItsOwnImages() {
  const User user = this->user();
  const fs::path cache = path("cache").toStdString();
  user.model().open_demo_case(cache);
  user.wait();
  QVERIFY(!user.model().is_modified());
  user.model().set_motion({.forward_mm = 4});
  QVERIFY(user.model().is_modified());
  const QString file = path("mine.gnathion.json");
  user.trigger("save_action");
  user.answer("save_dialog", file);
  QVERIFY(!user.model().is_modified());
  const LoadedCase* loaded = &user.model().loaded();
  // The next build's first demo removes the cache; the saved case does not need it.
  fs::remove_all(cache);
  user.model().undo();
  QCOMPARE(&user.model().loaded(), loaded);  // nothing had to be computed anew
  user.model().redo();
  user.trigger("save_action");
  QVERIFY(!fs::exists(path("mine_images_2").toStdString()));  // copied once
  QVERIFY(fs::exists(path("mine_images/ct").toStdString()));
  user.open_case(file);
  QCOMPARE(user.model().motion(), (JawMotion{.forward_mm = 4}));
  QVERIFY(!user.model().loaded().anatomy->face.mesh.materials.empty());
  QVERIFY(!user.message_visible());
}

void StartTest::droppedCaseOpens() {
  const User user = this->user();
  QVERIFY(user.drop({demo_case("dropped")}, user.find<QLabel>("drop_label")));
  user.wait();
  QCOMPARE(user.model().plan().name, std::string("dropped"));
  // Also on the 3D view of an open case.
  QVERIFY(user.drop({demo_case("another")}, user.find<QWidget>("face_canvas")));
  user.wait();
  QCOMPARE(user.model().plan().name, std::string("another"));
  QMimeData text;
  text.setText("a letter");
  QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QApplication::sendEvent(window_->windowHandle(), &enter);
  QVERIFY(!enter.isAccepted());
}

void StartTest::droppedVolumeIsImported() {
  const User user = this->user();
  QVERIFY(user.drop(volume_));
  QVERIFY(user.model().is_working());
  user.wait();
  QVERIFY2(user.model().has_case(), qPrintable(user.message()));
  QCOMPARE(user.model().plan().ct.path, fs::path(volume_.toStdString()));
  QVERIFY(!user.model().has_segments());
  QVERIFY(user.model().is_modified());
  QVERIFY(user.model().file().empty());
  QCOMPARE(user.page(), QString("view_page"));
}

void StartTest::droppedFolderListsItsSeries() {
  const User user = this->user();
  QVERIFY(user.drop(demo_ + "/ct"));
  auto* dialog = user.open<QDialog>("series_dialog");
  QVERIFY(dialog != nullptr);
  QVERIFY(!user.model().is_working());
  auto* table = user.find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  Progress progress;
  const SeriesSummary series = list_series(demo_.toStdString() + "/ct", progress).at(0);
  QCOMPARE(table->item(0, 0)->text(), QString("CT"));
  QCOMPARE(table->item(0, 2)->text(), QString::number(series.slices));
  QCOMPARE(table->item(0, 3)->text(), QString("%1 × %2").arg(series.size.x()).arg(series.size.y()));
  QVERIFY(table->item(0, 5)->text().contains("can be imported"));
  QVERIFY(user.find<QPushButton>("series_import_button")->isEnabled());  // the only one: chosen
  user.click("series_import_button");
  user.wait();
  QVERIFY2(user.model().has_case(), qPrintable(user.message()));
  QCOMPARE(user.model().plan().ct.series_uid, std::optional(series.uid));
  QVERIFY(user.open<QDialog>("series_dialog") == nullptr);
}

void StartTest::descriptionsAreShownWhenAsked() {
  const User user = this->user();
  QVERIFY(user.drop(demo_ + "/ct"));
  auto* table = user.find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  Progress progress;
  const SeriesSummary series = list_series(demo_.toStdString() + "/ct", progress).at(0);
  const QString description = QString::fromStdString(series.description);
  QVERIFY(!description.isEmpty());
  QVERIFY(!table->item(0, 1)->text().contains(description));
  auto* box = user.find<QCheckBox>("show_descriptions_box");
  QVERIFY(!box->isChecked());
  box->click();
  QCOMPARE(table->item(0, 1)->text(), description);
  box->click();
  QVERIFY(!table->item(0, 1)->text().contains(description));
  user.click("series_cancel_button");
  QVERIFY(!user.model().is_working());
  QVERIFY(!user.model().has_case());
}

void StartTest::listingCanBeCancelled() {
  const User user = this->user();
  QVERIFY(user.drop(demo_ + "/ct"));
  user.click("series_cancel_button");
  QTest::qWait(200);
  QVERIFY(user.open<QDialog>("series_dialog") == nullptr);
  QVERIFY(!user.message_visible());
  // The window may close while a folder is read.
  QVERIFY(user.drop(demo_ + "/ct"));
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
  const User user = this->user();
  QVERIFY(user.drop(mr));
  auto* table = user.find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  QCOMPARE(table->item(0, 0)->text(), QString("MR"));
  QVERIFY(table->item(0, 5)->text().contains("not a CT"));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                    table->visualItemRect(table->item(0, 0)).center());
  QVERIFY(!user.find<QPushButton>("series_import_button")->isEnabled());
  QVERIFY(user.find<QLabel>("series_stage")->text().contains("None"));
  user.click("series_cancel_button");
}

void StartTest::brokenFolderLeavesTheOpenCase() {
  const User user = this->user();
  user.open_case(demo_case("open"));
  const LoadedCase* loaded = &user.model().loaded();
  const QString empty = path("no images here");
  QVERIFY(QDir().mkpath(empty));
  write_text_file(empty.toStdString() + "/letter.txt", "no image");
  QVERIFY(user.drop(empty));
  QTRY_VERIFY_WITH_TIMEOUT(user.message_visible(), patience);
  QVERIFY2(user.message().contains("no images here"), qPrintable(user.message()));
  QVERIFY(user.open<QDialog>("series_dialog") == nullptr);
  // A series with a slice missing is found when it is read.
  const QString gap = path("gap");
  fs::copy(demo_.toStdString() + "/ct", gap.toStdString());
  auto middle = QDir(gap).entryList(QDir::Files).at(40);
  QVERIFY(QFile::remove(gap + "/" + middle));
  user.find<QWidget>("message_bar")->hide();
  QVERIFY(user.drop(gap));
  auto* table = user.find<QTableWidget>("series_table");
  QTRY_COMPARE_WITH_TIMEOUT(table->rowCount(), 1, patience);
  user.click("series_import_button");
  user.wait();
  QVERIFY(user.message_visible());
  QVERIFY2(user.message().contains("missing"), qPrintable(user.message()));
  QCOMPARE(&user.model().loaded(), loaded);
}

void StartTest::unknownFilesAreRefused() {
  const User user = this->user();
  const QString letter = path("letter.docx");
  write_text_file(letter.toStdString(), "a letter");
  QVERIFY(user.drop(letter));
  QVERIFY(user.message_visible());
  QVERIFY2(user.message().contains("letter.docx"), qPrintable(user.message()));
  QVERIFY(user.message().contains(".nii.gz"));
  user.find<QWidget>("message_bar")->hide();
  QVERIFY(user.drop({letter, volume_}, user.find<QWidget>("pages")));
  QVERIFY(user.message_visible());
  QVERIFY(user.message().contains("one"));
  QVERIFY(!user.model().is_working());
}

void StartTest::photographNeedsACase() {
  const User user = this->user();
  QVERIFY(user.drop(demo_ + "/photograph/face.obj"));
  QVERIFY(user.message_visible());
  QVERIFY2(user.message().contains("open a case or import a CT first"), qPrintable(user.message()));
  QVERIFY(user.open<QDialog>("photograph_dialog") == nullptr);
}

void StartTest::photographIsAddedWhenUnitAndFrameAreStated() {
  const User user = this->user();
  QVERIFY(user.drop(volume_));
  user.wait();
  QVERIFY(user.model().has_case());
  // The CT's own skin in centimetres.
  const Face skin = user.model().loaded().anatomy->face;
  QVERIFY(!skin.is_photograph);
  skin.document.write(folder_.path().toStdString(), "face_cm.obj", skin.mesh.surface.vertices / 10);
  QVERIFY(user.drop(path("face_cm.obj")));
  auto* add = user.find<QPushButton>("photograph_add_button");
  auto* unit = user.find<QComboBox>("photograph_unit_box");
  QVERIFY(!add->isEnabled());  // nothing is assumed
  unit->setCurrentIndex(2);
  QVERIFY(!add->isEnabled());
  user.find<QRadioButton>("photograph_on_ct_button")->click();
  QVERIFY(add->isEnabled());
  unit->setCurrentIndex(0);
  QVERIFY(!add->isEnabled());
  unit->setCurrentIndex(2);
  add->click();
  user.wait();
  QVERIFY2(!user.message_visible(), qPrintable(user.message()));
  const Face& face = user.model().loaded().anatomy->face;
  QVERIFY(face.is_photograph);
  QCOMPARE(user.model().plan().photograph->lps_from_photograph.scale, 10.0);
  QVERIFY((face.mesh.surface.vertices - skin.mesh.surface.vertices).cwiseAbs().maxCoeff() < 1e-3);
  QCOMPARE(user.find<QAction>("undo_action")->text(), QString("&Undo: Add the photograph"));
  user.trigger("undo_action");
  user.wait();
  QVERIFY(!user.model().loaded().anatomy->face.is_photograph);
}

void StartTest::changesAreSavedBeforeAnotherCase() {
  const User user = this->user();
  const QString first = demo_case("first to save"), second = demo_case("second to open");
  user.open_case(first);
  user.change();
  QVERIFY(window_->isWindowModified());
  QVERIFY(user.drop(second));
  QVERIFY(!user.model().is_working());
  QVERIFY(user.open<QMessageBox>("unsaved_box") != nullptr);
  user.click("unsaved_save_button");
  user.wait();
  QCOMPARE(user.model().plan().name, std::string("second to open"));
  QVERIFY(!window_->isWindowModified());
  QCOMPARE(read_case_file(first.toStdString()).name, std::string("first to save changed"));
}

void StartTest::changesAreDiscardedWhenAsked() {
  const User user = this->user();
  const QString first = demo_case("first to discard"), second = demo_case("second to open");
  user.open_case(first);
  user.change();
  QVERIFY(user.drop(second));
  user.click("unsaved_discard_button");
  user.wait();
  QCOMPARE(user.model().plan().name, std::string("second to open"));
  QCOMPARE(read_case_file(first.toStdString()).name, std::string("first to discard"));
}

void StartTest::cancelKeepsTheCase() {
  const User user = this->user();
  const QString first = demo_case("first to keep"), second = demo_case("second not to open");
  user.open_case(first);
  user.change();
  for (const bool with_escape : {false, true}) {
    QVERIFY(user.drop(second));
    auto* box = user.open<QMessageBox>("unsaved_box");
    QVERIFY(box != nullptr);
    if (with_escape) {
      QTest::keyClick(box, Qt::Key_Escape);
    } else {
      user.click("unsaved_cancel_button");
    }
    QTRY_VERIFY(user.open<QMessageBox>("unsaved_box") == nullptr);
    QTest::qWait(20);
    QVERIFY(!user.model().is_working());
    QCOMPARE(user.model().plan().name, std::string("first to keep changed"));
    QVERIFY(user.model().is_modified());
  }
  QCOMPARE(read_case_file(first.toStdString()).name, std::string("first to keep"));
}

void StartTest::closingAsksToo() {
  const User user = this->user();
  const QString file = demo_case("to close");
  user.open_case(file);
  user.change();
  window_->close();
  QVERIFY(window_->isVisible());
  user.click("unsaved_cancel_button");
  QTest::qWait(20);
  QVERIFY(window_->isVisible());
  window_->close();
  user.click("unsaved_save_button");
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(read_case_file(file.toStdString()).name, std::string("to close changed"));
  window_ = std::make_unique<MainWindow>();
  window_->show();
  this->user().open_case(file);
  this->user().change();
  window_->close();
  this->user().click("unsaved_discard_button");
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(read_case_file(file.toStdString()).name, std::string("to close changed"));
}

void StartTest::saveWithoutAFileAsksForOne() {
  const User user = this->user();
  QVERIFY(user.drop(volume_));
  user.wait();
  const QString other = demo_case("other");
  // Cancelling the dialog, or a place that cannot be written, opens nothing.
  QVERIFY(user.drop(other));
  user.click("unsaved_save_button");
  QVERIFY(user.open<QFileDialog>("save_dialog") != nullptr);
  user.find<QFileDialog>("save_dialog")->reject();
  QTRY_VERIFY(user.open<QFileDialog>("save_dialog") == nullptr);
  QVERIFY(!user.model().is_working());
  QTRY_VERIFY(window_->findChild<QFileDialog*>("save_dialog") == nullptr);
  user.model().save_case(path("no such folder/case.json").toStdString());
  QVERIFY(user.message_visible());
  QVERIFY(user.model().is_modified());
  // A save that has nothing to do with the question must not open what was wanted then.
  const fs::path own = path("own.json").toStdString();
  user.model().save_case(own);
  QVERIFY(!user.model().is_working());
  QVERIFY(!user.model().is_modified());
  QCOMPARE(user.model().file(), own);
}

void StartTest::themeChangesTheColours() {
  const auto lightness = [this] { return window_->palette().color(QPalette::Window).lightness(); };
  user().trigger("dark_theme_action");
  QVERIFY(lightness() < 90);
  QVERIFY(warning_colour(window_->palette()).lightness() > 150);
  QCOMPARE(chosen_theme(), Theme::dark);
  QVERIFY(MainWindow().findChild<QAction*>("dark_theme_action")->isChecked());
  user().trigger("light_theme_action");
  QVERIFY(lightness() > 200);
  QVERIFY(warning_colour(window_->palette()).lightness() < 110);
  user().trigger("system_theme_action");
  QCOMPARE(chosen_theme(), Theme::system);
}

void StartTest::changesAreKeptAndRemoved() {
  const User user = this->user();
  const QString file = demo_case("kept");
  user.open_case(file);
  QTest::qWait(2500);
  QCOMPARE(kept(), QStringList());  // nothing to lose
  user.change();
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
  user.trigger("save_action");
  QTRY_COMPARE(kept(), QStringList());
  user.change();
  user.trigger("undo_action");
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
  window_ = std::make_unique<MainWindow>();
  window_->show();
  auto* list = user().find<QListWidget>("left_behind_list");
  QVERIFY(user().find<QWidget>("left_behind_group")->isVisible());
  QCOMPARE(list->count(), 1);
  QVERIFY2(list->item(0)->text().contains("was not saved yet"), qPrintable(list->item(0)->text()));
  user().click("recover_button");
  user().wait();
  QVERIFY2(user().model().has_case(), qPrintable(user().message()));
  QCOMPARE(user().model().plan().ct.path, fs::path(volume_.toStdString()));
  QVERIFY(user().model().is_modified());
  QVERIFY(user().model().file().empty());
  // The old copy goes when this window has one of its own.
  QTRY_COMPARE_WITH_TIMEOUT(list->count(), 0, 10000);
  QCOMPARE(kept().size(), 1);
  user().model().save_case(path("recovered.json").toStdString());
  QTRY_COMPARE(kept(), QStringList());
}

void StartTest::leftBehindCanBeDiscarded() {
  crash_after_import();
  // A copy that cannot be read: the message says so, and it stays to be discarded.
  const QString copy = recovery_root() + "/" + kept().at(0) + "/1/case.json";
  write_text_file(copy.toStdString(), "{\"gnathion_case\": 1, \"ct\": {");
  window_ = std::make_unique<MainWindow>();
  window_->show();
  user().click("recover_button");
  user().wait();
  QVERIFY(user().message_visible());
  QVERIFY(!user().model().has_case());
  QCOMPARE(kept().size(), 1);
  user().click("discard_button");
  QCOMPARE(kept(), QStringList());
  QVERIFY(!user().find<QWidget>("left_behind_group")->isVisible());
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  QCoreApplication::setApplicationName("gnathion");
  const QTemporaryDir home;  // nothing of the user's own is read or written
  for (const char* folder : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
    qputenv(folder, home.filePath(folder).toLocal8Bit());
  }
  const QString problem = gnathion::display_problem();
  if (!problem.isEmpty()) qFatal("%s", qPrintable(problem));
  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  gnathion::use_c_numbers();
  gnathion::start_theme();
  gnathion::test::StartTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "start_test.moc"
