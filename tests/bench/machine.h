#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"

namespace gnathion::bench {

/// Bytes a second at which one thread reads so many bytes again and again: the median of `passes`,
/// as a drag frame reads its basis. Fewer bytes than the caches hold are read faster.
double read_bandwidth(std::size_t bytes, int passes);

/// What a stage of a computation cost.
struct StageCost {
  double seconds = 0;
  double growth = 0;  ///< bytes: the process's peak during the stage over its size at the beginning
  double size_at_peak = 0;  ///< bytes, of the whole process
};

/// Costs of the stages of one thread's work: those that call it by name, and those that work given
/// its progress() begins. The peak is the kernel's (VmHWM), reset at each beginning, so it belongs
/// in a process that does nothing else.
class StageMeter {
 public:
  StageMeter();
  void measure(const std::string& name, const std::function<void()>& work);
  /// For work that names its own stages; finish() ends the last one.
  Progress& progress() { return progress_; }
  void finish();
  /// Throws std::out_of_range when there was no such stage.
  const StageCost& cost(const std::string& name) const { return costs_.at(name); }

 private:
  void begin(const std::string& name);

  Progress progress_;
  std::map<std::string, StageCost> costs_;
  std::string name_;
  double start_ = 0;
  double size_ = 0;
};

/// Runs `work` in a child process and brings its numbers back: peaks of memory are then its own.
/// Throws std::runtime_error with the child's message, or that it was killed.
std::vector<double> in_child(const std::function<std::vector<double>()>& work);

}  // namespace gnathion::bench
