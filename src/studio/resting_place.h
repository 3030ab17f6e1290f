#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "sim/simulation.h"

namespace smile::studio {

/// Tries on a copy of the world what would become of a thing if it were let go of.
class RestingPlace {
 public:
  /// Where the held object comes to rest, or is six seconds later; nullopt if it falls off the
  /// table or the hand is empty. The simulation is not changed.
  std::optional<RigidTransform> Find(const sim::Simulation& simulation, sim::HandName hand);
  /// How much of the world's time was simulated to find the last one.
  std::uint64_t ticks_tried() const { return ticks_tried_; }
  /// The simulation will be another one.
  void Forget() { copy_.reset(); }

 private:
  std::unique_ptr<sim::Simulation> copy_;  ///< of the same scene and robot
  std::uint64_t ticks_tried_ = 0;
};

}  // namespace smile::studio
