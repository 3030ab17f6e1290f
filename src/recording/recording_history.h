#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recording/recording.h"
#include "sim/action_summary.h"

namespace smile::recording {

/// Segment: one action and its consequences, up to the next action. sim::EventOfAction() defines
/// which commands begin a segment; during a simulation, its counterpart is sim::Action.
///
/// The index of a segment in the whole history is its step. Its index among the segments on the
/// recording's path is its number, by which editing and the files of the classic view refer to it.
struct Segment {
  std::optional<std::size_t> parent;  ///< the step before; nullopt for the start
  HistoryPoint begin;                 ///< just before the action
  /// End of the segment: the next action, the point where an undo left it, or the end of the
  /// recording. If several branches continue it, the one on the path counts, otherwise the last
  /// one.
  HistoryPoint end;
  std::optional<sim::ActionSummary> summary;  ///< of the action; nullopt for the start
  bool is_on_path = false;  ///< false for actions that were undone or left and not redone
};

/// Returns all segments of a recording, including those that were undone. Step 0 is the start; the
/// others are in chronological order, each after its parent. The recording ends with the last one
/// on the path.
/// @throws InputError if the recording's trace cannot be read.
std::vector<Segment> HistoryOf(const Recording& recording);

/// What contact or a tool did within a step without a command, in words; see sim::WordsOf().
struct SegmentEffect {
  std::size_t step = 0;
  std::uint64_t tick = 0;
  std::string words;  ///< `Power pressed by left gripper`
};

/// Returns these effects on the recording's path, in order.
/// @param history  of the recording, from HistoryOf().
/// @throws InputError if the recording's trace cannot be read.
std::vector<SegmentEffect> EffectsOf(const Recording& recording,
                                     const std::vector<Segment>& history);

/// Returns the same segments from the log alone, without summaries. Only for recordings that have
/// commands.
/// @param last_tick  of the recording; its last segment ends there.
std::vector<Segment> CutAtActions(const Recording& recording, std::uint64_t last_tick);

/// Returns the segments on the recording's path, by their numbers.
std::vector<Segment> OnPath(const std::vector<Segment>& history);

/// Returns a description for people: `left hand takes b03`; `the start` for step 0.
std::string WordsOf(const Segment& step);

/// Returns the point some ticks after a step's begin; nullopt if it did not last that long.
std::optional<HistoryPoint> HistoryPointIn(const Recording& recording, const Segment& step,
                                           std::uint64_t ticks);

/// Returns the point at a tick of the recording's path, before the commands of that tick.
HistoryPoint HistoryPointBefore(const Recording& recording, std::uint64_t tick);

/// Returns the point `after` seconds after the begin of a step; the end of the step without
/// `after`.
/// @param steps  of the recording, from HistoryOf().
/// @throws std::invalid_argument if the step does not exist or is shorter.
HistoryPoint HistoryPointOf(const Recording& recording, const std::vector<Segment>& steps,
                            std::size_t step, const std::optional<double>& after);

}  // namespace smile::recording
