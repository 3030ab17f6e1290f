#pragma once

#include <string>
#include <vector>

#include "robot/robot_model.h"

namespace smile::catalog::internal {

/// A chain of joints that may be an arm.
struct ArmChain {
  std::string name;
  std::vector<int> joints;  ///< joint indices from the shoulder to the wrist
  int palm = -1;            ///< link that the last joint carries
  std::vector<int> beyond;  ///< links beyond the palm: those of a gripper or hand
};

/// Parts of a robot, as far as its tree of joints shows them.
struct Structure {
  std::vector<ArmChain> arms;
  std::vector<int> torso;  ///< joints that carry several arms
};

/// Finds the arms of a robot: chains of three joints or more, or of two if there are no longer
/// ones. A chain ends where its links branch into fingers, or where the names of joints or links
/// say that a gripper begins. Where it branches into several chains of this length, it was a torso.
/// @param model  read without a side file's arms.
Structure StructureOf(const robot::RobotModel& model);

/// Returns the link that carries each link, or the link itself, and whether one carries another.
bool IsCarriedBy(const robot::RobotModel& model, int link, int carrier);

/// Returns true if a name contains one of these words, in any case of letters.
bool HasWord(const std::string& name, std::initializer_list<const char*> words);

}  // namespace smile::catalog::internal
