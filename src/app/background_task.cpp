#include "app/background_task.h"

#include <sys/resource.h>
#include <QMetaObject>
#include <QtConcurrent>
#include <utility>

#include "app/core_words.h"

namespace gnathion {

namespace {

/// Where there are as many workers as processors, the window that draws comes first. On Linux a
/// thread has a niceness of its own, which the threads that it starts take over.
void yield_to_the_window() {
  constexpr int niceness = 5;
  setpriority(PRIO_PROCESS, 0, niceness);
}

}  // namespace

struct BackgroundTask::Run {
  explicit Run(Progress::Listener on_stage, Progress::NoticeListener on_notice)
      : progress(std::move(on_stage), std::move(on_notice)) {}
  Progress progress;
};

Failure failure_of(const Error& error) {
  return {core_words(error.subject()), core_words(error.problem()), core_words(error.remedy())};
}

Failure failure_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
    return {BackgroundTask::tr("memory"), BackgroundTask::tr("there is not enough of it"),
            BackgroundTask::tr("close other programs, or use a CT or photograph of fewer voxels "
                               "or vertices")};
  }
  return {
      BackgroundTask::tr("the program"),
      BackgroundTask::tr("a fault of its own (%1)").arg(QString::fromUtf8(error.what())),
      BackgroundTask::tr("nothing was changed; please report it with the files that caused it")};
}

BackgroundTask::BackgroundTask(QObject* parent) : QObject(parent) {
  qRegisterMetaType<Failure>();
  pool_.setMaxThreadCount(1);
}

BackgroundTask::~BackgroundTask() {
  if (run_) run_->progress.cancel();
  wait();
}

void BackgroundTask::start(Work work) {
  if (run_) run_->progress.cancel();
  // The listeners need the run that they belong to, which is made with them.
  auto self = std::make_shared<std::weak_ptr<Run>>();
  run_ = std::make_shared<Run>(
      [this, self](const std::string& stage) {
        const auto run = self->lock();
        post(run, [this, stage] { emit stage_began(core_words(stage)); });
      },
      [this, self](const std::string& notice) {
        const auto run = self->lock();
        post(run, [this, notice] { emit noticed(core_words(notice)); });
      });
  *self = run_;
  QtConcurrent::run(&pool_, [this, run = run_, work = std::move(work)] { execute(run, work); });
}

void BackgroundTask::cancel() {
  if (!run_) return;
  run_->progress.cancel();
  run_.reset();
  emit cancelled();
}

void BackgroundTask::wait() {
  pool_.waitForDone();
}

void BackgroundTask::execute(const std::shared_ptr<Run>& run, const Work& work) {
  yield_to_the_window();
  try {
    run->progress.check();
    post(run, [this, publish = work(run->progress)] { conclude(publish); });
  } catch (const Error& error) {
    // A cancelled work has ended already for its owner, who dropped it.
    post(run, [this, failure = failure_of(error)] { fail(failure); });
  } catch (const std::exception& error) {
    post(run, [this, failure = failure_of(error)] { fail(failure); });
  }
}

void BackgroundTask::post(const std::shared_ptr<Run>& run, std::function<void()> what) {
  QMetaObject::invokeMethod(
      this,
      [this, run, what = std::move(what)] {
        if (run == run_) what();
      },
      Qt::QueuedConnection);
}

void BackgroundTask::conclude(const Publish& publish) {
  run_.reset();
  try {
    publish();
  } catch (const Error& error) {
    emit failed(failure_of(error));
    return;
  } catch (const std::exception& error) {
    emit failed(failure_of(error));
    return;
  }
  emit finished();
}

void BackgroundTask::fail(const Failure& failure) {
  run_.reset();
  emit failed(failure);
}

}  // namespace gnathion
