#include "interchange/joint_forest.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace smile::interchange {
namespace {

/// Grows trees breadth first, so that a chain between two fixed ends is cut in its middle.
class Forester {
 public:
  explicit Forester(const ExportedWorld& world)
      : world_(world), is_used_(world.joints.size()), is_reached_(world.bodies.size()) {
    forest_.nodes.resize(world.bodies.size());
    for (const bool is_static : {true, false}) {
      for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        if (world.bodies[body].is_static() == is_static) AddRoot(static_cast<int>(body));
      }
      Grow();
    }
    for (std::size_t joint = 0; joint < is_used_.size(); ++joint) {
      if (!is_used_[joint]) forest_.closing.push_back(static_cast<int>(joint));
    }
  }

  JointForest Take() { return std::move(forest_); }

 private:
  void AddRoot(int body) {
    if (is_reached_[static_cast<std::size_t>(body)]) return;
    Reach(body, {});
    // Each moving root takes its whole tree before the next one.
    if (!world_.bodies[static_cast<std::size_t>(body)].is_static()) Grow();
  }

  void Reach(int body, const TreeNode& node) {
    is_reached_[static_cast<std::size_t>(body)] = true;
    forest_.nodes[static_cast<std::size_t>(body)] = node;
    forest_.order.push_back(body);
  }

  /// Appends the bodies that joints hold on those that were reached.
  void Grow() {
    for (; num_grown_ < forest_.order.size(); ++num_grown_) {
      const int parent = forest_.order[num_grown_];
      for (std::size_t joint = 0; joint < world_.joints.size(); ++joint) {
        const ExportedJoint& held = world_.joints[joint];
        if (held.a != parent && held.b != parent) continue;
        const int child = held.a == parent ? held.b : held.a;
        if (is_reached_[static_cast<std::size_t>(child)]) continue;
        is_used_[joint] = true;
        Reach(child, {.parent = parent, .joint = static_cast<int>(joint)});
      }
    }
  }

  const ExportedWorld& world_;
  std::vector<bool> is_used_, is_reached_;
  std::size_t num_grown_ = 0;
  JointForest forest_;
};

}  // namespace

JointForest ForestOf(const ExportedWorld& world) { return Forester(world).Take(); }

std::vector<std::vector<int>> GroupsOf(const ExportedWorld& world) {
  // Each body leads to an earlier one of its group; the first one leads to itself.
  std::vector<std::size_t> earlier(world.bodies.size());
  std::iota(earlier.begin(), earlier.end(), 0);
  const auto first_of = [&](std::size_t body) {
    while (earlier[body] != body) body = earlier[body] = earlier[earlier[body]];
    return body;
  };
  for (const ExportedJoint& joint : world.joints) {
    const std::size_t a = first_of(static_cast<std::size_t>(joint.a));
    const std::size_t b = first_of(static_cast<std::size_t>(joint.b));
    earlier[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::vector<int>> groups;
  std::vector<std::size_t> group_of(world.bodies.size());
  for (std::size_t body = 0; body < world.bodies.size(); ++body) {
    const std::size_t first = first_of(body);
    if (first == body) {
      group_of[body] = groups.size();
      groups.emplace_back();
    }
    groups[group_of[first]].push_back(static_cast<int>(body));
  }
  return groups;
}

}  // namespace smile::interchange
