#pragma once

#include <array>
#include <string_view>

#include "robot/robot_model.h"

namespace smile::robot {

/// Adds what Baxter looks like to the pictures a robot's description has: shells, screen and
/// springs made by rule (see src/mesh/modeling.h), and a face for each mood. Both arms share their
/// meshes, and so do all robots of one program.
///
/// Links are found by Baxter's names. The classic gripper is drawn where its palm and its two box
/// fingers are; other grippers show what their own description says.
///
/// @throws std::invalid_argument naming the link of body, head or arms that is missing.
void AddBaxterLook(RobotModel* model);

/// What a side file may call a look.
inline constexpr std::array<std::string_view, 1> kLookNames{"baxter"};

}  // namespace smile::robot
