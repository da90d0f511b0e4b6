// A user without a plan: random clicks, keys, numbers and drags on everything that can be seen,
// from a fixed seed. Nothing may crash, no state may be invalid, and in the end the case can still
// be saved and read back. Arguments of the form seed=N, actions=N change the defaults, case=FOLDER
// takes the demo case that is there; GNATHION_TELL in the environment tells each action.
#include <QComboBox>
#include <QDialog>
#include <QMenu>
#include <QSignalSpy>
#include <QSlider>
#include <map>
#include <random>
#include <vector>

#include "app/driven_window.h"

#ifdef __SANITIZE_ADDRESS__
/// What stays loaded has a name in the report of leaks, by which others' can be told from ours.
extern "C" int dlclose(void* /*library*/) {
  return 0;
}
#endif

namespace gnathion::test {
namespace {

int actions = 500;
unsigned seed = 20161122;
QString demo_case;  ///< the folder; empty: it is made

/// Does one random thing after another to a window.
class Monkey {
 public:
  Monkey(MainWindow& window, unsigned first) : window_(window), user_(window), random_(first) {}

  /// What was done, for the message of a failure.
  QString act() {
    if (QWidget* dialog = QApplication::activeModalWidget()) return dismiss(dialog);
    switch (below(10)) {
      case 0:
      case 1:
        return trigger();
      case 2:
      case 3:
        return drag_in_view();
      case 4:
        return wheel();
      case 5:
        return key();
      default:
        return use_widget();
    }
  }

 private:
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  template <typename T>
  T* any(const QList<T*>& all) {
    return all.isEmpty() ? nullptr : all[below(all.size())];
  }

  static QString dismiss(QWidget* dialog) {
    const QString name = dialog->objectName();
    QTest::keyClick(dialog, Qt::Key_Escape);
    return "Escape in " + name;
  }

  /// Menu entries and tools, but those that end the window or replace its case.
  QString trigger() {
    static const QStringList left_out{"quit_action", "demo_action"};
    QList<QAction*> all;
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->isEnabled() && !action->isSeparator() && !action->menu() &&
          !action->objectName().isEmpty() && !left_out.contains(action->objectName()) &&
          !action->objectName().startsWith("recent")) {
        all << action;
      }
    }
    QAction* action = any(all);
    if (action == nullptr) return "no action";
    // Some go with what they close.
    const QString name = action->objectName();
    action->trigger();
    return "action " + name;
  }

  QPoint place_in(const QWidget* widget) {
    return {below(std::max(widget->width(), 1)), below(std::max(widget->height(), 1))};
  }

  QString drag_in_view() {
    QWidget* canvas = window_.face_view().canvas();
    if (!canvas->isVisible()) return "no canvas";
    const Qt::MouseButton button = below(4) == 0 ? Qt::RightButton : Qt::LeftButton;
    const Qt::KeyboardModifiers keys = below(4) == 0 ? Qt::ShiftModifier : Qt::NoModifier;
    const QPoint from = place_in(canvas), to = place_in(canvas);
    user_.drag(from, to, {.button = button, .keys = keys});
    return QString("drag from %1,%2 to %3,%4").arg(from.x()).arg(from.y()).arg(to.x()).arg(to.y());
  }

  QString wheel() {
    QWidget* over = any(visible<QWidget>());
    if (over == nullptr) return "nothing to scroll";
    const QString name = over->objectName();
    user_.wheel(over, place_in(over), below(2) == 0 ? 1 : -1);
    return "wheel over " + name;
  }

  QString key() {
    static const QList<Qt::Key> keys{Qt::Key_Tab, Qt::Key_R,  Qt::Key_X,    Qt::Key_Up,
                                     Qt::Key_1,   Qt::Key_3,  Qt::Key_7,    Qt::Key_Down,
                                     Qt::Key_Y,   Qt::Key_Z,  Qt::Key_Left, Qt::Key_Escape,
                                     Qt::Key_F1,  Qt::Key_F6, Qt::Key_Space};
    const Qt::Key pressed = keys[below(keys.size())];
    QWidget* to = QApplication::focusWidget();
    if (to == nullptr || !window_.isAncestorOf(to)) to = &window_;
    const QString name = to->objectName();
    QTest::keyClick(to, pressed, below(5) == 0 ? Qt::ControlModifier : Qt::NoModifier);
    return QString("key %1 in %2").arg(pressed).arg(name);
  }

  /// With a name: those without are the tools of actions, and Qt's own. Mostly of the step's page.
  template <typename T>
  QList<T*> visible() {
    const auto* steps = window_.findChild<QTabWidget*>("steps");
    const QWidget* scope = below(4) == 0 ? &window_ : steps->currentWidget();
    QList<T*> all;
    for (T* widget : scope->findChildren<T*>()) {
      const bool named = !widget->objectName().isEmpty() && !widget->objectName().startsWith("qt_");
      if (named && widget->isVisible() && widget->isEnabled()) all << widget;
    }
    return all;
  }

  QString use_widget() {
    switch (below(5)) {
      case 0:
        if (auto* steps = window_.findChild<QTabWidget*>("steps"); steps->isVisible()) {
          steps->setCurrentIndex(below(steps->count()));
          return "step " + steps->currentWidget()->objectName();
        }
        break;
      case 1:
        if (auto* box = any(visible<QAbstractSpinBox>())) {
          const QString name = box->objectName();
          box->setFocus();
          box->selectAll();
          QTest::keyClicks(box, QString::number(below(600) / 10.0 - 30, 'f', 1));
          QTest::keyClick(box, Qt::Key_Return);
          return "number in " + name;
        }
        break;
      case 2:
        if (auto* slider = any(visible<QSlider>())) {
          const QString name = slider->objectName();
          slider->setValue(slider->minimum() + below(slider->maximum() - slider->minimum() + 1));
          return "slider " + name;
        }
        break;
      case 3:
        if (auto* box = any(visible<QComboBox>()); box != nullptr && box->count() > 0) {
          const QString name = box->objectName();
          box->setCurrentIndex(below(box->count()));
          return "choice in " + name;
        }
        break;
      default:
        break;
    }
    auto* button = any(visible<QAbstractButton>());
    if (button == nullptr) return "no button";
    // Not by the mouse: a button with a menu would wait for an answer within its press.
    const QString name = button->objectName();
    button->click();
    return "button " + name;
  }

  MainWindow& window_;
  User user_;
  std::mt19937 random_;
};

/// What must hold whatever was done; empty when it does.
QString broken(const CaseController& model) {
  if (!model.has_case()) return "the case is gone";
  const LoadedCase& loaded = model.loaded();
  const std::size_t segments = loaded.anatomy->segments.size();
  if (model.motions().size() != segments) return "not one motion a segment";
  if (segments > 0 && model.active_segment() >= segments) return "no such active segment";
  if (model.response().poses.size() != segments) return "not one pose a segment";
  const Points& face = model.response().face;
  if (face.rows() != loaded.anatomy->face.mesh.surface.vertices.rows()) return "another face";
  if (!face.allFinite()) return "the face is not finite";
  for (const JawMotion& motion : model.motions()) {
    for (const double shift : {motion.forward_mm, motion.up_mm, motion.left_mm}) {
      if (!(std::abs(shift) <= largest_shift_mm)) return "a motion beyond its limit";
    }
  }
  const PlanHistory& history = model.history();
  if (history.position() >= history.steps().size()) return "no such step";
  if ((model.refinement() == Refinement::done) != (model.refined() != nullptr)) {
    return "refined and not refined";
  }
  return {};
}

/// How often each kind of action was done, the kind being its first word.
std::map<QString, int> kinds(const QStringList& done) {
  std::map<QString, int> count;
  for (const QString& action : done) ++count[action.section(' ', 0, 0)];
  return count;
}

}  // namespace

class RandomActionsTest : public QObject, private DrivenWindow {
  Q_OBJECT
 private slots:
  void initTestCase();
  void nothingBreaks();
  void caseIsStillWhole();
  void cleanupTestCase() { window_.reset(); }
};

void RandomActionsTest::initTestCase() {
  if (demo_case.isEmpty()) {
    make_demo();
  } else {
    std::filesystem::copy(demo_case.toStdString(), demo_.toStdString(),
                          std::filesystem::copy_options::recursive);
  }
  start_window();
  open(changed_case("random.json", [](SurgicalCase& plan) {
    plan.tissue.elements = Elements::automatic;  // a drag gets sharper when it rests
  }));
  QVERIFY(model().has_model());
}

void RandomActionsTest::nothingBreaks() {
  Monkey monkey(*window_, seed);
  QStringList done;
  for (int i = 0; i < actions; ++i) {
    done << monkey.act();
    if (qEnvironmentVariableIsSet("GNATHION_TELL")) qInfo("%s", qPrintable(done.last()));
    QTest::qWait(i % 10 == 0 ? 120 : 5);
    if (!window_->isVisible()) window_->show();
    const QString problem = broken(model());
    QVERIFY2(problem.isEmpty(),
             qPrintable(problem + " after " + QStringList(done.mid(done.size() - 12)).join(", ")));
  }
  QStringList told;
  for (const auto& [kind, count] : kinds(done)) told << QString("%1 %2").arg(count).arg(kind);
  qInfo("%d actions: %s; %zu steps in the history", actions, qPrintable(told.join(", ")),
        model().history().steps().size());
  if (actions < 200) return;
  for (const char* kind :
       {"action", "button", "choice", "drag", "key", "number", "slider", "step", "wheel"}) {
    QVERIFY2(kinds(done)[kind] > 2, kind);
  }
}

void RandomActionsTest::caseIsStillWhole() {
  while (QWidget* dialog = QApplication::activeModalWidget()) {
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTest::qWait(50);
  }
  settle();
  const QSignalSpy saved(&model(), &CaseController::saved);
  const std::filesystem::path copy = path("after.json").toStdString();
  model().save_case(copy);
  QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, patience);
  QVERIFY(read_case_history(copy).plan() == model().plan());
}

}  // namespace gnathion::test

int main(int argc, char** argv) {
  std::vector<char*> rest;
  for (int i = 0; i < argc; ++i) {
    const QString word = argv[i];
    const QString value = word.section('=', 1);
    if (word.startsWith("seed=")) {
      gnathion::test::seed = value.toUInt();
    } else if (word.startsWith("actions=")) {
      gnathion::test::actions = value.toInt();
    } else if (word.startsWith("case=")) {
      gnathion::test::demo_case = value;
    } else {
      rest.push_back(argv[i]);
    }
  }
  return gnathion::test::run<gnathion::test::RandomActionsTest>(static_cast<int>(rest.size()),
                                                                rest.data());
}

#include "random_actions_test.moc"
