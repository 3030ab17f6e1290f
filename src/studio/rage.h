#pragma once

#include <random>

#include "sim/simulation.h"

namespace smile::studio {

/// The robot clears the table in a rage, as it did in the original: in a copy of the world, so that
/// all is as before when it is over.
class Rage {
 public:
  static constexpr int kTicks = 10 * sim::kTicksPerSecond;

  /// There is a robot with arms.
  static bool IsPossible(const sim::Simulation& simulation);

  /// To be made where it is possible.
  explicit Rage(const sim::Simulation& simulation);

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
