#pragma once

#include <optional>
#include <span>
#include <string>

#include "motion/articulation_probe.h"
#include "motion/joint_trajectory.h"
#include "robot/robot_model.h"

namespace smile::motion {

/// First moment of a motion that a robot cannot execute, and the reason.
struct InvalidMoment {
  double seconds = 0;  ///< since the trajectory's start
  std::string reason;  ///< `left_e1: velocity is 2 rad/s, expected at most 1.5 rad/s`,
                       ///< `left_wrist would touch base`

  bool operator==(const InvalidMoment&) const = default;
};

/// Returns the first moment at which a trajectory breaks a limit of position, velocity or
/// acceleration, or at which links touch each other, the base or the environment; nullopt if all of
/// it is valid. Limits are checked exactly, contacts each time a joint has moved by 0.02 rad (or
/// 0.02 m). A violated limit is reported at its worst moment between the two points where it first
/// occurs.
///
/// @param trajectory  its joints are named as in the model.
/// @param q_others    one value per joint of the robot: positions of joints that do not move.
/// @param probe       made of the same model.
/// @throws std::invalid_argument if a joint is unknown, or the trajectory is malformed; see
///         CheckLimits().
std::optional<InvalidMoment> FirstInvalid(const robot::RobotModel& model,
                                          const JointTrajectory& trajectory,
                                          std::span<const double> q_others,
                                          ArticulationProbe* probe);

}  // namespace smile::motion
