#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/robot_model.h"

namespace smile::robot {

/// What a URDF is read with.
struct RobotReaderOptions {
  /// What names arms, grippers, head and poses; empty: `NAME.robot.json` beside `NAME.urdf`, where
  /// there is one.
  std::filesystem::path side_file;
  /// Folders with packages: `package://PKG/…` is looked for in the folder `PKG` of each, and in
  /// those of that name.
  std::vector<std::filesystem::path> package_roots;
  /// One of the grippers the side file offers, with its choices: `electric-narrow-3`; empty: the
  /// usual one.
  std::string gripper;
  /// False leaves out the shipped look that the side file names, for planning, which shows nothing.
  bool has_look = true;
};

/// A file a robot was read from, for whoever keeps the robot: all of them in one folder, under
/// these names, are the robot again.
struct RobotFile {
  std::string name;  ///< in that folder: `baxter.urdf`, `packages/PKG/meshes/arm.stl`
  std::shared_ptr<const std::string> bytes;  ///< shared, since robots are copied and files large
};

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

/// Gives the bytes of one of the files that were kept of a robot; nullopt when there is none.
/// @param name  as RobotFile::name: never leads out of the folder by itself.
using OpenRobotFile =
    std::function<std::optional<std::string>(const std::string& name, std::size_t max_bytes)>;

/// Reads a robot from the files kept of it.
/// @param urdf_path  of the URDF among them; its folder is for messages only.
RobotReading LoadKeptRobot(const std::filesystem::path& urdf_path, const std::string& gripper,
                           const OpenRobotFile& open);

}  // namespace smile::robot
