#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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

/// Gives the bytes of one of the files that were kept of a robot; nullopt when there is none.
/// @param name  as RobotFile::name: never leads out of the folder by itself.
using OpenRobotFile =
    std::function<std::optional<std::string>(const std::string& name, std::size_t max_bytes)>;

}  // namespace smile::robot
