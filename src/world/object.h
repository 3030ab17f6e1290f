#pragma once

#include <string>

#include "model/model.h"
#include "physics/ids.h"

namespace smile::world {

/// A whole object of the scene, alive. Once destroyed, its body is no longer in the physics world;
/// it keeps its place in the list.
struct Object {
  model::ObjectIndex index{0};              ///< its place in the scene and in the list
  const scene::ObjectSpec* spec = nullptr;  ///< of the Model; never null
  physics::BodyId body{};

  const std::string& id() const { return spec->id(); }
};

/// Where an object has been.
struct ObjectState {
  bool was_raised = false;  ///< a hand or a gripper carried it above the table top
  bool has_fallen = false;  ///< to the floor: it is out of play

  bool operator==(const ObjectState&) const = default;
};

}  // namespace smile::world
