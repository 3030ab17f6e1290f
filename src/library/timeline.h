#pragma once

#include <vector>

#include "base/json.h"
#include "recording/recording.h"
#include "recording/recording_history.h"

namespace smile::library {

/// The segments of a recording, by their numbers in its classic view: the steps on its way.
/// @param history  of the recording.
std::vector<recording::HistoryStep> SegmentsOf(const std::vector<recording::HistoryStep>& history);

/// What was done in a recording, for people to look through: its segments, and its steps as
/// recording::HistoryOf() has them. All times are from its start [s]:
///
///     {"segments":[{"number","deed","begin","end"}],
///      "steps":[{"step","parent","deed","begin","end","on_way"}],"seconds"}
Json TimelineOf(const recording::Recording& recording);

}  // namespace smile::library
