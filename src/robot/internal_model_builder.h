#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/internal_robot_file_set.h"
#include "robot/internal_urdf_parse.h"
#include "robot/robot_model.h"

namespace smile::robot::internal {

/// A URDF, or a part of a gripper that hangs on another link.
struct UrdfPart {
  FoundFile file;
  std::shared_ptr<const UrdfDocument> document;
  std::string prefix;  ///< before all names of links and joints
  std::string to;      ///< the link, prefix and all, that the part's root is; unused for the first
};

/// A joint that moves as another one does, as far as the file goes.
struct Mimic {
  std::string joint, master;
  double multiplier = 1, offset = 0;
};

/// A robot without what the side file says of it.
struct BuiltModel {
  RobotModel model;
  std::vector<Mimic> mimics;
  /// The roots of parts and the frames they are.
  std::vector<std::pair<std::string, int>> part_roots;
  std::vector<bool> is_used;  ///< of each part: the link it hangs on is there
};

/// Walks the tree of `parts[0]` and puts everything where it belongs; branches of the other parts
/// grow as if they stood in the same file.
/// @throws InputError
BuiltModel BuildModel(const std::vector<UrdfPart>& parts, RobotFileSet* files);

}  // namespace smile::robot::internal
