#include "studio/background_jobs.h"
#include "texts/user_message.h"

#include <algorithm>
#include <utility>

// Two worker threads take tasks in order. mutex_ guards the list of tasks and the outgoing
// messages; it is not held while work runs or while `conclude` is called. A task is in the list
// from Begin() until its answer is queued: std::list keeps its address valid for the worker
// meanwhile.

namespace smile::studio {

using texts::Say;
namespace {

/// Number of threads: look-ups stay fast while one simulation runs.
constexpr int kNumThreads = 2;
// Bounds the memory of waiting requests, over all clients and per client. One client can thus never
// fill the list.
constexpr std::size_t kMaxTasks = 256;
constexpr int kMaxTasksOfClient = 8;

page::DeferredMessage ProgressMessage(const std::string& what, double done, double total) {
  return {.message = {{"t", "progress"}, {"what", what}, {"done", done}, {"total", total}}};
}

}  // namespace

BackgroundJobs::BackgroundJobs() {
  for (int i = 0; i < kNumThreads; ++i) threads_.emplace_back([this] { WorkerLoop(); });
}

BackgroundJobs::~BackgroundJobs() {
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    // Running work notices this at its next report of progress, so closing takes at most that long.
    for (Task& task : tasks_) task.canceled_because = "the program is closing";
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void BackgroundJobs::Begin(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (job.replaces_older) {
      // Only the newest of such requests matters, as while a slider is dragged.
      const auto is_older = [&newer = job.request](const Job& other) {
        return other.request.client == newer.client && other.request.what == newer.what;
      };
      CancelMatching(is_older, Say("session.wasReplaced"));
    }
    // A limit per client, so that one page cannot block the others.
    const auto num_of_client = std::ranges::count_if(tasks_, [&job](const Task& task) {
      // A canceled task that still runs does not count, or dragging a slider would exhaust the
      // limit.
      return task.job.request.client == job.request.client && task.canceled_because.empty();
    });
    if (tasks_.size() >= kMaxTasks || num_of_client >= kMaxTasksOfClient) {
      throw page::RequestError(Say("session.tooManyRequests"));
    }
    tasks_.push_back({.job = std::move(job)});
  }
  // One task, one worker; outside the lock, so that it does not wake up only to wait.
  changed_.notify_one();
}

void BackgroundJobs::Cancel(page::ClientId client, std::uint32_t seq) {
  const std::lock_guard lock(mutex_);
  const auto is_meant = [&](const Job& job) {
    return job.can_be_canceled && job.request.client == client && job.request.seq == seq;
  };
  CancelMatching(is_meant, Say("session.wasCanceled"));
}

void BackgroundJobs::CancelMatching(const std::function<bool(const Job&)>& is_meant,
                                    const texts::UserMessage& why) {
  for (auto task = tasks_.begin(); task != tasks_.end();) {
    if (!is_meant(task->job)) {
      ++task;
      // A running job notices the cancellation when it next reports progress; a waiting one is
      // answered now.
    } else if (task->is_running) {
      task->canceled_because = why;
      ++task;
    } else {
      // Answered here, since no worker will ever see it.
      const auto fail = [&why]() -> Json { throw page::RequestError(why); };
      Send(task->job, AnswerWith(task->job.request, fail));
      task = tasks_.erase(task);
    }
  }
}

// `conclude` runs in the session's thread and without the lock.
std::vector<page::DeferredMessage> BackgroundJobs::TakeDeferred() {
  std::vector<page::DeferredMessage> deferred;
  for (Outgoing& outgoing : TakeOutgoing()) {
    if (outgoing.conclude) outgoing.conclude();
    deferred.push_back(std::move(outgoing.message));
  }
  return deferred;
}

std::vector<BackgroundJobs::Outgoing> BackgroundJobs::TakeOutgoing() {
  const std::lock_guard lock(mutex_);
  // At most one progress message per job and call, however often the job reports.
  for (Task& task : tasks_) {
    if (!std::exchange(task.has_progressed, false)) continue;
    outgoing_.push_back({ProgressMessage(task.job.request.what, task.done, task.total), {}});
  }
  return std::exchange(outgoing_, {});
}

void BackgroundJobs::Send(const Job& job, Json answer) {
  outgoing_.push_back({{.client = job.request.client, .message = std::move(answer)}, job.conclude});
}

void BackgroundJobs::WorkerLoop() {
  while (Task* task = TakeTask()) Finish(task, CarryOut(task));
}

BackgroundJobs::Task* BackgroundJobs::TakeTask() {
  std::unique_lock lock(mutex_);
  while (!is_closing_) {
    // In order of arrival. The list is examined again after each wake-up, also a spurious one.
    const auto next =
        std::ranges::find_if(tasks_, [](const Task& task) { return !task.is_running; });
    if (next != tasks_.end()) {
      next->is_running = true;
      return &*next;
    }
    changed_.wait(lock);
  }
  return nullptr;
}

Json BackgroundJobs::CarryOut(Task* task) {
  return AnswerWith(task->job.request, [this, task] {
    ThrowIfCanceled(*task);
    try {
      Json answer = task->job.work(
          [this, task](double done, double total) { return ReportProgress(task, done, total); });
      // Work may have finished just before the cancellation was seen.
      // The result of a replaced job is useless; any other result is kept.
      if (task->job.replaces_older || task->has_seen_cancel) ThrowIfCanceled(*task);
      return answer;
    } catch (const std::exception&) {
      if (task->has_seen_cancel) ThrowIfCanceled(*task);
      throw;
    }
  });
}

void BackgroundJobs::ThrowIfCanceled(const Task& task) {
  const std::lock_guard lock(mutex_);
  if (!task.canceled_because.empty()) throw page::RequestError(task.canceled_because);
}

bool BackgroundJobs::ReportProgress(Task* task, double done, double total) {
  const std::lock_guard lock(mutex_);
  task->done = done;
  task->total = total;
  task->has_progressed = task->has_begun = true;
  task->has_seen_cancel = !task->canceled_because.empty();
  return !task->has_seen_cancel;
}

void BackgroundJobs::Finish(Task* task, Json answer) {
  const std::lock_guard lock(mutex_);
  // Clients that saw progress also see its end, even after a failure.
  if (task->has_begun) {
    outgoing_.push_back({ProgressMessage(task->job.request.what, task->total, task->total), {}});
  }
  Send(task->job, std::move(answer));
  tasks_.remove_if([task](const Task& other) { return &other == task; });
}

}  // namespace smile::studio
