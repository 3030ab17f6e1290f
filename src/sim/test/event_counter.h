#pragma once

#include <map>

#include "sim/simulation.h"

namespace smile::sim {

/// Counts events by kind.
struct EventCounter : Listener {
  void OnEvent(const Simulation&, const Event& event) override { ++num_events[event.kind]; }
  std::map<EventKind, int> num_events;
};

}  // namespace smile::sim
