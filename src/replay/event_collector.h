#pragma once

#include <vector>

#include "sim/simulation.h"

namespace smile::replay {

/// Collects the events from each moment to the next, as in a trace.
class EventCollector : public sim::Listener {
 public:
  void OnEvent(const sim::Simulation&, const sim::Event& event) override {
    if (event.kind != sim::EventKind::kCommandRefused) events_.push_back(event);
  }
  void OnTick(const sim::Simulation&) override { events_.clear(); }

  const std::vector<sim::Event>& events() const { return events_; }
  /// Drops all events so far.
  void Clear() { events_.clear(); }

 private:
  std::vector<sim::Event> events_;
};

}  // namespace smile::replay
