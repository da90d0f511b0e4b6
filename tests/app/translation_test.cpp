#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QOpenGLWidget>
#include <QPainter>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStandardPaths>
#include <QTabBar>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QXmlStreamReader>
#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "app/core_words.h"
#include "app/display.h"
#include "app/language.h"
#include "app/loaded_case.h"
#include "app/main_window.h"
#include "app/photograph_dialog.h"
#include "app/series_dialog.h"
#include "app/tissue_dialog.h"
#include "app/turntable_dialog.h"

Q_DECLARE_METATYPE(gnathion::Language)

/// Qt asks that this be outside any namespace.
static void add_resources() {
  Q_INIT_RESOURCE(gnathion);
}

namespace gnathion::test {
namespace {

constexpr int patience = 120000;  // ms, for opening a case

// --- the file of translations -------------------------------------------------------------------

struct Message {
  QString context;
  QString source;
  QStringList translations;  ///< several where a number decides
  QString state;             ///< "unfinished", "vanished" …; empty: finished
  QString name() const { return context + ": " + source; }
};

QString beside_tests(const char* path) {
  const QString found = QFINDTESTDATA(QString("../../") + path);
  if (found.isEmpty()) qFatal("%s is not beside the tests", path);
  return found;
}

/// The texts of an element with forms for numbers, or its own.
QStringList forms_of(QXmlStreamReader& xml) {
  QStringList forms;
  QString own;
  while (xml.readNext() != QXmlStreamReader::EndElement) {
    if (xml.isStartElement()) forms << xml.readElementText();
    if (xml.isCharacters()) own += xml.text();
    if (xml.hasError()) qFatal("%s", qPrintable(xml.errorString()));
  }
  return forms.isEmpty() ? QStringList{own} : forms;
}

std::vector<Message> messages_of(const QString& ts) {
  QFile file(ts);
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s cannot be read", qPrintable(ts));
  QXmlStreamReader xml(&file);
  std::vector<Message> messages;
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == "name") context = xml.readElementText();
    if (xml.name() == "message") messages.push_back({context, {}, {}, {}});
    if (xml.name() == "source") messages.back().source = xml.readElementText();
    if (xml.name() == "translation") {
      messages.back().state = xml.attributes().value("type").toString();
      messages.back().translations = forms_of(xml);
    }
  }
  if (xml.hasError()) qFatal("%s", qPrintable(xml.errorString()));
  return messages;
}

std::vector<Message> german() {
  return messages_of(beside_tests("resources/translations/gnathion_de.ts"));
}

/// All that a pattern finds, sorted.
QStringList found_in(const QString& text, const char* pattern) {
  QStringList found;
  QRegularExpressionMatchIterator i = QRegularExpression(pattern).globalMatch(text);
  while (i.hasNext()) found << i.next().captured();
  found.sort();
  return found;
}

bool has_letters(const QString& text) {
  return std::any_of(text.begin(), text.end(), [](QChar c) { return c.isLetter(); });
}

/// All source files below a folder, string literals that follow each other joined.
QString sources_in(const char* folder) {
  QString all;
  QDirIterator files(beside_tests(folder), {"*.cpp", "*.h"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    if (files.next().endsWith("/core_words.cpp")) continue;
    QFile file(files.filePath());
    if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(files.filePath()));
    all += QString::fromUtf8(file.readAll());
  }
  return all.replace(QRegularExpression("\"\\s*\\n\\s*\""), "").replace("\\\"", "\"");
}

/// How many of the words stand in the sources, the longest run of them in one place.
int longest_run(const QStringList& words, const QString& sources) {
  int longest = 0;
  for (int first = 0; first < words.size(); ++first) {
    int count = longest + 1;
    while (first + count <= words.size() &&
           sources.contains(QStringList(words.mid(first, count)).join(' '))) {
      longest = count++;
    }
  }
  return longest;
}

// --- the window ---------------------------------------------------------------------------------

void speak(Language language) {
  choose_language(language);
  start_language();
}

/// Opens the demo case in a new window of 1280×800.
std::unique_ptr<MainWindow> opened_window() {
  static const std::filesystem::path demo = [] {
    Progress progress;
    return cached_demo_case(GNATHION_TEST_CACHE, GNATHION_PROGRAM, progress);
  }();
  auto window = std::make_unique<MainWindow>();
  window->resize(1280, 800);
  window->show();
  if (!QTest::qWaitForWindowExposed(window.get())) qFatal("the window does not show");
  window->open_case(QString::fromStdString((demo / "case.json").string()));
  [&] { QTRY_VERIFY_WITH_TIMEOUT(!window->controller().is_working(), patience); }();
  if (!window->controller().has_model()) qFatal("the demo case did not open");
  return window;
}

QTabWidget* steps_of(const QWidget& window) {
  return window.findChild<QTabWidget*>("steps");
}

/// What stands on a widget; empty where it says nothing of its own.
QString text_of(const QWidget& widget) {
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* group = qobject_cast<const QGroupBox*>(&widget)) return group->title();
  return {};
}

/// Those of the widget's children that a letter with Alt reaches: the letter, and who it is.
std::multimap<QString, QString> mnemonics_in(const QWidget& parent) {
  std::multimap<QString, QString> found;
  for (const QWidget* widget : parent.findChildren<QWidget*>()) {
    const auto* label = qobject_cast<const QLabel*>(widget);
    if (label != nullptr && label->buddy() == nullptr) continue;
    if (widget->window() != parent.window()) continue;
    const QKeySequence key = QKeySequence::mnemonic(text_of(*widget));
    if (!key.isEmpty()) found.emplace(key.toString(), text_of(*widget));
  }
  return found;
}

std::multimap<QString, QString> mnemonics_of(const QStringList& texts) {
  std::multimap<QString, QString> found;
  for (const QString& text : texts) {
    const QKeySequence key = QKeySequence::mnemonic(text);
    if (!key.isEmpty()) found.emplace(key.toString(), text);
  }
  return found;
}

/// "Alt+E: Edit, Level" for each letter that several share.
QStringList clashes(const std::multimap<QString, QString>& mnemonics) {
  QStringList said;
  for (auto i = mnemonics.begin(); i != mnemonics.end(); i = mnemonics.upper_bound(i->first)) {
    if (mnemonics.count(i->first) < 2) continue;
    QStringList who;
    for (auto j = i; j != mnemonics.upper_bound(i->first); ++j) who << j->second;
    said << i->first + ": " + who.join(", ");
  }
  return said;
}

QStringList tab_texts(const QTabWidget& steps) {
  QStringList texts;
  for (int i = 0; i < steps.count(); ++i) texts << steps.tabText(i);
  return texts;
}

QStringList action_texts(const QList<QAction*>& actions) {
  QStringList texts;
  for (const QAction* action : actions) texts << action->text();
  return texts;
}

/// Every text and tooltip of the window and of its actions, by who says it.
std::map<QString, QString> words_of(const MainWindow& window) {
  std::map<QString, QString> words;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (widget->objectName().isEmpty() || widget->objectName().startsWith("qt_")) continue;
    words[widget->objectName()] = text_of(*widget);
    words[widget->objectName() + " tip"] = widget->toolTip();
  }
  for (const QAction* action : window.findChildren<QAction*>()) {
    if (action->objectName().isEmpty()) continue;
    words[action->objectName()] = action->text();
    words[action->objectName() + " tip"] = action->toolTip();
  }
  const QStringList tabs = tab_texts(*steps_of(window));
  for (int i = 0; i < tabs.size(); ++i) words["tab " + QString::number(i)] = tabs[i];
  return words;
}

/// Whether what stands on a widget needs more room than it has.
bool is_clipped(const QWidget& widget) {
  const auto* label = qobject_cast<const QLabel*>(&widget);
  if (label != nullptr && (label->wordWrap() || label->text().isEmpty())) return false;
  if (qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr) {
    return widget.minimumSizeHint().width() > widget.width();
  }
  const bool says_something = label != nullptr ||
                              qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
                              qobject_cast<const QComboBox*>(&widget) != nullptr;
  return says_something && widget.sizeHint().width() > widget.width();
}

/// Of a page that is seen: the names of those that are clipped, and the page where it is too wide.
QStringList clipped_in(const QWidget& page) {
  QStringList names;
  for (const QWidget* widget : page.findChildren<QWidget*>()) {
    if (widget->objectName().startsWith("qt_") || !widget->isVisibleTo(&page)) continue;
    if (is_clipped(*widget)) {
      names << QString("%1 (“%2”: %3 of %4 pixels)")
                   .arg(widget->objectName(), text_of(*widget))
                   .arg(widget->width())
                   .arg(widget->sizeHint().width());
    }
  }
  for (const QScrollArea* area : page.findChildren<QScrollArea*>()) {
    const int wide = area->widget()->width(), room = area->viewport()->width();
    if (wide > room) names << QString("%1: %2 of %3").arg(area->objectName()).arg(room).arg(wide);
  }
  return names;
}

/// Inputs that Tab should reach.
bool takes_tab(const QWidget& widget) {
  return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.isEnabled() && widget.isVisible() &&
         widget.focusProxy() == nullptr;
}

/// The name of an input; of buttons that exclude each other, of them all: Tab reaches one, and the
/// arrow keys the others.
QString input_name(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool one_of_many = button != nullptr && button->autoExclusive();
  return one_of_many ? "one of " + widget.parentWidget()->objectName() : widget.objectName();
}

/// Whether b comes after a in the order in which one reads.
bool reads_on(const QWidget& page, const QWidget& a, const QWidget& b) {
  const QRect at_a(a.mapTo(&page, QPoint()), a.size()), at_b(b.mapTo(&page, QPoint()), b.size());
  const bool same_row = at_b.top() < at_a.center().y() && at_b.bottom() > at_a.center().y();
  return same_row ? at_b.left() > at_a.left() : at_b.center().y() > at_a.center().y();
}

/// A picture of the window into the folder $GNATHION_SHOTS, where that is set.
void shoot(MainWindow& window, const QString& name) {
  const QString folder = qEnvironmentVariable("GNATHION_SHOTS");
  if (folder.isEmpty()) return;
  QTRY_VERIFY_WITH_TIMEOUT(window.controller().refined() != nullptr, patience);
  QTest::qWait(500);
  QPixmap picture = window.grab();
  auto* canvas = window.findChild<QOpenGLWidget*>("face_canvas");
  QPainter(&picture).drawImage(QRect(canvas->mapTo(&window, QPoint()), canvas->size()),
                               canvas->grabFramebuffer());
  picture.save(folder + "/" + name + ".png");
}

}  // namespace

class TranslationTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { speak(Language::english); }

  void everyStringIsTranslated();
  void stringsAreThoseOfTheSources();
  void translationsKeepWhatIsFilledIn();
  void coreStillSaysWhatIsTranslated();
  void stagesAreTranslated();
  void coreWordsAreFilledIn();
  void mnemonicsAreUnique_data();
  void mnemonicsAreUnique();
  void mnemonicsOfDialogsAreUnique_data() { mnemonicsAreUnique_data(); }
  void mnemonicsOfDialogsAreUnique();
  void germanWindowSpeaksGerman();
  void languageIsRemembered();
  void nothingIsClipped_data() { mnemonicsAreUnique_data(); }
  void nothingIsClipped();
  void tabWalksThroughEachStep();
  void commaIsADecimalPoint();

 private:
  /// With the demo case, opened once.
  MainWindow& window_in(Language language) {
    speak(language);
    std::unique_ptr<MainWindow>& window = windows_[language];
    if (!window) window = opened_window();
    QApplication::setActiveWindow(window.get());  // what no window manager does here
    return *window;
  }

  std::map<Language, std::unique_ptr<MainWindow>> windows_;
};

void TranslationTest::everyStringIsTranslated() {
  const std::vector<Message> messages = german();
  QVERIFY(messages.size() > 500);
  for (const Message& message : messages) {
    QVERIFY2(message.state.isEmpty(), qPrintable(message.name() + " is " + message.state));
    for (const QString& text : message.translations) {
      QVERIFY2(!text.isEmpty(), qPrintable(message.name()));
    }
  }
}

/// `./run translate` was run after the last string was changed.
void TranslationTest::stringsAreThoseOfTheSources() {
  const QString lupdate = QStandardPaths::findExecutable("lupdate");
  QVERIFY2(!lupdate.isEmpty(), "lupdate is missing: install qttools5-dev-tools");
  const QTemporaryDir folder;
  const QString copy = folder.filePath("gnathion_de.ts");
  const QString src = beside_tests("src"), ui = beside_tests("ui");
  QCOMPARE(QProcess::execute(lupdate, {"-silent", "-no-obsolete", "-locations", "none", "-I", src,
                                       src + "/app", ui, "-ts", copy}),
           0);
  std::set<QString> now, then;
  for (const Message& message : messages_of(copy)) now.insert(message.name());
  for (const Message& message : german()) then.insert(message.name());
  QVERIFY(now.size() > 500);
  QStringList differing;
  std::set_symmetric_difference(now.begin(), now.end(), then.begin(), then.end(),
                                std::back_inserter(differing));
  QVERIFY2(differing.isEmpty(), qPrintable("run ./run translate: " + differing.join(" | ")));
}

void TranslationTest::translationsKeepWhatIsFilledIn() {
  for (const Message& message : german()) {
    for (const QString& text : message.translations) {
      for (const char* pattern : {"%L?[1-9n]", "<[^>]*>", "^ ", " $", "…$", "&(?=[^& ])"}) {
        QStringList wanted = found_in(message.source, pattern), found = found_in(text, pattern);
        wanted.removeAll("%n");  // "one point" needs no number
        found.removeAll("%n");
        QVERIFY2(found == wanted, qPrintable(message.name() + " → " + text));
      }
    }
  }
}

void TranslationTest::coreStillSaysWhatIsTranslated() {
  const QString sources = sources_in("src/core") + sources_in("src/app");
  int count = 0;
  for (const Message& message : german()) {
    if (message.context != "core") continue;
    ++count;
    QString plain = message.source;
    const QStringList words =
        plain.remove(QRegularExpression("%[1-9]")).split(' ', Qt::SkipEmptyParts);
    const QString key = QString(message.source).replace(' ', '_');
    const bool said = sources.contains('"' + key + '"') ||
                      longest_run(words, sources) >= std::clamp<int>(words.size() / 2, 1, 3);
    QVERIFY2(said, qPrintable(message.source));
  }
  QVERIFY(count > 100);
}

void TranslationTest::stagesAreTranslated() {
  std::set<QString> known;
  for (const Message& message : german()) {
    if (message.context == "core") known.insert(message.source);
  }
  const QString sources = sources_in("src/core") + sources_in("src/app");
  const QStringList stages = found_in(sources, "(?<=\\.stage\\(\")[^\"]*(?=\"\\))");
  QVERIFY(stages.size() > 30);
  for (const QString& stage : stages) QVERIFY2(known.count(stage) == 1, qPrintable(stage));
}

void TranslationTest::coreWordsAreFilledIn() {
  const QString english = "no such cut was found on this bone: the blade does not touch the bone";
  QCOMPARE(core_words(english), english);
  speak(Language::german);
  QCOMPARE(core_words(english),
           QString("ein solcher Schnitt wurde an diesem Knochen nicht gefunden: das Sägeblatt "
                   "berührt den Knochen nicht"));
  QCOMPARE(core_words(QString("holds no bone at 700 HU")),
           QString("enthält bei 700 HU keinen Knochen"));
  QCOMPARE(core_words(QString("/a/face.obj: line 3 is no vertex")),
           QString("/a/face.obj: line 3 is no vertex"));
}

void TranslationTest::mnemonicsAreUnique_data() {
  QTest::addColumn<Language>("language");
  QTest::newRow("English") << Language::english;
  QTest::newRow("German") << Language::german;
}

void TranslationTest::mnemonicsAreUnique() {
  QFETCH(Language, language);
  speak(language);
  const MainWindow window;
  const auto* bar = window.findChild<QMenuBar*>();
  const QStringList menus = action_texts(bar->actions());
  for (const QMenu* menu : bar->findChildren<QMenu*>()) {
    const QStringList shared = clashes(mnemonics_of(action_texts(menu->actions())));
    QVERIFY2(shared.isEmpty(), qPrintable(menu->title() + ": " + shared.join("; ")));
  }
  const QTabWidget& steps = *steps_of(window);
  QCOMPARE(steps.count(), 5);
  const QStringList outside = menus + tab_texts(steps);
  const auto clash_with_outside = [](std::multimap<QString, QString> all, const QWidget& page) {
    for (const auto& one : mnemonics_in(page)) all.insert(one);
    return clashes(all).join("; ");
  };
  QCOMPARE(clash_with_outside(mnemonics_of(menus), *window.findChild<QWidget*>("welcome_page")),
           QString());
  for (int i = 0; i < steps.count(); ++i) {
    QCOMPARE(clash_with_outside(mnemonics_of(outside), *steps.widget(i)), QString());
  }
  for (const QDialog* dialog : window.findChildren<QDialog*>()) {
    QCOMPARE(clashes(mnemonics_in(*dialog)).join("; "), QString());
  }
}

void TranslationTest::mnemonicsOfDialogsAreUnique() {
  QFETCH(Language, language);
  speak(language);
  Points face = Points::Zero(1, 3);
  const TissueDialog tissue((TissueModel()));
  const TurntableDialog turntable;
  const SeriesDialog series("no such folder");
  const PhotographDialog photograph("no such file.obj", face);
  for (const QDialog* dialog :
       std::initializer_list<const QDialog*>{&tissue, &turntable, &series, &photograph}) {
    QCOMPARE(clashes(mnemonics_in(*dialog)).join("; "), QString());
    QVERIFY2(!mnemonics_in(*dialog).empty(), qPrintable(dialog->windowTitle()));
  }
}

void TranslationTest::germanWindowSpeaksGerman() {
  std::set<QString> same;
  for (const Message& message : german()) {
    if (message.translations.contains(message.source)) same.insert(message.source);
  }
  same.insert({"&English", "&Deutsch"});
  const std::map<QString, QString> english = words_of(MainWindow());
  speak(Language::german);
  const MainWindow window;
  const std::map<QString, QString> found = words_of(window);
  QCOMPARE(found.size(), english.size());
  QVERIFY(found.size() > 400);
  for (const auto& [who, text] : found) {
    const QString& before = english.at(who);
    const bool differs = text != before || same.count(QString(text)) == 1 || !has_letters(text);
    QVERIFY2(differs, qPrintable(who + ": " + text));
  }
  QCOMPARE(found.at("chin_button"), QString("Ki&nn"));
  QCOMPARE(found.at("tab 0"), QString("&Foto"));
  // Qt's own words.
  QDialogButtonBox box(QDialogButtonBox::Cancel);
  QCOMPARE(box.button(QDialogButtonBox::Cancel)->text().remove('&'), QString("Abbrechen"));
}

void TranslationTest::languageIsRemembered() {
  const MainWindow window;
  const auto action = [](const MainWindow& of, const char* name) {
    return of.findChild<QAction*>(name);
  };
  QVERIFY(action(window, "english_action")->isChecked());
  action(window, "german_action")->trigger();
  QVERIFY(!window.findChild<QWidget*>("message_bar")->isHidden());
  QVERIFY(window.findChild<QLabel*>("message_text")->text().contains("started again"));
  QCOMPARE(chosen_language(), Language::german);
  start_language();
  const MainWindow next;
  QVERIFY(action(next, "german_action")->isChecked());
  QCOMPARE(next.findChild<QMenu*>("file_menu")->title(), QString("&Datei"));
  action(next, "system_language_action")->trigger();
  QCOMPARE(chosen_language(), Language::system);
}

void TranslationTest::nothingIsClipped() {
  QFETCH(Language, language);
  MainWindow& window = window_in(language);
  QTabWidget& steps = *steps_of(window);
  for (int i = 0; i < steps.count(); ++i) {
    steps.setCurrentIndex(i);
    // Also what is shown while a cut is placed.
    if (auto* cut = steps.widget(i)->findChild<QWidget*>("cut_group")) cut->show();
    auto* axis = steps.widget(i)->findChild<QWidget*>("axis_group");
    if (axis != nullptr) axis->show();
    QTest::qWait(50);
    QCOMPARE(clipped_in(*steps.widget(i)).join("; "), QString());
    // The views keep their room.
    const int least = steps.minimumSizeHint().width();
    QVERIFY2(least <= 385, qPrintable(QString::number(least)));
    if (axis != nullptr) axis->hide();
  }
  QCOMPARE(window.size(), QSize(1280, 800));
  for (const auto* bar : window.findChildren<QToolBar*>()) {
    auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
    QVERIFY2(more == nullptr || !more->isVisible(), qPrintable(bar->objectName()));
  }
  const QTabBar& tabs = *steps.tabBar();
  QVERIFY(tabs.tabRect(0).left() >= 0);
  QVERIFY(tabs.tabRect(tabs.count() - 1).right() < tabs.width());
  steps.setCurrentWidget(steps.findChild<QWidget*>("motion_page"));
  shoot(window, QString(QTest::currentDataTag()).toLower());
}

void TranslationTest::tabWalksThroughEachStep() {
  QTabWidget& steps = *steps_of(window_in(Language::english));
  for (int i = 0; i < steps.count(); ++i) {
    steps.setCurrentIndex(i);
    const QWidget& page = *steps.widget(i);
    QTest::qWait(20);
    std::set<QString> wanted, reached;
    std::set<const QWidget*> seen;
    for (const QWidget* widget : page.findChildren<QWidget*>()) {
      if (takes_tab(*widget)) wanted.insert(input_name(*widget));
    }
    QVERIFY(wanted.size() > 3);
    // From the tabs, with Tab, until it has left the page.
    steps.tabBar()->setFocus();
    const QWidget* last = nullptr;
    for (int presses = 0; presses < 100; ++presses) {
      QVERIFY(QApplication::focusWidget() != nullptr);
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      const QWidget* now = QApplication::focusWidget();
      if (!page.isAncestorOf(now)) break;
      QVERIFY2(seen.insert(now).second, qPrintable(now->objectName()));
      reached.insert(input_name(*now));
      const QString before = last == nullptr ? QString("the tabs") : last->objectName();
      QVERIFY2(last == nullptr || reads_on(page, *last, *now),
               qPrintable(before + " → " + now->objectName()));
      last = now;
    }
    QCOMPARE(QStringList(reached.begin(), reached.end()).join(" "),
             QStringList(wanted.begin(), wanted.end()).join(" "));
  }
}

void TranslationTest::commaIsADecimalPoint() {
  QDoubleSpinBox box;
  box.setRange(-30, 30);
  box.setDecimals(1);
  box.setSuffix(" mm");
  box.show();
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, "-1,5");
  QCOMPARE(box.value(), -1.5);
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  QCoreApplication::setApplicationName("gnathion");
  const QTemporaryDir settings;  // not the user's own
  qputenv("XDG_CONFIG_HOME", settings.path().toLocal8Bit());
  qputenv("XDG_DATA_HOME", settings.path().toLocal8Bit());
  const QString problem = gnathion::display_problem();
  if (!problem.isEmpty()) qFatal("%s", qPrintable(problem));
  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  add_resources();
  gnathion::use_c_numbers();
  gnathion::choose_language(gnathion::Language::english);
  gnathion::test::TranslationTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "translation_test.moc"
