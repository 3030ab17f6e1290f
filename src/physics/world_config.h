#pragma once

#include "physics/articulation.h"

namespace smile::physics {

/// The numbers of the simulation; docs/decisions/physics.md documents how they were found.
struct WorldConfig {
  double step_seconds = 1.0 / 480;
  double gravity = 9.81;  ///< along -z [m/s2]
  int solver_iterations = 20;
  double sleep_after_seconds = 1.0;  ///< at rest for this long, an island falls asleep
  double sleep_linear_speed = 0.03;  ///< below this it counts as at rest [m/s]
  double sleep_angular_speed = 0.3;  ///< [rad/s]
  double damping = 0.2;              ///< fraction of a velocity lost per second
  /// False: what comes free in a hole of its own size jams, as in recordings of physics version 1.
  bool eases_close_fits = true;
  MotorConfig motor;

  bool operator==(const WorldConfig&) const = default;
};

}  // namespace smile::physics
