#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot/internal_model_builder.h"

namespace smile::robot::internal {

/// Measures the openings of jaws over the range of their drive, as the distance of two frames along
/// y of the tool, and the middles between them, and narrows that range to where they open from 0 or
/// more without a turning point. All joints but the drive and its followers are at 0 or at the
/// nearest limit.
///
/// @param pads  frame indices: on the left and on the right jaw.
/// @param tool  frame index.
/// @returns the complaint if they open by less than a millimeter.
std::optional<std::string> MeasureJaws(std::pair<int, int> pads, int tool, RobotModel* model,
                                       Gripper* gripper);

/// Makes joints follow others, and narrows the limits of each leader to those that its followers
/// can follow. A joint that mimics a follower gets the leader of that one.
/// @returns the complaint about a joint that does not exist, or about limits or loops that leave no
///          motion.
std::optional<std::string> AddMimics(const std::vector<Mimic>& mimics, RobotModel* model);

}  // namespace smile::robot::internal
