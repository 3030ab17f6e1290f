#pragma once

#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "mechanics/joint.h"

// Connected bodies: around one of them, and for all of them.

namespace smile::mechanics {

/// Graph of bodies (nodes) and joints between them (edges). Welds are not edges.
class JointGraph {
 public:
  /// @param without  a joint to leave out.
  explicit JointGraph(std::span<const Joint> joints, JointId without = {});

  /// Returns the bodies that are connected with this one, itself included, by id. Paths end at
  /// bodies for which `is_end` is true; those are part of the result.
  std::vector<BodyId> ConnectedWith(BodyId start, const std::function<bool(BodyId)>& is_end) const;

 private:
  std::vector<std::pair<BodyId, BodyId>> edges_;  ///< in both directions, sorted
};

/// Returns all bodies connected with this one, itself included, without static ones, by id. Static
/// bodies end the search: what is fixed to the same table is not one assembly.
/// @param without  a joint to leave out.
std::vector<BodyId> AssemblyOf(BodyId id, std::span<const Joint> joints, JointId without,
                               const std::function<bool(BodyId)>& is_static);
/// Returns true if a joint other than `without` ties the assembly of a body to a static body.
bool IsAnchored(BodyId id, std::span<const Joint> joints, JointId without,
                const std::function<bool(BodyId)>& is_static);

/// Connected groups of bodies, computed for all bodies at once. A static body belongs to no group
/// and connects no others; groups joined to it are anchored.
class JointGroups {
 public:
  struct Member {
    BodyId body;
    bool is_static;
  };
  /// @param bodies  by id.
  /// @param only_fixed  true to count only fixed joints; welds never count.
  JointGroups(std::span<const Member> bodies, std::span<const Joint> joints, bool only_fixed);

  /// Returns the number of the body's group: below the number of bodies, the same for the whole
  /// group.
  int group_of(BodyId id) const { return parents_[IndexOf(id)]; }
  bool is_anchored(int group) const { return is_anchored_[group]; }

 private:
  int IndexOf(BodyId id) const;
  int FindRoot(int index);

  std::vector<BodyId> ids_;
  std::vector<int> parents_;       ///< in the end the root of each body, the first of its group
  std::vector<bool> is_anchored_;  ///< of each root; also of static bodies, which form no group
};

}  // namespace smile::mechanics
