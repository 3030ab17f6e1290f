#include "world/tabletop.h"

#include "scene/solid.h"

namespace smile::world {
namespace {

constexpr Color kTableColor{1, 1, 1};
/// Bodies bounce with the product of both restitutions: with 1 here, an object's own one counts.
constexpr double kGroundRestitution = 1;

scene::Solid TableSolid(const scene::TableSpec& table) {
  return {scene::Block{{table.x_span, table.y_span, table.thickness}},
          RigidTransform(Vector3(0, 0, -table.thickness / 2)), kTableColor, "table"};
}

scene::Solid FloorSolid() {
  constexpr double kSpan = 40, kThickness = 1;
  return {scene::Block{{kSpan, kSpan, kThickness}},
          RigidTransform(Vector3(0, 0, -kFloorDepth - kThickness / 2)), Color{}, "floor"};
}

}  // namespace

Tabletop::Tabletop(physics::World* world, const scene::SceneSpec& scene)
    : world_(world), table_(scene.table) {
  world_->AddBody({.solids = {TableSolid(table_)}, .restitution = kGroundRestitution});
  world_->AddBody({.solids = {FloorSolid()}, .restitution = kGroundRestitution});
  for (const scene::ObjectSpec& object : scene.objects) {
    const std::vector<scene::Solid> solids = scene::SolidsOf(object.whole);
    const physics::BodyId body =
        world_->AddBody({.solids = solids,
                         .mass = scene::MassPropertiesOf(solids, object.mass),
                         .X_WB = object.pose_in_world(),
                         .friction = object.surface.friction,
                         .restitution = object.surface.restitution,
                         .rolling_friction = object.surface.rolling_friction});
    objects_.push_back({std::make_shared<const scene::ObjectSpec>(object), body});
  }
}

const Object* Tabletop::Find(std::string_view id) const {
  for (const Object& object : objects_) {
    if (object.id() == id) return &object;
  }
  return nullptr;
}

const Object* Tabletop::Find(physics::BodyId body) const {
  for (const Object& object : objects_) {
    if (object.body == body) return &object;
  }
  return nullptr;
}

void Tabletop::AppendVisuals(scene::VisualModel* model) const {
  const auto name_object = [model](const std::string& name) {
    model->object_names.push_back(name);
    return static_cast<std::uint32_t>(model->object_names.size() - 1);
  };
  const scene::Solid table = TableSolid(table_);
  model->visuals.push_back({.shape = scene::VisualShapeOf(table.shape),
                            .color = table.color,
                            .X_FV = table.X_BS,
                            .object_id = name_object("table")});
  for (const Object& object : objects_) {
    const std::uint32_t object_id = name_object(object.id());
    for (scene::Visual visual : scene::VisualsOf(object.spec->whole)) {
      visual.frame = model->num_frames;
      visual.object_id = object_id;
      model->visuals.push_back(visual);
    }
    ++model->num_frames;
  }
}

void Tabletop::AppendVisualState(scene::VisualState* state) const {
  for (const Object& object : objects_) {
    state->poses.push_back(world_->body(object.body).pose_in_world());
  }
}

}  // namespace smile::world
