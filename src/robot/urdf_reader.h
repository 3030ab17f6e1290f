#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/robot_model.h"
#include "robot/robot_options.h"

namespace smile::robot {

/// A robot and the files it was read from.
struct RobotReading {
  RobotModel model;
  bool has_side_file = false;
  std::string gripper;           ///< as chosen, with all its choices; empty if there is no choice
  std::optional<double> gap;     ///< from its base to the table, if specified [m]
  std::optional<double> height;  ///< of its base above the table top, if specified [m]
  std::vector<RobotFile> files;  ///< the URDF first
};

/// Reads a robot from a URDF file and its side file, which names arms, grippers, head, poses and
/// links that may touch; docs/robot.md describes it.
///
/// Supported are boxes, cylinders, spheres and meshes with plain colors, and revolute, continuous,
/// prismatic and fixed joints. A link behind a fixed joint becomes part of the moving link that
/// carries it: mass, shapes, visuals; its name remains as a frame. Links are ordered depth first,
/// siblings by joint name. A gripper of the side file is one more branch. A mesh collides as a few
/// convex pieces. Elements that URDF does not define (of simulators, transmissions) are ignored.
///
/// The files are not trusted: sizes are bounded, numbers finite, each moving link has a mass and a
/// positive definite inertia, and no file is opened outside the folders of the two files and the
/// package roots, after following links. A file that is missing at its stated place may be below
/// the URDF under its RobotFile::name: kept robots can therefore be read, too.
///
/// @throws InputError with the first finding: file, line, element, what was found and expected.
/// @throws std::runtime_error if a file cannot be read.
/// Thread-safe; calls wait for each other.
RobotReading LoadRobot(const std::filesystem::path& urdf_path,
                       const RobotReaderOptions& options = {});

/// Returns the model only.
RobotModel ReadRobot(const std::filesystem::path& urdf_path,
                     const RobotReaderOptions& options = {});

/// Reads a robot from its kept files.
/// @param urdf_path  of the URDF among them; its folder is for messages only.
RobotReading LoadKeptRobot(const std::filesystem::path& urdf_path, const std::string& gripper,
                           const OpenRobotFile& open);

}  // namespace smile::robot
