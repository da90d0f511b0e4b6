#include "base/progress.h"

#include <algorithm>
#include <utility>

#include "base/error.h"

namespace gnathion {

Progress::Progress(Listener on_stage, NoticeListener on_notice)
    : on_stage_(std::move(on_stage)), on_notice_(std::move(on_notice)) {}

Progress::Stage::Stage(Progress& progress, std::string name)
    : progress_(progress), name_(std::move(name)), start_(std::chrono::steady_clock::now()) {}

Progress::Stage::~Stage() {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const std::lock_guard lock(progress_.mutex_);
  progress_.stage_times_.push_back({name_, elapsed.count()});
}

Progress::Stage Progress::stage(std::string name) {
  check();
  if (on_stage_) on_stage_(name);
  return Stage(*this, std::move(name));
}

void Progress::notice(const std::string& text) {
  {
    const std::lock_guard lock(mutex_);
    if (std::find(notices_.begin(), notices_.end(), text) != notices_.end()) return;
    notices_.push_back(text);
  }
  if (on_notice_) on_notice_(text);
}

void Progress::check() const {
  if (cancelled_) {
    throw Error(ErrorKind::cancelled, "prediction", "stopped on request",
                "start it again to continue");
  }
}

std::vector<StageTime> Progress::stage_times() const {
  const std::lock_guard lock(mutex_);
  return stage_times_;
}

std::vector<std::string> Progress::notices() const {
  const std::lock_guard lock(mutex_);
  return notices_;
}

}  // namespace gnathion
