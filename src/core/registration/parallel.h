#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace gnathion {

/// Calls work(i) for every i below `count` on the machine's threads, eight at most. The calls must
/// be independent. Rethrows what one of them throws, when all threads have ended.
template <typename Work>
void for_each_in_parallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto loop = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> helpers;
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1U, 8U);
  for (unsigned t = 1; t < threads; ++t) helpers.push_back(std::async(std::launch::async, loop));
  loop();
  for (std::future<void>& helper : helpers) helper.get();
}

}  // namespace gnathion
