#pragma once

#include <memory>
#include <string>

#include "physics/ids.h"
#include "scene/scene_spec.h"

namespace smile::world {

/// A whole object of the scene, alive. Once destroyed, its body is no longer in the physics world;
/// it keeps its place in the list.
struct Object {
  std::shared_ptr<const scene::ObjectSpec> spec;  ///< never null, never changes
  physics::BodyId body;

  const std::string& id() const { return spec->id(); }
};

/// Where an object has been.
struct ObjectState {
  bool was_raised = false;  ///< a hand or a gripper carried it above the table top
  bool has_fallen = false;  ///< to the floor: it is out of play

  bool operator==(const ObjectState&) const = default;
};

}  // namespace smile::world
