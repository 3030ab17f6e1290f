// A loop in one thread starts programs, reads their output and collects them. Output must be read
// all the time, since a program blocks when its pipe is full; poll() waits for all pipes together.

#include "experiment/program_pool.h"

#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <memory>
#include <optional>

#include "experiment/bounded_log.h"

namespace smile::experiment {
namespace {

// How late the end of a program, its limit or a cancellation may be noticed.
constexpr int kSliceMs = 50;
constexpr double kFarewellSeconds = 10;  ///< for a cancelled program, to write its results
constexpr double kTidySeconds = 1;

/// A running program.
class PoolRun {
 public:
  PoolRun(std::size_t job, const PoolJob& what)
      : job_(job),
        log_(what.log),
        child_(what.command),
        output_(child_.TakeOutput()),
        limit_(what.max_seconds) {}

  std::size_t job() const { return job_; }
  int output() const { return output_.get(); }
  bool IsLate() const { return limit_.HasPassed(); }
  bool HasEnded() const { return child_.HasEnded(); }
  bool WaitForEnd(const process::WaitLimit& limit) const { return child_.WaitForEnd(limit); }
  void Interrupt() const { child_.SignalGroup(SIGINT); }

  /// Moves its output so far into the log.
  void ReadOutput() {
    char buffer[1 << 14];
    // Bounded, so that a program that prints without end does not keep the others waiting.
    for (int k = 0; k < 64 && output_; ++k) {
      const ssize_t count = ::read(output_.get(), buffer, sizeof buffer);
      if (count < 0) return;
      if (count == 0) output_.Close();
      log_.Add({buffer, static_cast<std::size_t>(count)});
    }
  }

  // A program that is still running here is late: it is asked to end, then killed with all its
  // descendants.
  PoolEnd End() {
    const bool was_late = !child_.HasEnded();
    if (was_late) Interrupt();  // gives it a chance to tidy up
    if (was_late) child_.WaitForEnd(process::WaitLimit(kTidySeconds));
    const std::string how = child_.End();
    ReadOutput();
    log_.Finish();
    // The log is finished before its last line is read: ReadOutput() above has added the rest of
    // the pipe.
    return {.exit_code = child_.exit_code(),
            .was_late = was_late,
            .how = how,
            .last_line = log_.last_line()};
  }

 private:
  std::size_t job_;
  BoundedLog log_;
  process::ChildProcess child_;
  process::UniqueFd output_;
  process::WaitLimit limit_;
};

using PoolRuns = std::vector<std::unique_ptr<PoolRun>>;

/// Waits until one of them prints something or a slice of time has passed.
void ListenTo(const PoolRuns& runs) {
  std::vector<pollfd> watched;
  // A closed pipe has the descriptor -1, which poll() ignores.
  for (const auto& run : runs) watched.push_back({run->output(), POLLIN, 0});
  ::poll(watched.data(), watched.size(), kSliceMs);
  for (const auto& run : runs) run->ReadOutput();
}

/// Interrupts all programs and waits for their end while reading their output, since a full pipe
/// would block them. Destruction kills the rest.
void InterruptAll(const PoolRuns& runs) {
  for (const auto& run : runs) run->Interrupt();
  const process::WaitLimit limit(kFarewellSeconds);
  for (bool is_any = true; is_any && !limit.HasPassed();) {
    is_any = false;
    ListenTo(runs);
    for (const auto& run : runs) is_any |= !run->HasEnded();
  }
}

}  // namespace

bool RunAll(const std::vector<PoolJob>& jobs, std::size_t at_once, const PoolCalls& calls) {
  PoolRuns runs;
  std::size_t next = 0;
  while (next < jobs.size() || !runs.empty()) {
    if (calls.is_cancelled()) {
      InterruptAll(runs);
      return false;
    }
    // Keeps up to `at_once` programs running.
    while (next < jobs.size() && runs.size() < at_once) {
      calls.on_start(next);
      runs.push_back(std::make_unique<PoolRun>(next, jobs[next]));
      ++next;
    }
    ListenTo(runs);
    for (std::size_t i = 0; i < runs.size();) {
      if (!runs[i]->HasEnded() && !runs[i]->IsLate()) {
        ++i;
        continue;
      }
      // Removed from the list first: on_end may throw, and then destruction ends the others.
      const std::unique_ptr<PoolRun> run = std::move(runs[i]);
      runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(i));
      const PoolEnd end = run->End();
      // A signal to all processes of a batch job may reach this one last: then the run did not
      // fail.
      if (!end.exit_code) ::poll(nullptr, 0, kSliceMs);
      if (end.exit_code != 0 && calls.is_cancelled()) {
        InterruptAll(runs);
        return false;
      }
      calls.on_end(run->job(), end);
    }
    calls.on_wait();
  }
  return true;
}

}  // namespace smile::experiment
