#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "physics/body.h"
#include "physics/joint.h"

// Which bodies hang together: around one of them, and for all of them.

namespace smile::physics {

/// The bodies as nodes, with an edge for each joint between two of them; welds are no edges.
class JointGraph {
 public:
  /// @param without  a joint that does not count.
  explicit JointGraph(std::span<const Joint> joints, JointId without = {});

  /// Returns the bodies that a path connects with this one, itself included, by id. Paths end at
  /// bodies for which `is_end` holds, which are among the result.
  std::vector<BodyId> ConnectedWith(BodyId start, const std::function<bool(BodyId)>& is_end) const;

 private:
  std::vector<std::pair<BodyId, BodyId>> edges_;  ///< in both directions, sorted
};

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
