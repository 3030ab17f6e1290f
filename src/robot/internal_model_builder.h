#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "robot/internal_robot_file_set.h"
#include "robot/internal_urdf_parse.h"
#include "robot/robot_model.h"

namespace smile::robot::internal {

/// A URDF, or a part of a gripper that is attached to another link.
struct UrdfPart {
  FoundFile file;
  std::shared_ptr<const UrdfDocument> document;
  std::string prefix;  ///< put before all names of links and joints
  /// link, with its prefix, that the part's root merges with; unused for the first
  std::string to;  ///<
};

/// A joint that follows another one (URDF's <mimic>).
struct Mimic {
  std::string joint, master;
  double multiplier = 1, offset = 0;
};

/// A robot before the side file is applied.
struct BuiltModel {
  RobotModel model;
  std::vector<Mimic> mimics;
  /// Names of the parts' roots and the frames they merge with.
  std::vector<std::pair<std::string, int>> part_roots;
  std::vector<bool> is_used;  ///< of each part: the link it is attached to exists
};

/// Builds a robot from the tree of `parts[0]`; branches of the other parts are added as if they
/// were in the same file.
/// @param has_shapes  false leaves out collision shapes and visuals.
/// @throws InputError
BuiltModel BuildModel(const std::vector<UrdfPart>& parts, bool has_shapes, RobotFileSet* files);

}  // namespace smile::robot::internal
