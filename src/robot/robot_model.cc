#include "robot/robot_model.h"

#include <algorithm>

namespace smile::robot {
namespace {

/// Returns the index of the first item named `name`.
template <class Items, class NameOf>
std::optional<int> IndexOf(const Items& items, std::string_view name, NameOf name_of) {
  // Linear: models have some dozens of links, and names are looked up when files are read.
  const auto found = std::ranges::find(items, name, name_of);
  if (found == items.end()) return std::nullopt;
  return static_cast<int>(found - items.begin());
}

template <class Item>
const Item* Find(const std::vector<Item>& items, std::string_view name) {
  const auto found = std::ranges::find(items, name, &Item::name);
  return found == items.end() ? nullptr : &*found;
}

}  // namespace

std::optional<int> FindJoint(const RobotModel& model, std::string_view name) {
  return IndexOf(model.links, name, &scene::LinkSpec::joint_name);
}

std::optional<int> FindFrame(const RobotModel& model, std::string_view name) {
  return IndexOf(model.frames, name, &Frame::name);
}

const Arm* FindArm(const RobotModel& model, std::string_view name) {
  return Find(model.arms, name);
}

const NamedPose* FindPose(const RobotModel& model, std::string_view name) {
  return Find(model.poses, name);
}

bool IsWithinLimits(const RobotModel& model, std::span<const double> q, double tolerance) {
  if (q.size() != model.links.size()) return false;
  for (std::size_t i = 0; i < q.size(); ++i) {
    // Written so that NaN is outside.
    const bool is_within =
        q[i] >= model.links[i].lower - tolerance && q[i] <= model.links[i].upper + tolerance;
    if (!is_within) return false;
  }
  return true;
}

scene::ArticulationSpec MakeArticulationSpec(const RobotModel& model,
                                             const RigidTransform& X_WBase) {
  return {.X_WBase = X_WBase,
          .base_solids = model.base_solids,
          .links = model.links,
          .never_collide = model.never_collide};
}

}  // namespace smile::robot
