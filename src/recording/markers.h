#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "recording/recording.h"

namespace smile::recording {

/// The points that were marked for people during a recording.
class MarkerTrack {
 public:
  explicit MarkerTrack(const Recording& recording);

  /// Those to be seen at a tick [m].
  const std::vector<Vector3>& At(std::uint64_t tick) const;

 private:
  std::vector<std::pair<std::uint64_t, std::vector<Vector3>>> changes_;  ///< by tick; none at first
};

}  // namespace smile::recording
