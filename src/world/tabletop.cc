#include "world/tabletop.h"

#include <algorithm>

#include "scene/solid.h"
#include "world/internal_ground.h"
#include "world/internal_joints.h"

namespace smile::world {
namespace {

/// Of a chain's links, which shall swing but hardly spin. With 1 they would not even swing.
constexpr double kLinkAngularDamping = 0.9;

/// Without bodies yet.
std::vector<Object> ObjectsOf(const scene::SceneSpec& scene) {
  std::vector<Object> objects;
  for (const scene::ObjectSpec& spec : scene.objects) {
    objects.push_back({std::make_shared<const scene::ObjectSpec>(spec), {}});
  }
  return objects;
}

std::vector<std::optional<double>> LinkPaddings(const scene::SceneSpec& scene) {
  std::vector<std::optional<double>> paddings(scene.objects.size());
  for (const scene::ChainSpec& chain : scene.chains) {
    const auto first_link = paddings.begin() + static_cast<std::ptrdiff_t>(chain.first_object + 2);
    std::fill_n(first_link, chain.link_ids.size(), chain.link_padding);
  }
  return paddings;
}

}  // namespace

Tabletop::Tabletop(physics::World* world, const scene::SceneSpec& scene)
    : world_(world),
      table_(scene.table),
      meters_per_unit_(scene.meters_per_unit),
      objects_(ObjectsOf(scene)),
      link_padding_(LinkPaddings(scene)),
      controls_(objects_),
      object_states_(objects_.size()),
      bonds_(world, &objects_, &object_states_, &controls_) {
  AddBodiesAndJoints(scene);
  const std::vector<ControlState> before = controls_.states();
  bonds_.FastenInitially();
  FollowControls(before);
}

void Tabletop::AddBodiesAndJoints(const scene::SceneSpec& scene) {
  world_->AddBody({.solids = {TableSolid(table_)}, .restitution = kGroundRestitution});
  floor_ = world_->AddBody({.solids = {FloorSolid()}, .restitution = kGroundRestitution});
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const scene::ObjectSpec& spec = *objects_[i].spec;
    const std::vector<scene::Solid> solids = SolidsNow(i);
    objects_[i].body = world_->AddBody(
        {.solids = solids,
         .mass = scene::MassPropertiesOf(solids, spec.mass, spec.center_of_mass),
         .X_WB = spec.pose_in_world(),
         .friction = spec.surface.friction,
         .restitution = spec.surface.restitution,
         .rolling_friction = spec.surface.rolling_friction,
         .angular_damping = link_padding_[i] ? std::optional(kLinkAngularDamping) : std::nullopt});
  }
  for (const scene::SliderSpec& slider : scene.sliders) AddSliderJoint(slider, objects_, world_);
  for (const scene::ChainSpec& chain : scene.chains) {
    AddChainJoints(chain, meters_per_unit_, objects_, world_);
  }
}

const Object* Tabletop::Find(std::string_view id) const {
  for (const Object& object : objects_) {
    if (object.id() == id) return IsPresent(object) ? &object : nullptr;
  }
  return nullptr;
}

const Object* Tabletop::Find(physics::BodyId body) const {
  for (const Object& object : objects_) {
    if (object.body == body) return IsPresent(object) ? &object : nullptr;
  }
  return nullptr;
}

const Object* Tabletop::FindPointable(std::string_view id) const {
  if (const Object* object = Find(id)) return object;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (IsPresent(objects_[i]) && HasPointable(i, id)) return &objects_[i];
  }
  return nullptr;
}

bool Tabletop::HasPointable(std::size_t object, std::string_view id) const {
  std::size_t next_control = controls_.RangeOf(object).first;
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
    const auto state = static_cast<std::size_t>(controls_.states()[next_control++].state);
    const auto* custom = std::get_if<scene::CustomControl>(&part.shape);
    return custom != nullptr && any(custom->states[state].parts);
  };
  return has(has, objects_[object].spec->whole);
}

std::vector<scene::Solid> Tabletop::SolidsNow(std::size_t object) const {
  return scene::SolidsWith(LooksOf(object), scene::SolidsOf(objects_[object].spec->whole));
}

void Tabletop::FollowControls(const std::vector<ControlState>& before) {
  std::optional<std::size_t> done;  // controls are in the order of their objects
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Control& control = controls_.all()[i];
    const Object& object = objects_[control.object];
    if (control.object == done || !IsPresent(object) ||
        LookOf(control, before[i]) == LookOf(control, controls_.states()[i])) {
      continue;
    }
    done = control.object;
    const std::vector<scene::Solid> solids = SolidsNow(control.object);
    // Lights look otherwise and feel the same.
    if (solids == world_->body(object.body).spec().solids) continue;
    world_->ChangeForm(
        object.body, solids,
        scene::MassPropertiesOf(solids, object.spec->mass, object.spec->center_of_mass));
  }
}

std::optional<Refusal> Tabletop::Trigger(std::string_view id, std::string_view part) {
  const auto control = controls_.Find(id);
  if (!control || !IsPresent(controls_.all()[*control])) {
    return "there is no control " + Named(id);
  }
  if (auto refusal = RefuseToReach(objects_[controls_.all()[*control].object])) return refusal;
  const std::vector<ControlState> before = controls_.states();
  if (auto refusal = controls_.Trigger(*control, part)) return refusal;
  FollowControls(before);
  return std::nullopt;
}

std::optional<Refusal> Tabletop::Fasten(const Object& object, const Vector3& p_WQ) {
  const std::vector<ControlState> before = controls_.states();
  if (auto refusal = bonds_.Fasten(IndexOf(object), p_WQ, meters_per_unit_)) return refusal;
  FollowControls(before);
  return std::nullopt;
}

std::optional<Refusal> Tabletop::Loosen(const Object& object, const Vector3& p_WQ) {
  const std::vector<ControlState> before = controls_.states();
  if (auto refusal = bonds_.Loosen(IndexOf(object), p_WQ)) return refusal;
  FollowControls(before);
  return std::nullopt;
}

void Tabletop::Destroy(const Object& object) {
  const std::vector<ControlState> before = controls_.states();
  bonds_.EndBondsOf(IndexOf(object));
  world_->RemoveBody(object.body);
  FollowControls(before);
}

void Tabletop::Restore(const TabletopState& state) {
  controls_.Restore(state.controls);
  bonds_.Restore(state.bonds);
  object_states_ = state.objects;
}

void Tabletop::AddToHash(StateHash* hash) const {
  for (const ControlState& control : controls_.states()) {
    hash->Add(static_cast<std::uint64_t>(control.state));
    hash->Add(static_cast<std::uint64_t>(control.override_state));
    hash->Add(static_cast<std::uint64_t>(control.position));
  }
  for (const BondState& bond : bonds_.states()) {
    hash->Add(static_cast<std::uint64_t>(bond.guest));
    hash->Add(static_cast<std::uint64_t>(bond.tightness));
    hash->Add(std::uint64_t{bond.is_locked});
    hash->Add(std::uint64_t{bond.joint.value});
  }
  for (const ObjectState& object : object_states_) {
    hash->Add(std::uint64_t{object.was_raised});
    hash->Add(std::uint64_t{object.has_fallen});
  }
}

}  // namespace smile::world
