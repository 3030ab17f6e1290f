#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/robot_model.h"
#include "robot/robot_options.h"

namespace smile::robot {

/// A robot, and what it was read from.
struct RobotReading {
  RobotModel model;
  bool has_side_file = false;
  std::string gripper;           ///< as chosen, with all its choices; empty when there is no choice
  std::optional<double> gap;     ///< from its base to the table, if it says so [m]
  std::optional<double> height;  ///< of its base above the table top, if it says so [m]
  std::vector<RobotFile> files;  ///< the URDF first
};

/// Reads a robot from a URDF file and its side file, which names arms, grippers, head, poses and
/// links that may touch; docs/robot.md describes it.
///
/// Supported are boxes, cylinders, spheres and meshes with plain colors, and revolute, continuous,
/// prismatic and fixed joints. A link behind a fixed joint becomes part of the moving link that
/// carries it: mass, shapes, pictures; its name stays as a frame. Links come depth first, siblings
/// by joint name. A gripper of the side file is one more branch. A mesh collides as a few convex
/// pieces. Elements URDF does not define (of simulators, transmissions) are passed over.
///
/// The files are not trusted: sizes are bounded, numbers finite, every moving link has a mass and
/// a positive definite inertia, and no file is opened but those in the folders of the two files and
/// in package roots, links followed. A file that is not where it is said to be may lie below the
/// URDF under its RobotFile::name: so kept robots can be read, too.
///
/// @throws InputError with the first finding: file, line, element, what was found and expected.
/// @throws std::runtime_error when a file cannot be read.
/// May be called from any thread; calls wait for each other.
RobotReading LoadRobot(const std::filesystem::path& urdf_path,
                       const RobotReaderOptions& options = {});

/// The model alone.
RobotModel ReadRobot(const std::filesystem::path& urdf_path,
                     const RobotReaderOptions& options = {});

/// Reads a robot from the files kept of it.
/// @param urdf_path  of the URDF among them; its folder is for messages only.
RobotReading LoadKeptRobot(const std::filesystem::path& urdf_path, const std::string& gripper,
                           const OpenRobotFile& open);

}  // namespace smile::robot
