#include "world/tabletop.h"

#include <algorithm>

#include "scene/solid.h"
#include "world/internal_ground.h"
#include "world/internal_joints.h"

// The objects of a scene in the physics world. The model says what there is; this class keeps which
// body each object has, and the states of controls and bonds. The order in which bodies and joints
// are added is part of the determinism: the solver visits them in this order.

namespace smile::world {

using texts::Say;
namespace {

/// Angular damping of a chain's links, so that they swing but hardly spin. With 1 they would not
/// even swing.
constexpr double kLinkAngularDamping = 0.9;

/// Returns the objects of a model.
/// @param bodies  of the first objects; the others have none yet.
std::vector<Object> ObjectsOf(const model::Model& model,
                              const SharedList<physics::BodyId>& bodies = {}) {
  std::vector<Object> objects;
  objects.reserve(model.objects().size());
  for (model::ObjectIndex object : model.objects()) {
    objects.push_back({.index = object,
                       .spec = &model.object(object),
                       .body = object < bodies.size() ? bodies[object] : physics::BodyId()});
  }
  return objects;
}

}  // namespace

Tabletop::Tabletop(physics::World* world, std::shared_ptr<const model::Model> model)
    : world_(world),
      model_(std::move(model)),
      objects_(ObjectsOf(*model_)),
      controls_(*model_),
      presses_(world, *model_, &objects_, &object_states_),
      bonds_(world, *model_, &objects_, &object_states_, &controls_),
      tools_(world, *model_, &objects_, &object_states_, &controls_, &bonds_) {
  // Table and floor come first: their ids precede those of all objects, which fixes the order in
  // physics.
  const scene::Solid table = scene::TableSolid(model_->scene().table);
  world_->AddBody({.solids = {table}, .restitution = kGroundRestitution});
  floor_ = world_->AddBody({.solids = {FloorSolid()}, .restitution = kGroundRestitution});
  AddBeyond({});
}

Tabletop::Tabletop(physics::World* world, scene::SceneSpec scene)
    : Tabletop(world, std::make_shared<const model::Model>(std::move(scene))) {}

void Tabletop::Grow(std::shared_ptr<const model::Model> model) {
  const scene::SceneSpec& before = model_->scene();
  // The extent is that of the old model.
  const Extent extent{.num_objects = before.objects.size(),
                      .num_sliders = before.sliders.size(),
                      .num_chains = before.chains.size(),
                      .num_guests = model_->guests().size()};
  objects_ = ObjectsOf(*model, bodies_);
  // The states of existing objects stay; those of new ones are initial.
  controls_.Grow(*model);
  presses_.Grow(*model);
  bonds_.Grow(*model);
  tools_.Grow(*model);
  model_ = std::move(model);
  AddBeyond(extent);
}

void Tabletop::AddBeyond(const Extent& extent) {
  const scene::SceneSpec& scene = model_->scene();
  // Bodies before the joints between them; initial bonds last, since they move bodies.
  for (std::size_t i = extent.num_objects; i < objects_.size(); ++i) AddBody(&objects_[i]);
  std::vector<physics::BodyId> bodies(objects_.size());
  std::ranges::transform(objects_, bodies.begin(), &Object::body);
  bodies_ = SharedList(std::move(bodies));
  for (std::size_t i = extent.num_sliders; i < scene.sliders.size(); ++i) {
    AddSliderJoint(scene.sliders[i], objects_, world_);
  }
  for (std::size_t i = extent.num_chains; i < scene.chains.size(); ++i) {
    AddChainJoints(scene.chains[i], scene.meters_per_unit, objects_, world_);
  }
  const std::vector<ControlState> before = controls_.states();
  bonds_.FastenInitially(model::GuestIndex(extent.num_guests));
  FollowControls(before);
}

/// Adds the body of an object, in the form of its controls' present states.
void Tabletop::AddBody(Object* object) {
  const scene::ObjectSpec& spec = *object->spec;
  const std::vector<scene::Solid> solids = SolidsNow(*object);
  const bool is_link = model_->chain_of_link(object->index) != nullptr;
  object->body = world_->AddBody(
      {.solids = solids,
       .mass = scene::MassPropertiesOf(solids, spec.mass, spec.center_of_mass),
       .X_WB = spec.pose_in_world(),
       .friction = spec.surface.friction,
       .restitution = spec.surface.restitution,
       .rolling_friction = spec.surface.rolling_friction,
       .angular_damping = is_link ? std::optional(kLinkAngularDamping) : std::nullopt});
}

const Object* Tabletop::Find(std::string_view id) const {
  const auto index = model_->FindObject(id);
  return index && IsPresent(objects_[*index]) ? &objects_[*index] : nullptr;
}

const Object* Tabletop::Find(physics::BodyId body) const {
  // Bodies are added in the order of the objects, and ids count up; removed bodies keep theirs.
  const auto found = std::ranges::lower_bound(objects_, body, {}, &Object::body);
  const bool is_of_object = found != objects_.end() && found->body == body;
  return is_of_object && IsPresent(*found) ? &*found : nullptr;
}

const Object* Tabletop::FindPointable(std::string_view id) const {
  if (const Object* object = Find(id)) return object;
  for (const Object& object : objects_) {
    if (IsPresent(object) && HasPointable(object, id)) return &object;
  }
  return nullptr;
}

bool Tabletop::HasPointable(const Object& object, std::string_view id) const {
  // Walks the object's parts in the order in which the model lists its controls; a control shows
  // the parts of its present state.
  auto next_control = model_->controls_of(object.index).begin();
  const auto has = [&](const auto& self, const scene::Part& part) -> bool {
    const auto any = [&](const std::vector<scene::Part>& parts) {
      return std::ranges::any_of(parts,
                                 [&](const scene::Part& child) { return self(self, child); });
    };
    if (part.is_pointable && part.id == id) return true;
    if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
      return any(composite->parts);
    }
    if (!scene::IsControl(part.shape)) return false;
    const auto state = static_cast<std::size_t>(controls_.states()[*next_control++].state);
    const auto* custom = std::get_if<scene::CustomControl>(&part.shape);
    return custom != nullptr && any(custom->states[state].parts);
  };
  return has(has, object.spec->whole);
}

std::vector<scene::Solid> Tabletop::SolidsNow(const Object& object) const {
  return scene::SolidsWith(model_->VariantsOf(object.index, controls_.states()),
                           scene::SolidsOf(object.spec->whole));
}

void Tabletop::FollowControls(const std::vector<ControlState>& before) {
  for (const Object& object : objects_) {
    if (!IsPresent(object) || model_->VariantsOf(object.index, before) ==
                                  model_->VariantsOf(object.index, controls_.states())) {
      continue;
    }
    const std::vector<scene::Solid> solids = SolidsNow(object);
    // The variants of lights differ in color but have the same form.
    if (solids == world_->body(object.body).spec().solids) continue;
    // The body stays the same for joints and snapshots, with another shape and mass.
    world_->ChangeForm(
        object.body, solids,
        scene::MassPropertiesOf(solids, object.spec->mass, object.spec->center_of_mass));
  }
}

std::optional<Refusal> Tabletop::Trigger(std::string_view id, std::string_view part) {
  const auto control = model_->FindControl(id);
  if (!control || !IsPresent(*control)) {
    return Say("world.noControl", {{"control", id}});
  }
  if (auto refusal = RefuseToReach(objects_[model_->control(*control).object])) return refusal;
  const std::vector<ControlState> before = controls_.states();
  if (auto refusal = controls_.Trigger(*control, part)) return refusal;
  FollowControls(before);
  return std::nullopt;
}

std::vector<Press> Tabletop::PressControls(double seconds) {
  const std::vector<ControlState> before = controls_.states();
  std::vector<Press> presses = presses_.AfterTick(seconds, &controls_);
  if (!presses.empty()) FollowControls(before);
  return presses;
}

std::optional<Refusal> Tabletop::Fasten(const Object& object, const Vector3& p_WQ) {
  const std::vector<ControlState> before = controls_.states();
  if (auto refusal = bonds_.Fasten(object.index, p_WQ)) return refusal;
  FollowControls(before);
  return std::nullopt;
}

std::optional<Refusal> Tabletop::Loosen(const Object& object, const Vector3& p_WQ) {
  const std::vector<ControlState> before = controls_.states();
  if (auto refusal = bonds_.Loosen(object.index, p_WQ)) return refusal;
  FollowControls(before);
  return std::nullopt;
}

std::optional<ToolUse> Tabletop::PlanUse(const Object& tool, bool loosens, Refusal* refusal) const {
  if (const auto index = model_->ToolOf(tool.index)) {
    return tools_.PlanUse(*index, loosens, refusal);
  }
  *refusal = Say("tools.notATool", {{"object", tool.id()}});
  return std::nullopt;
}

std::optional<WorkPlace> Tabletop::NearestWork(const Object& tool) const {
  const auto index = model_->ToolOf(tool.index);
  return index ? tools_.NearestWork(*index) : std::nullopt;
}

void Tabletop::Use(const ToolUse& use) {
  const std::vector<ControlState> before = controls_.states();
  tools_.Use(use);
  FollowControls(before);
}

std::vector<ToolUse> Tabletop::UseTools(const std::vector<Holder>& holders,
                                        std::vector<Refusal>* refusals) {
  if (!has_tools()) return {};
  const std::vector<ControlState> before = controls_.states();
  std::vector<ToolUse> uses = tools_.AfterTick(holders, refusals);
  if (!uses.empty()) FollowControls(before);
  return uses;
}

void Tabletop::Destroy(const Object& object) {
  const std::vector<ControlState> before = controls_.states();
  // Before the body, on which the joints of the bonds depend; controls downstream follow last.
  bonds_.EndBondsOf(object.index);
  world_->RemoveBody(object.body);
  FollowControls(before);
}

model::SceneState Tabletop::scene_state() const {
  model::SceneState state{.X_WB = {},
                          .controls = controls_.states(),
                          .hosts = {bonds_.states().begin(), bonds_.states().end()}};
  state.X_WB.reserve(objects_.size());
  for (const Object& object : objects_) state.X_WB.push_back(PoseOf(object));
  return state;
}

std::optional<RigidTransform> Tabletop::PoseOf(const Object& object) const {
  if (!IsPresent(object)) return std::nullopt;
  return world_->body(object.body).pose_in_world();
}

TabletopState Tabletop::state() const {
  return {.controls = controls_.states(),
          .bonds = bonds_.states(),
          .presses = presses_.states(),
          .tools = tools_.state(),
          .objects = object_states_,
          .bodies = bodies_};
}

void Tabletop::Restore(const TabletopState& state, std::shared_ptr<const model::Model> model) {
  if (model != model_) {
    // It has other specs and may have more objects.
    objects_ = ObjectsOf(*model, state.bodies);
  } else {
    for (const std::size_t i : state.bodies.MayDifferFrom(bodies_)) {
      objects_[i].body = state.bodies[i];
    }
  }
  bodies_ = state.bodies;
  object_states_ = state.objects;
  controls_.Restore(state.controls, *model);
  bonds_.Restore(state.bonds, *model);
  presses_.Restore(state.presses, *model);
  tools_.Restore(state.tools, *model);
  model_ = std::move(model);
}

void Tabletop::AddToHash(StateHash* hash) const {
  // Bodies are hashed by the physics world.
  for (const ControlState& control : controls_.states()) {
    hash->Add(static_cast<std::uint64_t>(control.state));
    hash->Add(static_cast<std::uint64_t>(control.override_state));
    hash->Add(static_cast<std::uint64_t>(control.position));
  }
  for (const BondState& bond : bonds_.states()) {
    // All bits set means no guest: it is no index.
    hash->Add(bond.guest ? std::uint64_t{*bond.guest} : ~std::uint64_t{0});
    hash->Add(static_cast<std::uint64_t>(bond.tightness));
    hash->Add(std::uint64_t{bond.is_locked});
    hash->Add(std::uint64_t{bond.joint.value});
  }
  presses_.AddToHash(hash);
  tools_.AddToHash(hash);
  const auto add = [hash](const ObjectState& object) {
    hash->Add(std::uint64_t{object.was_raised});
    hash->Add(std::uint64_t{object.has_fallen});
  };
  if (model_->scene().physics_version < 3) {
    // Also the many to which nothing has happened.
    for (const Object& object : objects_) add(object_states_[object.index]);
    return;
  }
  for (const auto& [index, object] : object_states_.changed()) {
    hash->Add(std::uint64_t{index});
    add(object);
  }
}

}  // namespace smile::world
