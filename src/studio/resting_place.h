#pragma once

#include <cstdint>
#include <optional>

#include "base/json.h"
#include "sim/simulation.h"
#include "studio/rehearsal.h"

namespace smile::studio {

/// Result of releasing the held object on a copy of the world.
struct RestingAttempt {
  /// Pose at rest, or after six seconds; nullopt if the object fell off the table or the hand was
  /// empty.
  std::optional<RigidTransform> X_WB;
  std::uint64_t num_ticks = 0;  ///< that were simulated
};
RestingAttempt FindRestingPlace(const sim::Simulation& simulation, sim::HandName hand,
                                Rehearsal* rehearsal);

/// Predicts where held objects would come to rest. As that simulates up to six seconds, it is done
/// a few times a second, and less often the longer it takes.
class RestingPlace {
 public:
  /// Answers a request `resting_place`.
  /// @param step  counts up 60 times a second.
  Json Answer(const sim::Simulation& simulation, sim::HandName hand, std::uint64_t step,
              Rehearsal* rehearsal);
  /// Forgets the answer, before the simulation is replaced.
  void Reset() { answer_ = nullptr; }

 private:
  Json answer_;  ///< the last; null before
  std::uint64_t step_ = 0, tick_ = 0, num_ticks_tried_ = 0;
};

}  // namespace smile::studio
