#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/robot_placement.h"

namespace smile::catalog {

/// Options for reading a robot.
struct PlacingOptions {
  std::filesystem::path side_file;                   ///< empty: the robot's own, or the known one
  std::vector<std::filesystem::path> package_roots;  ///< folders with the packages of its meshes
  std::string gripper;                               ///< empty: the default one
  std::string start_pose;                            ///< see robot::RobotReaderOptions
  model::RobotBodyOptions body;
};

/// A robot at its place.
struct PlacedRobot {
  model::RobotPlacement placement;
  std::filesystem::path urdf;
  /// False if no file names its arms and grippers: it cannot be moved.
  bool has_side_file = true;
};

/// Finds and reads a robot; it stands where its side file places it, or at the default place.
/// @param name_or_path  see FindRobot().
/// @throws std::invalid_argument if the name is unknown; InputError if the files are faulty.
PlacedRobot PlaceRobot(const std::string& name_or_path, const PlacingOptions& options = {});

}  // namespace smile::catalog
