#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <sys/types.h>

namespace smile::python {

/// Threads that do short works together, again and again. Between two works they stay awake for a
/// moment: to start threads or to wake them takes longer than to step a small world.
class ThreadTeam {
 public:
  /// @param num_threads  with the caller of Run(), at least 1.
  explicit ThreadTeam(int num_threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls `work` once in each thread, and returns when all have returned. It must not throw.
  void Run(const std::function<void()>& work);

 private:
  /// What the helpers share. Outlives them in a process that was forked from the one that has them.
  struct Shared {
    std::atomic<unsigned> num_works = 0;          ///< that were begun
    std::atomic<int> num_working = 0;             ///< helpers that have not yet returned
    const std::function<void()>* work = nullptr;  ///< null: the team ends
    std::vector<std::thread> helpers;
  };

  static void Help(Shared* shared);
  void Start();
  void Stop();

  const int num_threads_;
  std::mutex mutex_;   ///< of a work
  pid_t process_ = 0;  ///< to which the helpers belong
  std::unique_ptr<Shared> shared_;
};

}  // namespace smile::python
