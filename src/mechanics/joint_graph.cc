#include "mechanics/joint_graph.h"

#include <algorithm>

namespace smile::mechanics {

JointGraph::JointGraph(std::span<const Joint> joints, JointId without) {
  for (const Joint& joint : joints) {
    if (joint.id == without) continue;
    const auto pair = BodyPairOf(joint.spec);
    if (!pair) continue;
    edges_.push_back(*pair);
    edges_.emplace_back(pair->second, pair->first);
  }
  // Both directions, sorted: the edges of a body are found by binary search.
  std::sort(edges_.begin(), edges_.end());
}

std::vector<BodyId> JointGraph::ConnectedWith(BodyId start,
                                              const std::function<bool(BodyId)>& is_end) const {
  std::vector<BodyId> found = {start};  // sorted
  std::vector<BodyId> to_visit = {start};
  while (!to_visit.empty()) {
    const BodyId from = to_visit.back();
    to_visit.pop_back();
    if (is_end(from)) continue;
    // The edges of a body are contiguous, since edges are sorted.
    for (auto edge = std::lower_bound(edges_.begin(), edges_.end(), std::pair(from, BodyId{0}));
         edge != edges_.end() && edge->first == from; ++edge) {
      const auto place = std::lower_bound(found.begin(), found.end(), edge->second);
      if (place != found.end() && *place == edge->second) continue;
      found.insert(place, edge->second);
      to_visit.push_back(edge->second);
    }
  }
  return found;
}

std::vector<BodyId> AssemblyOf(BodyId id, std::span<const Joint> joints, JointId without,
                               const std::function<bool(BodyId)>& is_static) {
  std::vector<BodyId> members = JointGraph(joints, without).ConnectedWith(id, is_static);
  std::erase_if(members, [&](BodyId member) { return member != id && is_static(member); });
  return members;
}

bool IsAnchored(BodyId id, std::span<const Joint> joints, JointId without,
                const std::function<bool(BodyId)>& is_static) {
  const std::vector<BodyId> members = JointGraph(joints, without).ConnectedWith(id, is_static);
  return std::any_of(members.begin(), members.end(),
                     [&](BodyId member) { return member != id && is_static(member); });
}

JointGroups::JointGroups(std::span<const Member> bodies, std::span<const Joint> joints,
                         bool only_fixed) {
  std::vector<bool> is_static;
  for (const Member& member : bodies) {
    parents_.push_back(static_cast<int>(ids_.size()));
    ids_.push_back(member.body);
    is_static.push_back(member.is_static);
  }
  is_anchored_ = is_static;
  for (const Joint& joint : joints) {
    if (only_fixed && !std::holds_alternative<FixedJointSpec>(joint.spec)) continue;
    const auto pair = BodyPairOf(joint.spec);
    if (!pair) continue;
    const int a = IndexOf(pair->first), b = IndexOf(pair->second);
    const int root_a = FindRoot(a), root_b = FindRoot(b);
    // Union-find with the smaller index as root, so that the number of a group does not depend on
    // the order of joints.
    const int first = std::min(root_a, root_b), second = std::max(root_a, root_b);
    // A static body anchors the group without joining it: two things on one table are not one
    // group.
    if (is_static[a] || is_static[b]) {
      is_anchored_[first] = is_anchored_[second] = true;
    } else {
      parents_[second] = first;
      if (is_anchored_[second]) is_anchored_[first] = true;
    }
  }
  for (int i = 0; i < static_cast<int>(parents_.size()); ++i) parents_[i] = FindRoot(i);
}

int JointGroups::IndexOf(BodyId id) const {
  return static_cast<int>(std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin());
}

int JointGroups::FindRoot(int index) {
  // Path halving: each visited body then points to its grandparent.
  while (parents_[index] != index) index = parents_[index] = parents_[parents_[index]];
  return index;
}

}  // namespace smile::mechanics
