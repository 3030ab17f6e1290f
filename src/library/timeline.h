#pragma once

#include "base/json.h"
#include "recording/recording.h"

namespace smile::library {

/// What was done in a recording, for people to look through: its segments, and its steps as
/// recording::HistoryOf() has them. All times are from its start [s]:
///
///     {"segments":[{"number","deed","begin","end"}],
///      "steps":[{"step","parent","deed","begin","end","on_way"}],"seconds"}
Json TimelineOf(const recording::Recording& recording);

}  // namespace smile::library
