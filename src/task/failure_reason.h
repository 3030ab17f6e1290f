#pragma once

#include <optional>
#include <string>

#include "base/json_node.h"
#include "task/comparison.h"
#include "texts/user_message.h"

namespace smile::task {

/// State of the brain at the end of an imitation.
struct ProgramEnd {
  std::string status;   ///< `exited`, `running` or `stopped` (time was up), or `failed`
  std::string message;  ///< why it failed
};

/// True if everything was achieved and the program ended by itself. Both conditions are needed: a
/// program that fails, is stopped or runs until its time is up has not finished the task, whatever
/// stands there at that moment.
bool IsSuccess(const StructureComparison& comparison, const ProgramEnd& program);

/// Reason why an imitation failed.
struct FailureReason {
  std::string code;  ///< see docs/results.md
  texts::UserMessage text;

  bool operator==(const FailureReason&) const = default;
};

/// Returns `{"word","text","message"}`, where `message` is the text as the page renders it, absent
/// for a text as it is; null for nullopt.
Json ToJson(const std::optional<FailureReason>& reason);
/// Reads what ToJson() returns.
/// @throws InputError naming the place in the file, what was found and what was expected.
std::optional<FailureReason> FailureReasonIn(const JsonNode& node);

/// Returns the first reason that applies, in this order: `brain_failed`, `fell_off_table`,
/// `rule_broken`, `time_up`, `still_held`, `never_taken`, `toppled`, `misplaced`, `not_placed`,
/// `apart`, `intruder`, `effect_missing`. If it applies to several objects, the text names the one
/// that was to be placed first.
/// @returns nullopt after a success, see IsSuccess().
std::optional<FailureReason> FailureReasonOf(const Structure& structure, const Episode& outcome,
                                             const StructureComparison& comparison,
                                             const ProgramEnd& program);

}  // namespace smile::task
