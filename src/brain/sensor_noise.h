#pragma once

#include <cstdint>

#include "brain/brain_values.h"

namespace smile::brain {

/// Sensor noise: standard deviations of Gaussian noise. It does not affect the world and its
/// recording.
struct SensorNoise {
  double joints = 0;  ///< of joint angles [rad]
  double image = 0;   ///< of each color of each pixel [1 = full brightness]
  double depth = 0;   ///< of depths, except background [units]
  std::uint64_t seed = 0;

  bool operator==(const SensorNoise&) const = default;
};

/// Adds noise. Equal seed, tick and sensor give equal noise, on any machine with the same C
/// library.
void AddNoise(const SensorNoise& noise, std::uint64_t tick, Sensor* sensor);

}  // namespace smile::brain
