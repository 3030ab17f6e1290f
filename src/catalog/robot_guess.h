#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "robot/robot_options.h"

namespace smile::catalog {

/// A side file made for a URDF that has none.
struct RobotGuess {
  std::string side_file;           ///< text of the file
  std::vector<std::string> notes;  ///< what was found and assumed, a line each
};

/// Progress of long work: done of total; returns false to cancel.
using Progress = std::function<bool(double done, double total)>;

/// Finds arms, tools, grippers, an eye, links that touch by construction, a ready pose and a place
/// at the table by itself.
///
/// Arms, tools and grippers come from the tree of joints, names of links and joints, and shapes.
/// Links touch by construction if they are neighbors, belong to one gripper, or overlap in most of
/// some hundred random configurations. The pose `ready` has each tool over the table, pointing
/// down, without overlaps, by inverse kinematics. The robot stands on the table, or behind it if
/// its arms begin high above its foot.
///
/// @param options  package roots are used.
/// @throws InputError if the URDF is not one, or has no arm.
/// @throws std::runtime_error if `progress` cancels.
/// The same files give the same answer.
RobotGuess GuessRobot(const std::filesystem::path& urdf, const robot::RobotReaderOptions& options,
                      const Progress& progress = nullptr);

}  // namespace smile::catalog
