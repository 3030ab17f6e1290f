#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/json.h"
#include "base/json_node.h"
#include "experiment/range.h"
#include "sim/simulation.h"

namespace smile::experiment {

/// Choices from which disturbances are drawn.
struct DisturbanceChoices {
  double fraction = 0;       ///< of attempts that have one, 0 to 1
  Range seconds{3, 15};      ///< from the time at which the brain begins to act
  Range distance{0.2, 0.5};  ///< of the displacement, in any direction [units]

  bool operator==(const DisturbanceChoices&) const = default;
};

/// Disturbance of a run: a hand of the demonstrator displaces a loose object. It is done by
/// commands, so a recording of the run replays as it was.
struct Disturbance {
  double seconds = 0;        ///< from the time at which the brain begins to act
  double choice = 0;         ///< of the object, among those that are loose then: 0 to 1, without 1
  double direction_deg = 0;  ///< of the displacement, from x towards y
  double distance = 0;       ///< [units]

  bool operator==(const Disturbance&) const = default;
};

/// Draws a disturbance; nullopt for a seed without one.
std::optional<Disturbance> DrawDisturbance(const DisturbanceChoices& choices, std::uint64_t seed);

Json ToJson(const DisturbanceChoices& choices);
Json ToJson(const Disturbance& disturbance);
/// @throws InputError if it is damaged.
Disturbance DisturbanceIn(const JsonNode& node);

/// Applies a disturbance to a simulation. An object is loose if nothing holds it, it stands on the
/// table, nothing stands on it, and it is not joined to others; while there is none, it waits.
class Disturber {
 public:
  explicit Disturber(const Disturbance& disturbance) : disturbance_(disturbance) {}

  /// Applies the commands that are due before a tick.
  /// @param acting_ticks  time since the brain began to act.
  void Advance(std::uint64_t acting_ticks, sim::Simulation* simulation);

  /// Returns {tick, object, from, to} with positions in units; null if it did nothing.
  Json json() const { return done_; }

 private:
  bool TakeObject(sim::Simulation* simulation);

  Disturbance disturbance_;
  enum class Phase { kWaiting, kMoving, kOver } phase_ = Phase::kWaiting;
  std::uint64_t last_tick_ = 0;  ///< of the motion
  Json done_;
};

}  // namespace smile::experiment
