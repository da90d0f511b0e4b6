#include "scan/limited_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "base/error.h"

namespace gnathion {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void cannot_start(const std::filesystem::path& program, int reason) {
  throw Error(ErrorKind::input, program.string(),
              "this part of Gnathion, which reads scans other than OBJ, cannot be started (" +
                  std::generic_category().message(reason) + ")",
              "install Gnathion again, or give the scan as OBJ");
}

/// A running program; killed and waited for where nobody waited.
class Child {
 public:
  Child(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0) cannot_start(program, errno);
    output_ = pipe[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int failure = posix_spawn(&id_, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    if (failure == 0) return;
    ::close(output_);
    cannot_start(program, failure);
  }
  ~Child() {
    ::close(output_);
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Whether there is something to read, or its end, within a moment.
  bool has_output() const {
    pollfd wait{output_, POLLIN, 0};
    return ::poll(&wait, 1, 50) > 0;
  }
  /// Bytes read; 0 at the end.
  std::size_t read(char* block, std::size_t size) const {
    ssize_t count = -1;
    do count = ::read(output_, block, size);
    while (count < 0 && errno == EINTR);
    return count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  /// What waitpid() says.
  int wait() {
    int status = 0;
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
    }
    id_ = -1;
    return status;
  }

 private:
  pid_t id_ = -1;
  int output_ = -1;
};

}  // namespace

ProcessResult run_limited(const std::filesystem::path& program,
                          const std::vector<std::string>& arguments, std::chrono::milliseconds time,
                          std::size_t most_bytes, Progress& progress) {
  progress.check();
  const auto deadline = Clock::now() + time;
  Child child(program, arguments);
  ProcessResult result;
  std::vector<char> block(1U << 20U);
  while (true) {
    progress.check();
    if (Clock::now() > deadline) {
      result.end = ProcessResult::End::took_too_long;
      return result;
    }
    if (!child.has_output()) continue;
    const std::size_t count = child.read(block.data(), block.size());
    if (count == 0) break;
    if (result.output.size() + count > most_bytes) {
      result.end = ProcessResult::End::said_too_much;
      return result;
    }
    result.output.append(block.data(), count);
  }
  const int status = child.wait();
  result.end = WIFSIGNALED(status) ? ProcessResult::End::killed : ProcessResult::End::finished;
  result.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
  return result;
}

}  // namespace gnathion
