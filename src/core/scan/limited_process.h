#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"

namespace gnathion {

/// How another program ended.
struct ProcessResult {
  enum class End { finished, killed, took_too_long, said_too_much };
  End end = End::finished;
  int code = 0;        ///< its exit code, or the signal that killed it
  std::string output;  ///< what it wrote to its standard output
};

/// Runs a program until it ends, without input and with nothing on its standard error, and takes
/// what it says. It is killed at the time limit, beyond so many bytes, and when the user cancels.
/// Throws Error(input) with the program as subject when it cannot be started, Error(cancelled).
ProcessResult run_limited(const std::filesystem::path& program,
                          const std::vector<std::string>& arguments, std::chrono::milliseconds time,
                          std::size_t most_bytes, Progress& progress);

}  // namespace gnathion
