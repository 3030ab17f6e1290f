#pragma once

#include "base/json.h"
#include "recording/recording.h"

namespace smile::library {

/// Returns the timeline of a recording: its segments, and its steps as in recording::HistoryOf().
/// All times are from its start [s]:
///
///     {"segments":[{"number","deed","begin","end"}],
///      "steps":[{"step","parent","deed","begin","end","on_way"}],"seconds",
///      "conflicts":[{"hand","seconds","reason"}]}
Json TimelineOf(const recording::Recording& recording);

}  // namespace smile::library
