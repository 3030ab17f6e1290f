#pragma once

#include <map>
#include <span>
#include <vector>

namespace smile::mechanics {

/// Order in which Bullet 3.24 solves the joints of an island if some joints are left out of its
/// world. It sorts all joints by their islands with a quicksort that is not stable, so that the
/// order of the joints of one island depends on all others. Source: `btAlignedObjectArray`.
class JointOrder {
 public:
  struct Entry {
    int joint = 0;   ///< id
    int island = 0;  ///< number of the joint's island, in the order of islands
  };

  bool is_complete() const { return left_out_.empty(); }
  bool IsLeftOut(int joint) const { return left_out_.contains(joint); }
  void LeaveOut(const Entry& entry) { left_out_.emplace(entry.joint, entry.island); }
  void Return(int joint) { left_out_.erase(joint); }

  /// Returns the place of each joint that is present, after all joints have been sorted.
  /// @param present  by id.
  std::vector<int> PlacesOf(std::span<const Entry> present) const;

 private:
  std::map<int, int> left_out_;  ///< islands of the joints, by id
};

}  // namespace smile::mechanics
