#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "base/json_node.h"
#include "brain/brain_values.h"
#include "brain/sensor_noise.h"
#include "experiment/disturbance.h"
#include "experiment/looks.h"
#include "experiment/range.h"

namespace smile::experiment {

/// Choices from which the conditions of each generated episode are drawn. No list is empty.
struct VariationChoices {
  std::vector<std::string> scenes, levels, eyes;
  Range joints, image, depth;  ///< standard deviations of the noise, see brain::SensorNoise
  LookChoices looks;
  std::map<std::string, std::vector<std::string>> colors;  ///< of objects, by scene; see ColorsOf()
  std::optional<Range> speed;  ///< factor of that of the brain's motions
  bool varies_order = false, varies_grasp = false, varies_path = false;  ///< of the brain
  DisturbanceChoices disturbance;
};

/// Conditions of an attempt, beside the layout.
struct Variation {
  std::string scene;  ///< as the user wrote it
  std::string level;  ///< of the layout
  std::string eye;    ///< camera of the brain
  brain::SensorNoise noise;
  Looks looks;
  brain::BehaviorVariation behavior;
  std::optional<Disturbance> disturbance;

  bool operator==(const Variation&) const = default;
};

/// Draws the conditions of a seed. Each one depends on the seed and its own choices only: to
/// add a level changes no noise.
Variation DrawVariation(const VariationChoices& choices, std::uint64_t seed);

/// Returns the ranges of everything but scene, level, eye and noise.
Json ToJson(const VariationChoices& choices);

Json ToJson(const Variation& variation);

/// Returns the variation that ToJson() wrote.
/// @throws InputError if it is damaged.
Variation VariationIn(const JsonNode& node);

/// Reads `looks`, `behavior` and `disturbance`, each of which may be missing or null.
/// @throws InputError if one is damaged.
void ReadChanges(const JsonNode& node, Variation* variation);

/// Returns the text that ParseChanges() reads; empty if nothing changes.
std::string ChangesText(const Variation& variation);

/// Returns the looks, behavior and disturbance of a text; empty for none.
/// @throws InputError, std::invalid_argument if it is not one.
Variation ParseChanges(const std::string& text);

}  // namespace smile::experiment
