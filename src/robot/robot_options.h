#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace smile::robot {

/// Options for reading a URDF.
struct RobotReaderOptions {
  /// File that names arms, grippers, head and poses; empty: `NAME.robot.json` beside `NAME.urdf`,
  /// if it exists.
  std::filesystem::path side_file;
  /// Contents of a side file that is used instead of any file; it is kept as one beside the URDF.
  std::optional<std::string> side_file_text;
  /// Pose in which the robot begins if its side file contains it, instead of the one named there;
  /// the kept side file says so.
  std::string start_pose;
  /// Folders with packages: `package://PKG/…` is searched in the folder `PKG` of each, and in those
  /// of that name.
  std::vector<std::filesystem::path> package_roots;
  /// Gripper of the side file, with its choices: `electric-narrow-3`; empty: the default one.
  std::string gripper;
  /// False leaves out the shipped appearance that the side file names, for planning, which draws
  /// nothing.
  bool has_appearance = true;
  /// False leaves out all shapes, so that no mesh is needed: links, joints, frames and arms remain.
  bool has_shapes = true;
};

/// A file that a robot was read from. All of them in one folder, under these names, are the robot
/// again.
struct RobotFile {
  std::string name;  ///< in that folder: `baxter.urdf`, `packages/PKG/meshes/arm.stl`
  std::shared_ptr<const std::string> bytes;  ///< shared, since robots are copied and files large
};

/// Returns the bytes of a kept file of a robot; nullopt if there is no such file.
/// @param name  as RobotFile::name: never leads out of the folder.
using OpenRobotFile =
    std::function<std::optional<std::string>(const std::string& name, std::size_t max_bytes)>;

}  // namespace smile::robot
