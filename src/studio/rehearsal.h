#pragma once

#include <memory>
#include <optional>

#include "sim/simulation.h"

namespace smile::studio {

/// A copy of the world, on which is tried what would come of something. The world itself is not
/// changed.
class Rehearsal {
 public:
  /// The copy as the simulation is now; it lasts until this is called again.
  sim::Simulation& CopyOf(const sim::Simulation& simulation);
  /// Why a command to hands, objects or robot would be refused; nullopt if it would not.
  std::optional<sim::Refusal> Try(const sim::Command& command, const sim::Simulation& simulation);
  /// The simulation will be another one.
  void Forget() { copy_.reset(); }

 private:
  std::unique_ptr<sim::Simulation> copy_;  ///< of the same scene and robot
};

}  // namespace smile::studio
