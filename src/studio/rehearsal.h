#pragma once

#include <memory>
#include <optional>

#include "sim/simulation.h"

namespace smile::studio {

/// Copy of the world on which the effects of commands are tried. The world itself is not changed.
class Rehearsal {
 public:
  /// Returns the copy in the present state of the simulation; valid until the next call.
  sim::Simulation& CopyOf(const sim::Simulation& simulation);
  /// Returns the reason why a command to hands, objects or robot would be refused; nullopt if it
  /// would be accepted.
  std::optional<sim::Refusal> Try(const sim::Command& command, const sim::Simulation& simulation);
  /// Forgets the copy, before the simulation is replaced.
  void Reset() { copy_.reset(); }

 private:
  std::unique_ptr<sim::Simulation> copy_;  ///< of the same scene and robot
};

}  // namespace smile::studio
