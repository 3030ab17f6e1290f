#pragma once

#include <filesystem>

#include "robot/robot_model.h"

namespace smile::robot {

/// Reads a robot from a URDF file and, where there is one, from the side file beside it:
/// `NAME.robot.json` for `NAME.urdf` names arms, grippers, head, poses and links that may touch.
///
/// Supported are boxes, cylinders and spheres with plain colors, and revolute, prismatic and fixed
/// joints. A link behind a fixed joint becomes part of the moving link that carries it: mass,
/// shapes, pictures; its name stays as a frame. Links come depth first, siblings by joint name.
/// Elements URDF does not define (of simulators, transmissions) are passed over.
///
/// The files are not trusted: sizes are bounded, numbers finite, every moving link has a mass and
/// a positive definite inertia.
///
/// @throws InputError with the first finding: file, line, element, what was found and expected.
/// @throws std::runtime_error when a file cannot be read.
/// May be called from any thread; calls wait for each other.
RobotModel ReadRobot(const std::filesystem::path& urdf_path);

}  // namespace smile::robot
