#pragma once

#include <optional>
#include <string>

#include "task/comparison.h"

namespace smile::task {

/// How the robot program ended that was to achieve something.
struct ProgramEnd {
  std::string status;   ///< `exited`, `running` or `stopped` (time was up), or `failed`
  std::string message;  ///< why it failed
};

/// True when everything was achieved and the program did not fail: it may have failed before it did
/// anything, where the goal held from the start.
bool IsSuccess(const Comparison& comparison, const ProgramEnd& program);

/// Why something was not achieved.
struct Cause {
  std::string word;  ///< see docs/results.md
  std::string text;  ///< a sentence for people

  bool operator==(const Cause&) const = default;
};

/// The first that fits: `brain_failed`, `fell_off_table`, `time_up`, `still_held`, `never_taken`,
/// `toppled`, `misplaced`, `not_placed`, `effect_missing`. Of objects that of which it is told is
/// the one that was to be put first.
/// @returns nullopt after a success, see IsSuccess().
std::optional<Cause> CauseOf(const Structure& structure, const Episode& outcome,
                             const Comparison& comparison, const ProgramEnd& program);

}  // namespace smile::task
