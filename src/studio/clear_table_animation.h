#pragma once

#include <random>

#include "sim/simulation.h"

namespace smile::studio {

/// Clear-table animation: the robot sweeps the table as in the original program, in a copy of the
/// world, so that nothing has changed afterwards.
class ClearTableAnimation {
 public:
  static constexpr int kTicks = 10 * sim::kTicksPerSecond;

  /// Returns true if the simulation has a robot with arms.
  static bool IsPossible(const sim::Simulation& simulation);

  /// Requires IsPossible().
  explicit ClearTableAnimation(const sim::Simulation& simulation);

  void Tick();
  bool is_over() const { return ticks_ >= kTicks; }
  const sim::Simulation& simulation() const { return copy_; }

 private:
  std::vector<double> RandomVelocities(int arm);

  sim::Simulation copy_;
  std::mt19937_64 random_{5566};  ///< the original's seed
  int ticks_ = 0;
};

}  // namespace smile::studio
