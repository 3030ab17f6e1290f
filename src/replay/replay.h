#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recording/progress.h"
#include "recording/recording.h"
#include "recording/time_range.h"

namespace smile::replay {

/// Difference between a replay and its recording.
struct Difference {
  std::uint64_t tick = 0;
  std::string object;    ///< id, a joint's name, or `simulation`
  std::string quantity;  ///< `position`, `rotation`, `angle`, `state_hash`, `command`, …
  std::string recorded, replayed;  ///< lengths in units, angles in degrees, joints in radians

  bool operator==(const Difference&) const = default;
};

/// Deviation of an object or a joint from its recording.
struct Deviation {
  std::string object;          ///< id, or a joint's name
  recording::PoseGap largest;  ///< at `tick`
  std::uint64_t tick = 0;
  /// nullopt if the object is missing in one of the two at the end
  std::optional<recording::PoseGap> end;
};

/// Command that was executed when it was recorded, but is refused in the replay.
struct RefusedCommand {
  std::uint64_t tick = 0;
  std::size_t line = 0;  ///< of commands.jsonl
  std::string reason;
};

/// Options of a replay.
struct ReplayOptions {
  recording::TimeRange range;        ///< compared part
  bool stops_at_difference = false;  ///< at the first visible one, without measuring deviations
};

/// Result of a replay.
struct ReplayReport {
  bool is_cut = false;            ///< the trace ends in the middle of a record
  recording::TickRange compared;  ///< ends early where the replay did
  /// The first visible difference; without one, the first tick whose state hash differs. A refused
  /// command also counts, even before the range.
  std::optional<Difference> first_difference;
  std::vector<Deviation> deviations;          ///< largest first
  std::vector<Difference> state_differences;  ///< different final states, besides poses
  std::vector<RefusedCommand> refused;
  std::uint64_t hash = 0;  ///< of the last tick replayed

  std::uint64_t ticks() const { return compared.last - compared.first; }
};

/// Runs a recording again, command by command, and compares each tick: poses, states, joints, state
/// hash.
/// @throws std::invalid_argument if the range is not within the recording.
/// @throws InputError if the recording has no commands or its trace cannot be read.
ReplayReport Replay(const recording::Recording& recording, const ReplayOptions& options = {},
                    const recording::Progress& progress = {});

}  // namespace smile::replay
