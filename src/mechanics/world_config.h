#pragma once

namespace smile::mechanics {

/// Parameters of joint motors; measured values, see docs/decisions/physics.md.
struct MotorConfig {
  /// Fraction of the position error that is corrected in each physics step.
  double position_gain = 0.1;
  /// The reference leads the joint by at most this: a blocked arm stays gentle and resumes without
  /// a jump.
  double max_lead_angle = 0.05;    ///< of a revolute joint [rad]
  double max_lead_length = 0.002;  ///< of a prismatic one [m]
  /// Multiple of the listed effort that motors may use: velocity commands arrive without
  /// acceleration limits, which the real controller would smooth. It is 1 while they bear an
  /// overload, see WeldSpec::holds_up.
  double effort_scale = 4.0;

  bool operator==(const MotorConfig&) const = default;
};

/// Parameters of the simulation; docs/decisions/physics.md explains how they were found.
struct WorldConfig {
  double step_seconds = 1.0 / 480;
  double gravity = 9.81;  ///< along -z [m/s2]
  int solver_iterations = 20;
  double sleep_after_seconds = 1.0;  ///< an island at rest for this long falls asleep
  double sleep_linear_speed = 0.03;  ///< at rest below this speed [m/s]
  double sleep_angular_speed = 0.3;  ///< and below this one [rad/s]
  double damping = 0.2;              ///< fraction of a velocity lost per second
  /// False for physics version 1, in which a body that comes free in a hole of its own size jams.
  bool eases_close_fits = true;
  /// False for physics versions 1 and 2, in which every bounding box is 2 cm larger on all sides: a
  /// body that moves keeps those within 4 cm awake.
  bool has_close_bounds = true;
  /// False for physics versions 1 and 2, in which the hash of a state goes through all bodies in
  /// order. Otherwise it contains the sum of their hashes, of which those of sleepers are known.
  bool sums_hashes = true;
  /// False for physics versions 1 to 4, with Bullet's contacts between bodies: blocks stick to a
  /// plate that tilts, stacks slide on a slope, and high stacks creep.
  bool has_firm_contacts = true;
  /// False for physics versions 1 to 4, in which the motors of all joints take part in the
  /// iterations of the solver.
  bool moves_free_trees = true;
  /// False for physics versions 1 to 5, in which contacts find the weight of a stack by sweeps
  /// alone: ten blocks sink by 0.1 mm.
  bool finds_loads = true;
  MotorConfig motor;

  bool operator==(const WorldConfig&) const = default;
};

}  // namespace smile::mechanics
