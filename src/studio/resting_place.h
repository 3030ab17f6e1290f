#pragma once

#include <cstdint>
#include <optional>

#include "base/json.h"
#include "sim/simulation.h"
#include "studio/rehearsal.h"

namespace smile::studio {

/// What came of letting go of what a hand holds, on a copy of the world.
struct RestingAttempt {
  /// Where the object came to rest, or was after six seconds; nullopt if it fell off the table or
  /// the hand was empty.
  std::optional<RigidTransform> X_WB;
  std::uint64_t num_ticks = 0;  ///< that were simulated
};
RestingAttempt FindRestingPlace(const sim::Simulation& simulation, sim::HandName hand,
                                Rehearsal* rehearsal);

/// Answers where held objects would come to rest. As that costs up to six seconds of the world, it
/// is found out a few times a second, and the more rarely the longer it takes.
class RestingPlace {
 public:
  /// The answer to a request `resting_place`.
  /// @param step  counts up 60 times a second.
  Json Answer(const sim::Simulation& simulation, sim::HandName hand, std::uint64_t step,
              Rehearsal* rehearsal);
  /// The simulation will be another one.
  void Forget() { answer_ = nullptr; }

 private:
  Json answer_;  ///< the last; null before
  std::uint64_t step_ = 0, tick_ = 0, num_ticks_tried_ = 0;
};

}  // namespace smile::studio
