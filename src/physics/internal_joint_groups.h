#pragma once

#include <memory>
#include <vector>

#include "physics/body.h"
#include "physics/joint.h"

namespace smile::physics {

/// Which bodies hang together, for all of them at once. A static body belongs to no group, and
/// nothing hangs together through it; groups it holds are anchored.
class JointGroups {
 public:
  /// @param bodies  by id.
  /// @param only_fixed  other joints than fixed ones do not count; welds never do.
  JointGroups(const std::vector<std::unique_ptr<Body>>& bodies, const std::vector<Joint>& joints,
              bool only_fixed);

  /// A number below the number of bodies, the same for all of a group.
  int group_of(BodyId id) const { return parents_[IndexOf(id)]; }
  bool is_anchored(int group) const { return is_anchored_[group]; }

 private:
  int IndexOf(BodyId id) const;
  int FindRoot(int index);

  std::vector<BodyId> ids_;
  std::vector<int> parents_;       ///< in the end of each its root, the first body of its group
  std::vector<bool> is_anchored_;  ///< of each root; of static bodies, which are alone, too
};

}  // namespace smile::physics
