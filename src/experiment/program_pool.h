#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "process/child_process.h"

namespace smile::experiment {

/// Program to be run by a pool.
struct PoolJob {
  process::ChildCommand command;
  std::filesystem::path log;  ///< file for its output; long logs lose their middle
  double max_seconds = 3600;  ///< limit of wall-clock time, after which it is ended
};

/// End of a program.
struct PoolEnd {
  std::optional<int> exit_code;  ///< nullopt if a signal ended it
  bool was_late = false;         ///< it was ended at its limit
  std::string how;               ///< in words: `it ended with exit code 3`
  std::string last_line;         ///< of its output
};

/// Functions that RunAll() calls; all are required.
struct PoolCalls {
  std::function<void(std::size_t job)> on_start;  ///< just before the start
  std::function<void(std::size_t job, const PoolEnd& end)> on_end;
  std::function<void()> on_wait;       ///< several times a second
  std::function<bool()> is_cancelled;  ///< as often
};

/// Runs all jobs in order, up to `at_once` at a time, each in a process group of its own. None
/// remains when this returns or throws. If cancelled, the running ones are interrupted, as by
/// Ctrl-C, and killed after a while; `on_end` is not called for these.
/// @param at_once  at least 1.
/// @returns false when it was cancelled.
/// @throws std::runtime_error if one cannot be started, or its log cannot be written.
bool RunAll(const std::vector<PoolJob>& jobs, std::size_t at_once, const PoolCalls& calls);

}  // namespace smile::experiment
