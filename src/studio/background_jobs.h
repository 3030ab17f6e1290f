#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/json.h"
#include "page/requests.h"
#include "recording/progress.h"

namespace smile::studio {

/// Background jobs: executes slow requests on worker threads, so that no caller waits.
class BackgroundJobs {
 public:
  /// Returns or throws the answer to the request. Reports its progress, and ends early if
  /// `progress` returns false.
  using Work = std::function<Json(const recording::Progress& progress)>;

  struct Job {
    page::Request request;
    Work work;
    /// Cancels older jobs of the same client with the same `do`.
    bool replaces_older = false;
    /// The client may cancel it.
    bool can_be_canceled = false;
    /// Called whether the work succeeded or not, just before its answer is returned: by
    /// TakeDeferred(), in the caller's thread.
    std::function<void()> conclude = {};
  };

  BackgroundJobs();
  /// Cancels all jobs.
  ~BackgroundJobs();
  BackgroundJobs(const BackgroundJobs&) = delete;
  BackgroundJobs& operator=(const BackgroundJobs&) = delete;

  /// Begins as soon as a thread is free. Everything that `work` refers to must outlive the job.
  /// @throws RequestError if too many jobs are waiting.
  void Begin(Job job);
  /// Cancels the job of this request, if it can be canceled and is not done. A job that is about to
  /// finish may still succeed; its answer says so.
  void Cancel(page::ClientId client, std::uint32_t seq);
  /// Returns the answers since the last call, and the progress of running jobs:
  /// `{"t":"progress",…}` for all clients.
  std::vector<page::DeferredMessage> TakeDeferred();

 private:
  struct Task {
    Job job;
    std::string canceled_because;  ///< empty: not canceled
    bool is_running = false;
    double done = 0, total = 0;    ///< [s]
    bool has_progressed = false;   ///< since progress was last sent
    bool has_begun = false;        ///< has reported progress
    bool has_seen_cancel = false;  ///< its progress callback returned false
  };
  struct Outgoing {
    page::DeferredMessage message;
    std::function<void()> conclude;
  };
  /// Cancels the matching tasks; those not yet begun are answered at once.
  void CancelMatching(const std::function<bool(const Job&)>& is_meant,
                      const texts::UserMessage& why);
  std::vector<Outgoing> TakeOutgoing();
  void WorkerLoop();
  /// Returns nullptr when this object is destroyed. Pointers to tasks stay valid.
  Task* TakeTask();
  Json CarryOut(Task* task);
  /// @throws RequestError if the task is canceled.
  void ThrowIfCanceled(const Task& task);
  bool ReportProgress(Task* task, double done, double total);
  void Finish(Task* task, Json answer);
  void Send(const Job& job, Json answer);

  std::mutex mutex_;  ///< guards all members below
  std::condition_variable changed_;
  bool is_closing_ = false;
  std::list<Task> tasks_;  ///< in order
  std::vector<Outgoing> outgoing_;
  std::vector<std::thread> threads_;
};

}  // namespace smile::studio
