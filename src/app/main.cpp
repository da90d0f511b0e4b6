#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <cstdio>

#include "app/display.h"
#include "app/language.h"
#include "app/main_window.h"
#include "app/theme.h"

namespace {

constexpr int usage_error = 2;

int complain(const QString& text) {
  std::fprintf(stderr, "gnathion: %s\n", qPrintable(text));
  return usage_error;
}

struct CommandLine {
  QString file;
  bool demo = false;
};

/// Empty when the program should end with `exit_code`. Needs no display.
bool read_command_line(int argc, char** argv, CommandLine& line, int& exit_code) {
  const QCoreApplication core(argc, argv);
  gnathion::start_language();
  QCommandLineParser parser;
  parser.setApplicationDescription(
      QCoreApplication::tr("Predicts a face after an operation on the jaw. Research use only."));
  const QCommandLineOption help = parser.addHelpOption();
  const QCommandLineOption version("version", QCoreApplication::tr("Print the version."));
  const QCommandLineOption demo("demo", QCoreApplication::tr("Open the embedded demo case."));
  parser.addOptions({demo, version});
  parser.addPositionalArgument(
      "file",
      QCoreApplication::tr("A case to open (.json), or what to import as a new one: a folder "
                           "with DICOM files or an image volume."),
      "[file]");
  if (!parser.parse(QCoreApplication::arguments())) {
    exit_code = complain(parser.errorText());
    return false;
  }
  exit_code = 0;
  if (parser.isSet(help) || parser.isSet(version)) {
    const QString text = parser.isSet(help) ? parser.helpText()
                                            : QStringLiteral("gnathion %1\n").arg(GNATHION_VERSION);
    std::fputs(qPrintable(text), stdout);
    return false;
  }
  const QStringList files = parser.positionalArguments();
  if (files.size() + (parser.isSet(demo) ? 1 : 0) > 1) {
    exit_code = complain(QCoreApplication::tr("more than one case; give one file, or --demo"));
    return false;
  }
  const QString problem = gnathion::display_problem();
  if (!problem.isEmpty()) {
    exit_code = complain(problem);
    return false;
  }
  line = {files.value(0), parser.isSet(demo)};
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  QCoreApplication::setApplicationName("gnathion");
  QCoreApplication::setApplicationVersion(GNATHION_VERSION);
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  CommandLine line;
  int exit_code = 0;
  if (!read_command_line(argc, argv, line, exit_code)) return exit_code;

  gnathion::prepare_graphics();
  QApplication app(argc, argv);
  gnathion::use_c_numbers();
  gnathion::start_language();
  gnathion::start_theme();
  const QString graphics = gnathion::graphics_problem();
  if (!graphics.isEmpty()) return complain(graphics);

  Q_INIT_RESOURCE(gnathion);  // of a static library: nothing else would pull it in
  QApplication::setWindowIcon(QIcon(":/gnathion.svg"));
  QGuiApplication::setDesktopFileName("org.gnathion.Gnathion");
  gnathion::MainWindow window;
  window.show();
  if (line.demo) window.open_demo_case();
  if (!line.file.isEmpty()) window.take(line.file);
  return QApplication::exec();
}
