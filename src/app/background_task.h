#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <functional>
#include <memory>

#include "base/error.h"
#include "base/progress.h"

namespace gnathion {

/// An error as a window shows it: gnathion::Error in its parts, or a fault of the program.
struct Failure {
  QString subject;  ///< the file or key
  QString problem;  ///< what is wrong with it
  QString remedy;   ///< what to do
};

Failure failure_of(const Error& error);
/// Of an exception that no user should be able to cause.
Failure failure_of(const std::exception& error);

/// Long work beside the window: it computes on a worker, and its result is published on the thread
/// that owns this object. One work at a time: starting another cancels the first, whose result is
/// dropped. The destructor cancels and waits, so that the window may close at any moment.
class BackgroundTask : public QObject {
  Q_OBJECT
 public:
  /// Puts a result into the model; called on the owner's thread.
  using Publish = std::function<void()>;
  /// Called on the worker; throws Error, also Error(cancelled) from the progress that it receives.
  using Work = std::function<Publish(Progress&)>;

  explicit BackgroundTask(QObject* parent = nullptr);
  ~BackgroundTask() override;

  void start(Work work);
  /// The work ends with cancelled() at once; its worker stops as soon as it asks its progress.
  void cancel();
  /// Waits for the worker. Nothing is published by this: that is for the event loop.
  void wait();
  bool is_running() const { return run_ != nullptr; }

 signals:
  void stage_began(const QString& stage);
  void noticed(const QString& notice);
  // Exactly one of these ends every work, unless another takes its place.
  void finished();  ///< after its result is published
  void cancelled();
  void failed(const gnathion::Failure& failure);

 private:
  struct Run;
  void execute(const std::shared_ptr<Run>& run, const Work& work);
  /// Calls `what` on the owner's thread, unless the work is no longer the current one by then.
  void post(const std::shared_ptr<Run>& run, std::function<void()> what);
  void conclude(const Publish& publish);
  void fail(const Failure& failure);

  QThreadPool pool_;  ///< of one thread: the next work waits until a cancelled one has stopped
  std::shared_ptr<Run> run_;
};

}  // namespace gnathion

Q_DECLARE_METATYPE(gnathion::Failure)
