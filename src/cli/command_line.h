#pragma once

#include <functional>
#include <optional>
#include <ostream>

#include <CLI/CLI.hpp>

#include "base/progress.h"
#include "cli/verbs.h"

namespace gnathion {

/// The words that gnathion-cli was called with (docs/cli.md): they name a verb and what it works
/// on.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The exit code where there is nothing to run: help, version, a mistake, which it has printed.
  std::optional<int> parse(int argc, char** argv);
  bool is_quiet() const { return quiet_; }
  /// What the verb writes goes to `out`. Throws gnathion::Error as the verb. \pre parse() gave none
  void run(std::ostream& out, Progress& progress) const { verb_(out, progress); }

 private:
  using Verb = std::function<void(std::ostream&, Progress&)>;
  using Step = void(const std::filesystem::path& case_file, const std::filesystem::path& target,
                    std::ostream& out, Progress& progress);

  CLI::App* add(const char* name, const char* what, const char* input_name, bool writes,
                const Verb& verb);
  void add_step(const char* name, const char* what, Step* step);
  void add_steps();
  void add_predict();
  void add_settle();
  void add_register();
  void add_photographs();
  void add_scan();

  CLI::App app_;
  Verb verb_;  ///< that was named
  bool quiet_ = false;
  std::string input_, output_;
  unsigned seed_ = 1;
  bool no_pictures_ = false;
  SettlingOptions settling_;
  bool newmark_ = false;
  RegisterChoices registering_;
  PhotographsChoices photographs_;
  std::string scan_format_ = "obj";
  ScanRepairChoices repairs_;
};

}  // namespace gnathion
