#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/json.h"
#include "record/recording.h"
#include "record/recording_history.h"

namespace smile::studio {

/// From one action of a hand to the next.
struct SegmentSpan {
  std::optional<record::Deed> deed;  ///< that began it; nullopt of the first
  std::uint64_t begin = 0, end = 0;  ///< [ticks]
};

/// The segments of a recording, by their numbers in its classic view.
/// @param history  of the recording.
/// @throws InputError if its trace cannot be read. So does TimelineOf().
std::vector<SegmentSpan> SegmentsOf(const record::Recording& recording,
                                    const std::vector<record::HistoryStep>& history);

/// What was done in a recording, for people to look through: its segments, and its steps as
/// record::HistoryOf() has them. All times are from its start [s]:
///
///     {"segments":[{"number","deed","begin","end"}],
///      "steps":[{"step","parent","deed","begin","end","on_way"}],"seconds"}
Json TimelineOf(const record::Recording& recording);

}  // namespace smile::studio
