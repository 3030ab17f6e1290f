#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/scene_spec.h"

namespace smile::sim {

/// What an object would come to lie on if it were let go of.
struct Support {
  std::string object;         ///< its id; empty: the table
  bool is_container = false;  ///< it lies in it rather than on it
  double height = 0;          ///< from there up to the object's lowest point [m]

  /// True when it is as good as on it already.
  bool is_near() const { return height < 0.02; }
  bool operator==(const Support&) const = default;
};

/// The highest thing straight beneath an object, as far as their bounds tell; nullopt beyond the
/// table's edge, or when the object is gone.
/// @param X_WBs  of the objects of the scene, in its order, at that moment; nullopt of what is
/// gone.
std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<std::optional<RigidTransform>>& X_WBs,
                                 std::size_t object);

}  // namespace smile::sim
