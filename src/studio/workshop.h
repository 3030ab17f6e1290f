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

/// Carries out what takes its time on threads of its own, so that nobody waits for it.
class Workshop {
 public:
  /// Its answer, or what it throws, is that to its request. It may tell how far it is, and ends
  /// when it hears that it shall not go on.
  using Work = std::function<Json(const recording::Progress& progress)>;

  struct Job {
    page::Request request;
    Work work;
    /// What the same client asked for before with the same `do` is given up.
    bool replaces_older = false;
    /// The client may give it up.
    bool can_be_canceled = false;
    /// What is left to do, whatever became of the work, just before its answer is told: by who
    /// takes the letters, in that thread.
    std::function<void()> conclude = {};
  };

  Workshop();
  /// Gives up all there is.
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Begins as soon as a thread is free. `work` must not refer to anything that may be gone then.
  /// @throws RequestError if too much is waiting.
  void Begin(Job job);
  /// Gives up what a client asked for with this request, if that can be canceled and is not done.
  /// What it was about to finish may be finished: its answer says so.
  void Cancel(page::ClientId client, std::uint32_t seq);
  /// Answers since this was last asked, and how far work is: `{"t":"progress",…}` for everyone.
  std::vector<page::Letter> TakeLetters();

 private:
  struct Task {
    Job job;
    std::string given_up_for;  ///< why it is given up; empty: it is not
    bool is_running = false;
    double done = 0, total = 0;  ///< [s]
    bool has_news = false, has_begun = false;
    bool was_told_to_end = false;  ///< by the answer to its progress
  };
  struct Outgoing {
    page::Letter letter;
    std::function<void()> conclude;
  };
  /// Those not yet begun are answered at once.
  void GiveUp(const std::function<bool(const Job&)>& is_meant, const std::string& why);
  std::vector<Outgoing> TakeOutgoing();
  void Labor();
  /// nullptr when the workshop closes. Where a task is in the list does not change.
  Task* TakeTask();
  Json CarryOut(Task* task);
  /// @throws RequestError if the task is given up.
  void FailIfGivenUp(const Task& task);
  bool Tell(Task* task, double done, double total);
  void Finish(Task* task, Json answer);
  void Send(const Job& job, Json answer);

  std::mutex mutex_;  ///< of all that follows
  std::condition_variable changed_;
  bool is_closing_ = false;
  std::list<Task> tasks_;  ///< in order
  std::vector<Outgoing> outgoing_;
  std::vector<std::thread> threads_;
};

}  // namespace smile::studio
