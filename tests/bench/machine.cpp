#include "bench/machine.h"

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "bench/timing.h"

namespace gnathion::bench {
namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A line of /proc/self/status that is given in kB, in bytes.
double status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == key && status >> kilobytes) return 1024 * kilobytes;
  }
  throw std::runtime_error("/proc/self/status has no " + key);
}

void write_all(int file, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(file, at, size);
    if (written <= 0) _exit(2);
    at += written;
    size -= static_cast<std::size_t>(written);
  }
}

std::string read_all(int file) {
  std::string all;
  char part[4096];
  for (ssize_t got; (got = read(file, part, sizeof part)) > 0;) {
    all.append(part, static_cast<std::size_t>(got));
  }
  return all;
}

/// Never returns: the numbers, or a message after a first byte of 1, go into the pipe.
[[noreturn]] void child(const std::function<std::vector<double>()>& work, int file) {
  std::string answer(1, '\0');
  try {
    const std::vector<double> numbers = work();
    answer.append(reinterpret_cast<const char*>(numbers.data()), sizeof(double) * numbers.size());
  } catch (const std::exception& error) {
    answer = std::string(1, '\1') + error.what();
  }
  write_all(file, answer.data(), answer.size());
  _exit(0);
}

}  // namespace

double read_bandwidth(std::size_t bytes, int passes) {
  const std::size_t quarter = bytes / (4 * sizeof(std::uint64_t));
  const std::vector<std::uint64_t> data(4 * quarter, 1);
  std::uint64_t sum = 0;
  const double time = median_seconds(passes, [&] {
    std::uint64_t a = 0, b = 0, c = 0, d = 0;
    for (std::size_t i = 0; i < quarter; ++i) {
      a += data[i];
      b += data[quarter + i];
      c += data[2 * quarter + i];
      d += data[3 * quarter + i];
    }
    sum += a + b + c + d;
  });
  if (sum != static_cast<std::size_t>(passes) * data.size()) {
    throw std::runtime_error("memory reads wrong sums");
  }
  return static_cast<double>(sizeof(std::uint64_t) * data.size()) / time;
}

StageMeter::StageMeter() : progress_([this](const std::string& name) { begin(name); }) {}

void StageMeter::begin(const std::string& name) {
  finish();
  malloc_trim(0);  // so that memory which is reused counts as grown
  std::ofstream("/proc/self/clear_refs") << "5";
  size_ = status_bytes("VmRSS:");
  name_ = name;
  start_ = now();
}

void StageMeter::finish() {
  if (name_.empty()) return;
  const double time = now() - start_, peak = status_bytes("VmHWM:");
  costs_[name_] = {time, peak - size_, peak};
  name_.clear();
}

void StageMeter::measure(const std::string& name, const std::function<void()>& work) {
  begin(name);
  work();
  finish();
}

std::vector<double> in_child(const std::function<std::vector<double>()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t id = fork();
  if (id < 0) throw std::runtime_error("no child process");
  if (id == 0) {
    close(ends[0]);
    child(work, ends[1]);
  }
  close(ends[1]);
  const std::string answer = read_all(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(id, &status, 0);
  if (WIFSIGNALED(status) || answer.empty()) {
    throw std::runtime_error("the child process was killed (signal " +
                             std::to_string(WTERMSIG(status)) + ")");
  }
  if (answer[0] != '\0') throw std::runtime_error(answer.substr(1));
  std::vector<double> numbers((answer.size() - 1) / sizeof(double));
  std::copy_n(answer.data() + 1, sizeof(double) * numbers.size(),
              reinterpret_cast<char*>(numbers.data()));
  return numbers;
}

}  // namespace gnathion::bench
