#include "studio/rehearsal.h"

namespace smile::studio {

sim::Simulation& Rehearsal::CopyOf(const sim::Simulation& simulation) {
  // Kept between calls, since compiling a world costs far more than restoring its state. Restore()
  // also follows objects that were added later.
  if (!copy_) copy_ = std::make_unique<sim::Simulation>(simulation.start_model());
  copy_->Restore(simulation.Save());
  return *copy_;
}

std::optional<sim::Refusal> Rehearsal::Try(const sim::Command& command,
                                           const sim::Simulation& simulation) {
  return CopyOf(simulation).Apply(command);
}

}  // namespace smile::studio
