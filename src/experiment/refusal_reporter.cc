#include "experiment/refusal_reporter.h"

#include <cstdio>

namespace smile::experiment {

void RefusalReporter::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  // The sender of a refused command has its answer.
  if (!is_ticking_ || event.kind != sim::EventKind::kCommandRefused) return;
  if (!reported_.insert(event.reason).second) return;
  char time[32];
  std::snprintf(time, sizeof(time), "%.2f", simulation.seconds());
  callbacks_.Say("warning: refused at " + std::string(time) + " s: " + event.reason);
}

}  // namespace smile::experiment
