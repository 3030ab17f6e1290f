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

/// An object of a clump: how it stands in the clump's frame K, which lies on the table in the
/// middle of the clump's footprint, x along its first side.
struct ClumpMember {
  std::size_t object = 0;                ///< in SceneSpec::objects
  Vector3 p_KB = Vector3::Zero();        ///< [m]
  Vector3 angles_deg = Vector3::Zero();  ///< fixed axes, in K
  Vector2 center = Vector2::Zero();      ///< middle of its own footprint, in K [m]
};

/// Objects that a layout moves as one: a thing by itself, a row, a stack.
struct Clump {
  std::vector<ClumpMember> members;
  Vector2 half_size = Vector2::Zero();  ///< of the footprint [m]
  double top = 0;                       ///< [m]
};

/// Random numbers that depend on nothing but these.
std::mt19937_64 StreamOf(std::uint64_t seed, std::uint64_t attempt, std::string_view name);

/// The objects that may be moved; see RandomLayout().
std::vector<std::size_t> LooseObjects(const scene::SceneSpec& scene);

/// Each of the objects in one clump: rows of two or three equal blocks, stacks of two, if the level
/// has such; the others by themselves. In the order in which they are placed, the largest first.
std::vector<Clump> ClumpsOf(const scene::SceneSpec& scene, const std::vector<std::size_t>& objects,
                            std::uint64_t seed, LayoutLevel level);

}  // namespace smile::layout
