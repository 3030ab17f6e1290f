#pragma once

#include <string>
#include <string_view>

#include "robot/robot_model.h"

namespace smile::robot {

/// Adds a shipped appearance to the visuals of a robot: `robots/appearance/NAME.glb`, each piece
/// fixed to the link named by its node; pieces with a face expression are visible only with that
/// one.
///
/// Each appearance is loaded once per program: its meshes are large, never change, and cameras
/// identify them by their address.
///
/// @param name    `baxter` (shells, screen, springs, and a face for each expression) or `classic`
///                (the gripper of the 2015 program).
/// @param prefix  put before the names of links: `left_`.
/// @throws std::invalid_argument naming the link that is missing.
/// @throws std::runtime_error or InputError if the file is missing or damaged.
void AddAppearance(std::string_view name, const std::string& prefix, RobotModel* model);

}  // namespace smile::robot
