#include <csignal>
#include <exception>
#include <iostream>
#include <string>

#include "base/error.h"
#include "cli/command_line.h"

namespace {

gnathion::Progress* running = nullptr;

extern "C" void cancel_on_signal(int) {
  if (running != nullptr) running->cancel();
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gnathion;
  CommandLine line;
  if (const auto exit_code = line.parse(argc, argv)) return *exit_code;
  Progress progress(
      [quiet = line.is_quiet()](const std::string& stage) {
        if (!quiet) std::cerr << "… " + stage + "\n" << std::flush;
      },
      [](const std::string& notice) { std::cerr << "notice: " + notice + "\n"; });
  running = &progress;
  std::signal(SIGINT, cancel_on_signal);
  std::signal(SIGTERM, cancel_on_signal);
  try {
    line.run(std::cout, progress);
    return 0;
  } catch (const Error& error) {
    std::cerr << "gnathion-cli: " << error.what() << '\n';
    return static_cast<int>(error.kind());
  } catch (const std::exception& error) {
    std::cerr << "gnathion-cli: a fault of the program: " << error.what() << '\n';
    return 70;
  }
}
