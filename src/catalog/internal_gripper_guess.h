#pragma once

#include <string>
#include <vector>

#include "base/json.h"
#include "catalog/internal_structure.h"

namespace smile::catalog::internal {

/// Tool and gripper of an arm, as members of a side file.
struct ToolGuess {
  std::string tool;               ///< name of a frame
  Json frames = Json::object();   ///< frames to add
  Json gripper = Json::object();  ///< members of the arm: `fingers`, `jaws` and `pads`, `suction`
  std::vector<std::string> notes;
};

/// Finds the tool frame of an arm and what its gripper is.
///
/// A tool frame with a usual name (`tcp`, `tool0`, …) is used if its z axis points out of the
/// gripper and, with fingers, its y axis across them; otherwise one is made from the shapes of the
/// links. Two links that slide apart are fingers. One joint with all that mimic it moves jaws, even
/// beside joints that nothing mimics; the places where the jaws meet are measured on their shapes.
/// Anything else is no known gripper: its joints are left to be turned one by one.
ToolGuess GuessTool(const robot::RobotModel& model, const ArmChain& arm);

}  // namespace smile::catalog::internal
