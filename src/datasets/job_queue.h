#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/json.h"
#include "experiment/program_pool.h"

namespace smile::datasets {

/// Program of a job.
struct JobProgram {
  std::vector<std::string> arguments;  ///< the program's path first
  std::filesystem::path log;           ///< file for its output
  /// Its output is the verdict on what the ones before it made; exit code 1 fails no job.
  bool is_check = false;
};

/// Long work, done by programs one after another.
struct Job {
  std::string what;  ///< `generate`, `export` or `film`
  std::string name;  ///< of the folder or file that it makes
  std::string set;   ///< generated set that it makes or reads; empty: none
  std::vector<JobProgram> programs;
  /// Returns how far it is: more members of the description. Called in the thread of the queue,
  /// with the last line that the program printed; also once at the end.
  std::function<Json(const std::string& last_line)> progress;
};

/// Job queue: runs jobs one at a time, in order, each as child processes that end with the queue.
///
/// Thread-safe.
class JobQueue {
 public:
  static constexpr std::size_t kMaxWaiting = 16;  ///< jobs that are not done
  static constexpr std::size_t kMaxKept = 20;     ///< jobs that are done, and listed

  JobQueue();
  /// Interrupts the running job and forgets the waiting ones.
  ~JobQueue();
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;

  /// Returns the job's number.
  /// @throws page::RequestError if too many jobs wait, or one of this kind and name is not done.
  int Add(Job job);
  /// Interrupts a job, as by Ctrl-C, or forgets it if it waits.
  /// @throws page::RequestError if there is no such job, or it is done.
  void Stop(int number);
  /// Returns true if a job of this kind and name waits or runs.
  bool IsBusy(const std::string& what, const std::string& name) const;
  /// Returns true if a job that waits or runs makes or reads this generated set.
  bool IsUsing(const std::string& set) const;
  /// Returns the jobs, oldest first: `[{"job","do","name","status","words",…}]`; see
  /// docs/studio-protocol.md.
  Json List() const;
  /// Returns a number that changes whenever the list does.
  std::size_t num_changes() const;

 private:
  struct Task {
    int number = 0;
    Job job;
    const char* status = "waiting";
    std::string words;               ///< last line of the output, or why it failed
    Json progress = Json::object();  ///< as last reported
    Json verdict;                    ///< `{"ok","lines"}` of a check; null before
    bool is_stopped = false;         ///< it is to end
    bool is_open() const { return std::string(status) == "waiting" || is_running(); }
    bool is_running() const { return std::string(status) == "running"; }
  };

  Task* FindOpen(int number);
  bool HasOpen(const std::string& what, const std::string& name) const;
  void WorkerLoop();
  /// Returns nullptr when the queue closes. Pointers to tasks that are not done stay valid.
  Task* TakeTask();
  void RunPrograms(Task* task);
  /// Runs a program; nullopt if it was stopped.
  std::optional<experiment::PoolEnd> EndOf(Task* task, const JobProgram& program);
  /// @returns false if the job is at its end: it failed or was stopped.
  bool RunProgram(Task* task, const JobProgram& program);
  void Report(Task* task, const JobProgram& program);
  void Finish(Task* task, const char* status, const std::string& words);
  bool IsStopped(const Task& task) const;

  mutable std::mutex mutex_;  ///< guards all members below
  std::condition_variable changed_;
  bool is_closing_ = false;
  int num_added_ = 0;
  std::size_t num_changes_ = 0;
  std::list<Task> tasks_;  ///< oldest first
  std::thread thread_;
};

/// Returns the last lines of a log that give the reason of a failure.
std::string ReasonIn(const std::string& log);

}  // namespace smile::datasets
