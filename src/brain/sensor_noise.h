#pragma once

#include <cstdint>

#include "brain/brain_values.h"

namespace smile::brain {

/// How far what a program senses is from the truth: standard deviations of Gaussian noise. The
/// world and its recording know nothing of it.
struct SensorNoise {
  double joints = 0;  ///< of joint angles [rad]
  double image = 0;   ///< of each color of each pixel [1 = full brightness]
  double depth = 0;   ///< of depths, where something is seen [units]
  std::uint64_t seed = 0;

  bool operator==(const SensorNoise&) const = default;
};

/// The same seed, tick and sensor, the same noise, on any machine with the same C library.
void AddNoise(const SensorNoise& noise, std::uint64_t tick, Sensor* sensor);

}  // namespace smile::brain
