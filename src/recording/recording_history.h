#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "sim/action_summary.h"

namespace smile::recording {

/// One action and what followed upon it, up to the next one. sim::EventOfAction() defines what
/// begins a segment; while it is being recorded, it is a sim::Action.
///
/// The index of a segment in the whole history is its step. Its index among the segments on the
/// recording's path is its number, by which editing and the files of the classic view refer to it.
struct Segment {
  std::optional<std::size_t> parent;  ///< the step before; nullopt for the start
  HistoryPoint begin;                 ///< just before the action
  /// As far as it went: to the next action, to where it was left by an undo, or to the recording's
  /// end. If several branches continue it, the one on the path counts, else the last one.
  HistoryPoint end;
  std::optional<sim::ActionSummary> summary;  ///< of the action; nullopt of the start
  bool is_on_path = false;  ///< false of what was undone or left, and not done again
};

/// Everything that was ever done in a recording, also what was undone. Step 0 is the start; the
/// others are in the order in which they were done, each after its parent. The recording ends with
/// the last one on the path.
/// @throws InputError if the recording's trace cannot be read.
std::vector<Segment> HistoryOf(const Recording& recording);

/// The same as far as the log knows it: without summaries. Only for recordings that have commands.
/// @param last_tick  of the recording; its last segment ends there.
std::vector<Segment> CutAtActions(const Recording& recording, std::uint64_t last_tick);

/// Returns the segments on the recording's path, by their numbers.
std::vector<Segment> OnPath(const std::vector<Segment>& history);

/// `left hand takes b03`; of step 0 `the start`.
std::string WordsOf(const Segment& step);

/// Returns the point some ticks after a step's begin; nullopt if it did not last that long.
std::optional<HistoryPoint> HistoryPointIn(const Recording& recording, const Segment& step,
                                           std::uint64_t ticks);

/// Returns the point `after` seconds after the begin of a step; the end of the step without
/// `after`.
/// @param steps  of the recording, as HistoryOf() has them.
/// @throws std::invalid_argument if there is no such step, or it did not last that long.
HistoryPoint HistoryPointOf(const Recording& recording, const std::vector<Segment>& steps,
                            std::size_t step, const std::optional<double>& after);

}  // namespace smile::recording
