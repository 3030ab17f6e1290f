#pragma once

#include <vector>

#include "interchange/exported_world.h"

namespace smile::interchange {

/// A body in the tree of another one, which carries it by a joint.
struct TreeNode {
  int parent = -1;  ///< index of a body; -1: a root, which is free or static
  int joint = -1;   ///< index of the joint to the parent; -1 for roots
};

/// Trees of bodies, which formats for robots want in place of a list of joints.
struct JointForest {
  std::vector<TreeNode> nodes;  ///< one for each body
  std::vector<int> order;       ///< indices of bodies, parents before children
  std::vector<int> closing;     ///< indices of the joints that close loops
};

/// Returns the trees of a world's bodies. Static bodies are roots; then, bodies in their order.
JointForest ForestOf(const ExportedWorld& world);

/// Returns the bodies in groups that joints hold together, each group and the bodies within it in
/// the order of the world. Most bodies are a group by themselves.
std::vector<std::vector<int>> GroupsOf(const ExportedWorld& world);

}  // namespace smile::interchange
