#pragma once

#include <optional>
#include <span>
#include <string>

#include "motion/joint_trajectory.h"
#include "physics/articulation_probe.h"
#include "robot/robot_model.h"

namespace smile::motion {

/// When a motion stops being one that a robot can make, and why.
struct InvalidMoment {
  double seconds = 0;  ///< since the trajectory's start
  std::string reason;  ///< `left_e1: velocity is 2 rad/s, expected at most 1.5 rad/s`,
                       ///< `left_wrist would touch base`

  bool operator==(const InvalidMoment&) const = default;
};

/// The first moment of a trajectory that breaks a limit of position, velocity or acceleration, or
/// at which links touch each other, the base or the environment. Limits are looked at exactly,
/// touching wherever a joint has moved by 0.02 rad (or 0.02 m). A broken limit is told at its worst
/// moment between the two points where that happens first.
///
/// @param trajectory  its joints are named as in the model.
/// @param q_others    one value per joint of the robot: where those stand that do not move.
/// @param probe       made of the same model.
/// @returns nullopt when all of it is valid.
/// @throws std::invalid_argument if a joint is unknown, or the trajectory is none; see
///         CheckLimits().
std::optional<InvalidMoment> FirstInvalid(const robot::RobotModel& model,
                                          const JointTrajectory& trajectory,
                                          std::span<const double> q_others,
                                          physics::ArticulationProbe* probe);

}  // namespace smile::motion
