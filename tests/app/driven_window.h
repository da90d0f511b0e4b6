#pragma once

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "app/display.h"
#include "app/loaded_case.h"
#include "app/theme.h"
#include "app/user.h"
#include "bone/cut_box.h"
#include "io/case_file.h"
#include "render/picture.h"

/// Qt asks that this be outside any namespace.
inline void add_resources() {
  Q_INIT_RESOURCE(gnathion);
}

namespace gnathion::test {

/// The demo case in a new folder. It is made once for each build of the program.
inline void copy_demo_case(const std::filesystem::path& folder) {
  Progress progress;
  std::filesystem::copy(cached_demo_case(GNATHION_TEST_CACHE, GNATHION_PROGRAM, progress), folder,
                        std::filesystem::copy_options::recursive);
}

/// The demo's jaw in two halves, left and right, not moved.
inline void cut_in_halves(SurgicalCase& plan) {
  BoxCut half = box_of(plan.segments[0].cut);
  const Eigen::Vector3d centre = half.centre;
  half.half_extents.x() = half.half_extents.x() / 2 - 0.25;
  plan.segments.assign(2, {});
  for (const std::size_t side : {0U, 1U}) {
    half.centre.x() = centre.x() + (side == 0 ? 1 : -1) * (half.half_extents.x() + 0.25);
    plan.segments[side].name = side == 0 ? "left" : "right";
    plan.segments[side].cut = half;
  }
}

/// How many pixels are of another colour, the frames' rounding aside; all, of another size.
inline int differing_pixels(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height) return std::max(a.width * a.height, 1);
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    if (std::abs(a.rgb[i] - b.rgb[i]) > 12 || std::abs(a.rgb[i + 1] - b.rgb[i + 1]) > 12) ++count;
  }
  return count;
}

/// What the tests of one program share: a window, the hands of its user, a folder with the demo
/// case.
class DrivenWindow : public User {
 protected:
  QString path(const QString& name) const { return folder_.filePath(name); }
  void make_demo() const { copy_demo_case(demo_.toStdString()); }
  /// The demo case changed, in a file beside it. Small strain on few linear elements, unless that
  /// is changed: an answer in less than a second.
  template <typename Change>
  QString changed_case(const QString& name, Change change) const {
    SurgicalCase plan = read_case_file(demo_.toStdString() + "/case.json");
    plan.tissue.strain = Strain::small;
    plan.tissue.elements = Elements::linear;
    plan.tissue.edge_mm = 4;
    change(plan);
    const QString file = demo_ + "/" + name;
    write_case_file(plan, file.toStdString());
    return file;
  }
  /// A new window in place of the last one, on the screen and in the hand.
  void start_window(QSize size = {1280, 800}) {
    window_ = std::make_unique<MainWindow>();
    take_hold_of(*window_);
    window_->resize(size);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    activate();
  }
  /// A display without window manager makes no window the active one, which shortcuts ask for.
  void activate() const { QApplication::setActiveWindow(window_.get()); }

  QTemporaryDir folder_;
  // Blanks and letters beyond ASCII are to be borne.
  const QString demo_ = folder_.filePath("a demo, übung");
  std::unique_ptr<MainWindow> window_;
};

/// A program of window tests. What it keeps lies in a folder of its own, not in the user's.
template <typename Test>
int run(int argc, char** argv) {
  QCoreApplication::setApplicationName("gnathion");
  const QTemporaryDir home;
  for (const char* folder : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
    qputenv(folder, home.filePath(folder).toLocal8Bit());
  }
  const QString problem = display_problem();
  if (!problem.isEmpty()) qFatal("%s", qPrintable(problem));
  prepare_graphics();
  QApplication app(argc, argv);
  use_c_numbers();
  start_theme();
  add_resources();
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace gnathion::test
