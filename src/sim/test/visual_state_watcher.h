#pragma once

#include <gtest/gtest.h>

#include <random>

#include "sim/simulation.h"

namespace smile::sim {

/// Returns the visual state of a simulation, computed from everything.
inline scene::VisualState ComputedVisualState(const Simulation& simulation) {
  return simulation.model().VisualStateOf(
      simulation.tabletop().scene_state(),
      simulation.robot() != nullptr ? simulation.robot()->positions() : std::vector<double>(),
      simulation.face_expression());
}

/// Listener that compares a simulation's visual state with the computed one, after commands, moves
/// and ticks that it chooses at random.
class VisualStateWatcher : public Listener {
 public:
  /// @param mean_gap  number of changes per comparison, on average.
  VisualStateWatcher(unsigned seed, unsigned mean_gap) : random_(seed), mean_gap_(mean_gap) {}

  void OnCommand(const Simulation& simulation, const Command&) override { Visit(simulation); }
  void OnMove(const Simulation& simulation, ActionId, ActionId) override { Visit(simulation); }
  void OnTick(const Simulation& simulation) override { Visit(simulation); }

  int num_comparisons() const { return num_comparisons_; }

 private:
  void Visit(const Simulation& simulation) {
    if (random_() % mean_gap_ != 0) return;
    ++num_comparisons_;
    EXPECT_EQ(simulation.visual_state(), ComputedVisualState(simulation))
        << "comparison " << num_comparisons_ << ", tick " << simulation.tick();
  }

  std::mt19937 random_;
  unsigned mean_gap_;
  int num_comparisons_ = 0;
};

}  // namespace smile::sim
