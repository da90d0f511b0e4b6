#include "phantom/parallel_rows.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gnathion {

void for_each_row(int count, unsigned threads, Progress& progress,
                  const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto loop = [&] {
    try {
      for (int row = next++; row < count; row = next++) {
        progress.check();
        work(row);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = count;
    }
  };
  const unsigned wanted = threads == 0 ? std::thread::hardware_concurrency() : threads;
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < std::clamp(wanted, 1U, 16U); ++i) {
    helpers.emplace_back(loop);
  }
  loop();
  helpers.clear();
  if (failure) {
    std::rethrow_exception(failure);
  }
}

}  // namespace gnathion
