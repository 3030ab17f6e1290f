#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "recording/recording.h"

namespace smile::recording {

/// Marked points of a recording over time, for people to see.
class MarkerTrack {
 public:
  explicit MarkerTrack(const Recording& recording);

  /// Returns the points visible at a tick, in the world [m].
  const std::vector<Vector3>& At(std::uint64_t tick) const;

 private:
  std::vector<std::pair<std::uint64_t, std::vector<Vector3>>> changes_;  ///< by tick; none at first
};

}  // namespace smile::recording
