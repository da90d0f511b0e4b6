#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <vector>

#include "app/background_task.h"
#include "app/loaded_case.h"
#include "prediction/settling.h"

namespace gnathion {

/// The damped motion of the tissue as a film: computed ahead beside the window, then played so many
/// times slower than it is. One film at a time.
class MotionPlayer : public QObject {
  Q_OBJECT
 public:
  static constexpr double slower = 20;  ///< 2 ms of the tissue in the 40 ms of a picture

  explicit MotionPlayer(QObject* parent = nullptr);

  /// From rest to the segments' poses, one a segment. Ends with ended(), or failed() before it.
  void start(std::shared_ptr<const LoadedCase> loaded, std::vector<RigidMotion> poses);
  void stop();
  bool is_computing() const { return computing_.is_running(); }
  bool is_playing() const { return timer_.isActive(); }
  bool is_running() const { return is_computing() || is_playing(); }
  const SettlingOptions& options() const { return options_; }

 signals:
  void began();
  void playing_began();  ///< the film is computed
  /// face: n×3, mm, LPS. time_s: of the tissue, since the bone jumped.
  void frame_due(const gnathion::Points& face, double time_s);
  void ended();
  void failed(const gnathion::Failure& failure);

 private:
  void play(std::vector<Points> film);
  void show_due_frame();

  SettlingOptions options_;
  std::shared_ptr<const LoadedCase> loaded_;
  std::vector<Points> film_;  ///< displacements of the tissue's surface, mm, a step each
  std::size_t next_ = 0;
  QElapsedTimer clock_;
  QTimer timer_;
  BackgroundTask computing_;
};

}  // namespace gnathion
