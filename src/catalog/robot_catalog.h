#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/urdf_reader.h"

namespace smile::catalog {

/// A robot that is known by name.
struct CatalogEntry {
  std::string name;
  std::filesystem::path urdf;
  bool is_shipped = false;  ///< with SMILE; otherwise the user added it

  bool operator==(const CatalogEntry&) const = default;
};

/// Returns the folder of the robots that the user added, each in a folder of its name:
/// `$XDG_DATA_HOME/smile/robots`, or `~/.local/share/smile/robots`.
/// @throws std::runtime_error if neither variable is set.
std::filesystem::path UserRobotFolder();

/// Returns all robots by name, shipped ones first.
std::vector<CatalogEntry> AllRobots();

/// Files of a robot.
struct RobotSource {
  std::filesystem::path urdf;
  /// The side file that ships for this description, see FindKnownRobot(); empty if the robot has
  /// its own, or none is known.
  std::filesystem::path side_file;
};
/// Finds a robot.
/// @param name_or_path  a known name, or the path of a URDF: with a `/`, with the extension
///                      `.urdf`, or of a file.
/// @throws std::invalid_argument if the name is unknown.
RobotSource FindRobot(const std::string& name_or_path);

/// Throws std::invalid_argument unless a robot of this name can be added: a letter, then letters,
/// digits, `_` or `-`, and no robot has it.
void CheckNewName(const std::string& name);
/// Adds a robot to the user's folder.
/// @param files  of its reading, the URDF first; they are renamed to NAME.urdf and NAME.robot.json.
/// @returns the folder.
/// @throws std::runtime_error if the files cannot be written.
std::filesystem::path AddRobot(const std::string& name, const std::vector<robot::RobotFile>& files);

}  // namespace smile::catalog
