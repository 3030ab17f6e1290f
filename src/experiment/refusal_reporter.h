#pragma once

#include <set>
#include <string>

#include "experiment/callbacks.h"
#include "sim/simulation.h"

namespace smile::experiment {

/// Reports what was refused during ticks and so answers no command: a gripper that uses a tool in
/// the wrong place. Each reason is reported once, as a robot may try again at any time.
class RefusalReporter : public sim::Listener {
 public:
  /// @param callbacks  must outlive this.
  explicit RefusalReporter(const Callbacks* callbacks) : callbacks_(*callbacks) {}

  /// Ticks a simulation that this listens to.
  void Tick(sim::Simulation* simulation) {
    is_ticking_ = true;
    simulation->Tick();
    is_ticking_ = false;
  }
  void OnEvent(const sim::Simulation& simulation, const sim::Event& event) override;

 private:
  const Callbacks& callbacks_;
  bool is_ticking_ = false;
  std::set<std::string> reported_;
};

}  // namespace smile::experiment
