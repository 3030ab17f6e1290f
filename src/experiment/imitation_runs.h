#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/evaluation.h"

namespace smile::experiment {

/// Imitation that a process of its own is to do: a crash, a leak or a hang costs one run.
struct ImitationRun {
  std::uint64_t seed = 0;              ///< of its layout
  std::filesystem::path folder;        ///< for `result.json`, `imitation/` and `log.txt`
  std::vector<std::string> arguments;  ///< of the program
};

/// Settings that many runs share.
struct RunSettings {
  std::filesystem::path program;  ///< ends with exit code 0 or 1 after it has written a result
  std::size_t jobs = 0;           ///< runs at a time; 0: as many as processor cores
  double wall_seconds = 3600;     ///< limit of a run, wall clock; a later one counts as hung
};

/// Functions that RunImitations() calls; all are required.
struct RunCalls {
  std::function<void(std::size_t index)> on_start;  ///< makes the folder, just before the start
  /// Reads the result of a run that ended well.
  /// @throws InputError if it is missing or damaged.
  std::function<report::EvaluatedRun(std::size_t index)> read;
  std::function<void(std::size_t index, report::EvaluatedRun run)> on_end;
  std::function<void()> on_wait;       ///< several times a second
  std::function<bool()> is_cancelled;  ///< as often
};

/// Runs all imitations in order, several at a time. One without a result is a failure, too: its
/// cause is `crashed`, `hung` or `no_result`. Results do not depend on `jobs`.
/// @returns false when it was cancelled: `on_end` is not called for the runs that were cut short.
/// @throws std::runtime_error if a process cannot be started, or a log cannot be written.
bool RunImitations(const std::vector<ImitationRun>& runs, const RunSettings& settings,
                   const RunCalls& calls);

/// Clock that estimates remaining time from the runs that ended since it was made. Runs that were
/// found on disk took no time now and must not make the estimate too good.
class RunClock {
 public:
  void Count() { ++ended_; }

  /// Returns the time for more runs [s of wall-clock time]; nullopt before any ended.
  std::optional<double> SecondsFor(double runs) const {
    if (ended_ == 0) return std::nullopt;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    return passed.count() / static_cast<double>(ended_) * runs;
  }

 private:
  std::size_t ended_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace smile::experiment
