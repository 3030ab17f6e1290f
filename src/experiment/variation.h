#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/json_node.h"
#include "brain/sensor_noise.h"

namespace smile::experiment {

struct Range {
  double low = 0, high = 0;

  bool operator==(const Range&) const = default;
};

/// Choices from which the conditions of each generated episode are drawn. No list is empty.
struct VariationChoices {
  std::vector<std::string> scenes, levels, eyes;
  Range joints, image, depth;  ///< standard deviations of the noise, see brain::SensorNoise
};

/// Conditions of an attempt, beside the layout.
struct Variation {
  std::string scene;  ///< as the user wrote it
  std::string level;  ///< of the layout
  std::string eye;    ///< camera of the brain
  brain::SensorNoise noise;

  bool operator==(const Variation&) const = default;
};

/// Draws the conditions of a seed. Each one depends on the seed and its own choices only: to
/// add a level changes no noise.
Variation DrawVariation(const VariationChoices& choices, std::uint64_t seed);

Json ToJson(const Variation& variation);

/// Returns the variation that ToJson() wrote.
/// @throws InputError if it is damaged.
Variation VariationIn(const JsonNode& node);

}  // namespace smile::experiment
