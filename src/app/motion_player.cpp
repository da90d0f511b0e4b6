#include "app/motion_player.h"

#include <algorithm>
#include <utility>

namespace gnathion {

MotionPlayer::MotionPlayer(QObject* parent) : QObject(parent) {
  options_.dynamics.step = 0.002;
  timer_.setInterval(10);
  connect(&timer_, &QTimer::timeout, this, &MotionPlayer::show_due_frame);
  connect(&computing_, &BackgroundTask::failed, this, [this](const Failure& failure) {
    emit failed(failure);
    emit ended();
  });
}

void MotionPlayer::start(std::shared_ptr<const LoadedCase> loaded, std::vector<RigidMotion> poses) {
  stop();
  loaded_ = std::move(loaded);
  computing_.start([this, poses = std::move(poses), loaded = loaded_,
                    options = options_](Progress& progress) {
    auto film = std::make_shared<std::vector<Points>>();
    const int surface = loaded->model->problem().tissue.surface_count;
    settle(
        *loaded->model, poses, options,
        [&](const SettlingFrame& frame) { film->push_back(frame.displacements.topRows(surface)); },
        progress);
    return [this, film] { play(std::move(*film)); };
  });
  emit began();
}

void MotionPlayer::stop() {
  if (!is_running()) return;
  computing_.cancel();
  timer_.stop();
  film_.clear();
  loaded_.reset();
  emit ended();
}

void MotionPlayer::play(std::vector<Points> film) {
  film_ = std::move(film);
  next_ = 0;
  clock_.start();
  timer_.start();
  emit playing_began();
  show_due_frame();
}

/// Where drawing is slow, frames are left out rather than time stretched.
void MotionPlayer::show_due_frame() {
  const double time = static_cast<double>(clock_.elapsed()) / 1000 / slower;
  const auto due = static_cast<std::size_t>(time / options_.dynamics.step);
  if (due < next_) return;
  if (next_ == film_.size()) {
    stop();
    return;
  }
  const std::size_t shown = std::min(due, film_.size() - 1);
  next_ = shown + 1;
  emit frame_due(loaded_->model->face_with(film_[shown]),
                 static_cast<double>(shown) * options_.dynamics.step);
}

}  // namespace gnathion
