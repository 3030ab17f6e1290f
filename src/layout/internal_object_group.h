#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "layout/footprint.h"
#include "layout/layout_level.h"
#include "scene/scene_spec.h"

namespace smile::layout {

/// Member of a group: an object and its pose in the group's frame K, which lies on the table at the
/// center of the group's footprint, x along its first side.
struct GroupMember {
  std::size_t object = 0;                ///< in SceneSpec::objects
  Vector3 p_KB = Vector3::Zero();        ///< [m]
  Vector3 angles_deg = Vector3::Zero();  ///< fixed axes, in K
  Vector2 center = Vector2::Zero();      ///< middle of its own footprint, in K [m]
};

/// Objects that a layout moves as one: a single object, a row, a stack or a pile.
struct ObjectGroup {
  std::vector<GroupMember> members;
  Vector2 half_size = Vector2::Zero();  ///< of the footprint [m]
  double top = 0;                       ///< height above the table [m]
};

/// Returns a random number generator that depends only on these arguments.
std::mt19937_64 StreamOf(std::uint64_t seed, std::uint64_t attempt, std::string_view name);

/// Returns the objects that may be moved; see RandomLayout().
std::vector<std::size_t> LooseObjects(const scene::SceneSpec& scene);

/// Returns the piles: objects that stand on one another or touch, and nothing else but the table,
/// and that are part of no mechanism; each as a group, in scene order.
std::vector<ObjectGroup> PilesOf(const scene::SceneSpec& scene);

/// Partitions the objects into groups: rows of two or three equal blocks and stacks of two, if the
/// level has such; each other object is a group by itself. Sorted in placing order: by descending
/// footprint area.
std::vector<ObjectGroup> ObjectGroupsOf(const scene::SceneSpec& scene,
                                        const std::vector<std::size_t>& objects, std::uint64_t seed,
                                        LayoutLevel level);

}  // namespace smile::layout
