#pragma once

#include <cstdint>

namespace smile::mechanics {

/// A moment in the life of a World, to ask what has changed since. The default is before its begin.
/// Means nothing in another World.
struct Moment {
  std::int64_t period = 0;  ///< number of the period in which nothing happened
  int next_island = 0;      ///< number of the next island that is left out
  int num_removals = 0;     ///< of bodies, so far

  bool operator==(const Moment&) const = default;
};

}  // namespace smile::mechanics
