// Measures the window itself, on a display: `./run bench frames`.
//   gnathion-window-bench CASE.json
// Opens the case with a skin of some 100 000 triangles as its face, drags the segment's grip by the
// mouse in a 3D view of 1280×800, turns the camera, and prints a Markdown table of what a frame
// takes, and the longest that the window did not listen meanwhile.
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QMetaObject>
#include <QMouseEvent>
#include <QOpenGLWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "app/display.h"
#include "app/face_view.h"
#include "app/main_window.h"
#include "bench/timing.h"
#include "io/case_file.h"

/// Qt asks that this be outside any namespace.
static void add_resources() {
  Q_INIT_RESOURCE(gnathion);
}

namespace gnathion::bench {
namespace {

constexpr int kWidth = 1280, kHeight = 800, kFrames = 40;
constexpr int kPatience = 240000;  // ms, for work beside the window
constexpr double kEdge = 1.8;      // mm: a skin of some 100 000 triangles

/// Knows how long each event kept the window from listening to others.
class WatchedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  struct Longest {
    double s = 0;
    std::string what = "nothing";
  };

  bool notify(QObject* receiver, QEvent* event) override {
    if (within_) return QApplication::notify(receiver, event);
    within_ = true;
    // Afterwards the receiver may be gone.
    const std::string what = std::string(receiver->metaObject()->className()) + " " +
                             receiver->objectName().toStdString() + ", event " +
                             std::to_string(event->type());
    bool handled = false;
    const double s = seconds([&] { handled = QApplication::notify(receiver, event); });
    within_ = false;
    if (s > longest_.s) longest_ = {s, what};
    return handled;
  }

  /// Since it was asked last.
  Longest take_longest() { return std::exchange(longest_, {}); }

 private:
  bool within_ = false;
  Longest longest_;
};

/// The times of a frame, s: until the mouse event is done with, and until the picture is on the
/// screen. `drawn`: how often the scene was drawn for it, in the mean.
struct FrameTimes {
  std::vector<double> event, shown;
  double drawn = 0;
};

/// Counts how often a renderer draws while it lives.
class DrawCount {
 public:
  explicit DrawCount(vtkRenderer* renderer) : renderer_(renderer) {
    command_->SetClientData(&count_);
    command_->SetCallback(
        [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    renderer_->AddObserver(vtkCommand::StartEvent, command_);
  }
  ~DrawCount() { renderer_->RemoveObserver(command_); }
  DrawCount(const DrawCount&) = delete;
  DrawCount& operator=(const DrawCount&) = delete;

  int count() const { return count_; }

 private:
  vtkRenderer* renderer_;
  vtkNew<vtkCallbackCommand> command_;
  int count_ = 0;
};

/// Mean place of the yellow grip's pixels on the canvas.
QPoint grip_on(QOpenGLWidget* canvas) {
  const QImage image = canvas->grabFramebuffer();
  QPoint sum;
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor colour = image.pixelColor(x, y);
      if (colour.red() < 180 || colour.green() < 110 || colour.blue() > 60) continue;
      sum += {x, y};
      ++count;
    }
  }
  return sum / std::max(count, 1) / canvas->devicePixelRatio();
}

/// Moves the mouse, its left button down, along a small circle: one move a frame.
FrameTimes drag(FaceView& view, QOpenGLWidget* canvas, QPoint from) {
  bool swapped = false;
  const auto connection =
      QObject::connect(canvas, &QOpenGLWidget::frameSwapped, [&] { swapped = true; });
  QTest::mouseMove(canvas, from);
  QTest::mousePress(canvas, Qt::LeftButton, {}, from);
  FrameTimes times;
  const DrawCount draws(view.renderer());
  for (int frame = 0; frame < kFrames; ++frame) {
    const double angle = 0.3 * frame;
    const QPoint at = from + QPoint(static_cast<int>(40 * std::sin(angle)),
                                    static_cast<int>(40 * (1 - std::cos(angle))));
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     {});
    swapped = false;
    QElapsedTimer timer;
    timer.start();
    QApplication::sendEvent(canvas, &move);
    times.event.push_back(1e-9 * static_cast<double>(timer.nsecsElapsed()));
    while (!swapped && timer.elapsed() < 2000) QApplication::processEvents();
    times.shown.push_back(1e-9 * static_cast<double>(timer.nsecsElapsed()));
  }
  times.drawn = 1.0 * draws.count() / kFrames;
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, from);
  QObject::disconnect(connection);
  return times;
}

void print_row(const char* what, const FrameTimes& times) {
  std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", what, 1e3 * median(times.event),
              1e3 * median(times.shown), 1 / median(times.shown), times.drawn);
}

void print_longest(const char* what, WatchedApplication& app) {
  const auto longest = app.take_longest();
  std::printf("Longest without listening, %s: %.2f s (%s)\n", what, longest.s,
              longest.what.c_str());
}

int measure(WatchedApplication& app, const std::string& file) {
  QTemporaryDir folder;
  SurgicalCase plan = read_case_file(file);
  plan.photograph.reset();
  plan.skin.edge_mm = kEdge;
  const std::string fine = folder.filePath("case.json").toStdString();
  write_case_file(plan, fine);
  MainWindow window;
  CaseController& model = window.controller();
  auto* canvas = window.findChild<QOpenGLWidget*>("face_canvas");
  window.resize(kWidth, kHeight);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return 1;
  app.take_longest();
  window.open_case(QString::fromStdString(fine));
  if (!QTest::qWaitFor([&] { return model.has_case() && !model.is_working(); }, kPatience)) {
    std::fprintf(stderr, "gnathion-window-bench: the case does not open\n");
    return 1;
  }
  QTest::qWait(1500);
  print_longest("opening", app);
  const Anatomy& anatomy = *model.loaded().anatomy;
  std::printf("%s: face %td triangles, bone %td\n\n", plan.name.c_str(),
              anatomy.face.mesh.surface.triangles.rows(), anatomy.bone.triangles.rows());
  window.findChild<QAction*>("slices_action")->setChecked(false);
  window.findChild<QWidget*>("steps_dock")->hide();
  QTest::qWait(200);
  window.resize(window.size() + QSize(kWidth, kHeight) - canvas->size());
  QTest::qWait(1500);
  std::printf(
      "| %d×%d, while the mouse | event, ms | shown, ms | frames a second | drawn |\n"
      "|---|---|---|---|---|\n",
      canvas->width(), canvas->height());
  print_row("drags the segment", drag(window.face_view(), canvas, grip_on(canvas)));
  QTest::qWait(1500);
  print_row("turns the camera", drag(window.face_view(), canvas, {40, 400}));
  QTest::qWait(1500);
  std::printf("\n");
  print_longest("moving", app);
  return 0;
}

}  // namespace
}  // namespace gnathion::bench

int main(int argc, char** argv) {
  // The user's recent cases stay as they are.
  const QTemporaryDir own;
  for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
    qputenv(place, QFile::encodeName(own.path()));
  }
  QCoreApplication::setApplicationName("gnathion");
  if (argc != 2) {
    std::fprintf(stderr, "gnathion-window-bench CASE.json\n");
    return 2;
  }
  const QString problem = gnathion::display_problem();
  if (!problem.isEmpty()) {
    std::fprintf(stderr, "gnathion-window-bench: %s\n", qPrintable(problem));
    return 1;
  }
  gnathion::prepare_graphics();
  gnathion::bench::WatchedApplication app(argc, argv);
  gnathion::use_c_numbers();
  add_resources();
  try {
    return gnathion::bench::measure(app, argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gnathion-window-bench: %s\n", error.what());
    return 1;
  }
}
