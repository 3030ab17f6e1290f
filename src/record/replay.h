#pragma once

#include <functional>
#include <optional>
#include <string>

#include "record/recording.h"

namespace smile::record {

/// Where a replay first departs from its recording as far as can be seen; where nothing can be seen
/// to the end, the first tick whose state hash differs.
struct Difference {
  std::uint64_t tick = 0;
  std::string object;              ///< id, a joint's name, or `simulation`
  std::string quantity;            ///< `position`, `rotation`, `angle`, `state_hash`, `command`
  std::string recorded, replayed;  ///< lengths in units, angles in degrees, joints in radians
};

struct ReplayReport {
  bool is_cut = false;      ///< the trace ends in the middle of a record
  std::uint64_t ticks = 0;  ///< compared, since the demonstration began
  std::optional<Difference> first_difference;
  std::uint64_t hash = 0;  ///< of the last tick replayed
};

/// Told how far the replay is, in ticks; answers whether it shall go on.
using Progress = std::function<bool(std::uint64_t)>;

/// Runs a recording again, command by command, and compares every tick: poses, joints, state hash.
/// @throws InputError if the recording's trace cannot be read.
ReplayReport Replay(const Recording& recording, const Progress& progress = {});

}  // namespace smile::record
