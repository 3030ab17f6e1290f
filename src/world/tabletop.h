#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "physics/world.h"
#include "scene/scene_spec.h"
#include "scene/visual_model.h"

namespace smile::world {

/// How far below the table top a floor catches what falls [m].
inline constexpr double kFloorDepth = 0.9;

/// A whole object of the scene, alive.
struct Object {
  std::shared_ptr<const scene::ObjectSpec> spec;  ///< shared with saved states; never changes
  physics::BodyId body;

  const std::string& id() const { return spec->id(); }
};

/// The scene come alive: the table, the floor and the objects of a SceneSpec as bodies of a physics
/// World, in scene order.
class Tabletop {
 public:
  /// Adds table, floor and objects to `world`, which must outlive this.
  Tabletop(physics::World* world, const scene::SceneSpec& scene);

  const std::vector<Object>& objects() const { return objects_; }
  /// nullptr when there is no such object.
  const Object* Find(std::string_view id) const;
  const Object* Find(physics::BodyId body) const;

  /// What there is to see: the table (drawn in the world's frame) and one frame per object.
  void AppendVisuals(scene::VisualModel* model) const;
  /// One pose per object, in scene order.
  void AppendVisualState(scene::VisualState* state) const;

 private:
  physics::World* world_;
  scene::TableSpec table_;
  std::vector<Object> objects_;
};

}  // namespace smile::world
