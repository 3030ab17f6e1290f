#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "process/child_process.h"

namespace smile::app {

/// A program to be run, as one of many.
struct PoolJob {
  process::ChildCommand command;
  std::filesystem::path log;  ///< where goes what it prints; long logs lose their middle
  double max_seconds = 3600;  ///< by the clock on the wall; then it is ended
};

/// How one of them ended.
struct PoolEnd {
  std::optional<int> exit_code;  ///< nullopt when a signal ended it
  bool was_late = false;         ///< its time was up
  std::string how;               ///< in words: `it ended with exit code 3`
  std::string last_line;         ///< that it printed
};

/// Who is told.
struct PoolCalls {
  std::function<void(std::size_t job)> on_start;  ///< just before
  std::function<void(std::size_t job, const PoolEnd& end)> on_end;
  std::function<void()> on_wait;       ///< several times a second
  std::function<bool()> is_cancelled;  ///< asked as often
};

/// Runs all of them, in order, some at once, each in a process group of its own: whatever happens,
/// nothing of them is left when this returns or throws. When it is called off they are asked to
/// end, as by Ctrl-C, and after a while they are ended; of these no end is told.
/// @param at_once  at least 1.
/// @returns false when it was called off.
/// @throws std::runtime_error if one cannot be started, or its log cannot be written.
bool RunAll(const std::vector<PoolJob>& jobs, std::size_t at_once, const PoolCalls& calls);

}  // namespace smile::app
