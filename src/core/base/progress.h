#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace gnathion {

/// How long a named stage took, wall clock.
struct StageTime {
  std::string name;
  double seconds = 0;
};

/// The one handle that long work receives: it says what is being done, carries notices for the
/// user, and is where the user's Cancel arrives. Work calls it, never makes one. All members may
/// be called from any thread.
class Progress {
 public:
  using Listener = std::function<void(const std::string& stage)>;
  using NoticeListener = std::function<void(const std::string& notice)>;

  Progress() = default;
  /// `on_stage` hears each stage's name when it begins, `on_notice` each notice; both are called
  /// on the working thread.
  explicit Progress(Listener on_stage, NoticeListener on_notice = {});
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A stage lasts as long as this object; its time is recorded when it ends.
  class Stage {
   public:
    Stage(Progress& progress, std::string name);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

   private:
    Progress& progress_;
    std::string name_;
    std::chrono::steady_clock::time_point start_;
  };

  /// Begins a stage. Throws Error(cancelled) when the user has cancelled.
  [[nodiscard]] Stage stage(std::string name);

  /// Tells the user something that is no error but must be seen, such as a resampled series. Said
  /// once, however often.
  void notice(const std::string& text);

  void cancel() { cancelled_ = true; }
  bool is_cancelled() const { return cancelled_; }
  /// Throws Error(cancelled) when the user has cancelled. Call it in every long loop.
  void check() const;

  std::vector<StageTime> stage_times() const;
  std::vector<std::string> notices() const;

 private:
  Listener on_stage_;
  NoticeListener on_notice_;
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;
  std::vector<StageTime> stage_times_;
  std::vector<std::string> notices_;
};

}  // namespace gnathion
