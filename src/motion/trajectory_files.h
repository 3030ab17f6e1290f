#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "motion/joint_trajectory.h"

namespace smile::motion {

/// As files of Rethink Robotics' joint_recorder: `time,left_s0,…`, one line a point, seconds and
/// radians; the opening of a gripper in meters, where theirs has percent. No velocities.
std::string ToCsv(const JointTrajectory& trajectory);

/// JSON with the fields of a trajectory_msgs/JointTrajectory, which holds radians and meters, too.
/// Source: ROS 1, common_msgs, trajectory_msgs/msg/JointTrajectory.msg, JointTrajectoryPoint.msg.
std::string ToRosJson(const JointTrajectory& trajectory);

/// Reads what ToCsv() writes; the velocities are made from the positions.
/// @param file  as the user named it, for messages.
/// @throws InputError with all findings.
JointTrajectory ParseTrajectoryCsv(std::string_view text, const std::string& file);
/// Reads what ToRosJson() writes; velocities may be missing from all points, and the header.
/// @throws InputError naming the first finding.
JointTrajectory ParseTrajectoryRosJson(std::string_view text, const std::string& file);

/// Reads a `.csv` or `.json` file.
/// @throws InputError with all findings; std::runtime_error if the file cannot be read.
JointTrajectory ReadTrajectory(const std::filesystem::path& path);

}  // namespace smile::motion
