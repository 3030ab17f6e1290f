#pragma once

#include <cstdint>

namespace smile::sim {

/// One tick = 1/60 s = 8 physics steps.
inline constexpr int kTicksPerSecond = 60;
inline constexpr int kStepsPerTick = 8;
/// Returns the duration of some ticks [s].
inline double SecondsOf(std::uint64_t ticks) {
  return static_cast<double>(ticks) / kTicksPerSecond;
}

}  // namespace smile::sim
