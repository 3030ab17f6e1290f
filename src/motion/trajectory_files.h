#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// Returns CSV like the files of Rethink Robotics' joint_recorder: `time,left_s0,…`, one line per
/// point, in seconds and radians; gripper openings are in meters, where theirs are in percent.
/// Without velocities.
std::string ToCsv(const JointTrajectory& trajectory);

/// Returns JSON with the fields of a trajectory_msgs/JointTrajectory, also in radians and meters.
/// Source: ROS 1, common_msgs, trajectory_msgs/msg/JointTrajectory.msg, JointTrajectoryPoint.msg.
std::string ToRosJson(const JointTrajectory& trajectory);

/// Reads the output of ToCsv(); velocities are computed from positions.
/// @param file  as the user named it, for messages.
/// @throws InputError with all findings.
JointTrajectory ParseTrajectoryCsv(std::string_view text, const std::string& file);
/// Reads the output of ToRosJson(); the header, and the velocities of all points, may be missing.
/// @throws InputError with the first finding.
JointTrajectory ParseTrajectoryRosJson(std::string_view text, const std::string& file);

/// Reads a `.csv` or `.json` file.
/// @throws InputError with all findings; std::runtime_error if the file cannot be read.
JointTrajectory ReadTrajectory(const std::filesystem::path& path);

}  // namespace smile::motion
