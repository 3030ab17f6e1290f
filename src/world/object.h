#pragma once

#include <string>

#include "model/model.h"
#include "physics/definitions.h"

namespace smile::world {

/// Object of the running scene. Once destroyed, its body is no longer in the physics world, but it
/// keeps its place in the list.
struct Object {
  model::ObjectIndex index{0};              ///< place in the scene and in the list
  const scene::ObjectSpec* spec = nullptr;  ///< from the Model; never null
  physics::BodyId body{};

  const std::string& id() const { return spec->id(); }
};

/// History of an object that cannot be seen from its pose.
struct ObjectState {
  bool was_raised = false;  ///< was carried above the table top by a hand or gripper
  bool has_fallen = false;  ///< fell to the floor: out of play

  bool operator==(const ObjectState&) const = default;
};

}  // namespace smile::world
