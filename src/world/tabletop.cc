#include "world/tabletop.h"

#include <algorithm>

#include "scene/solid.h"
#include "world/internal_ground.h"
#include "world/internal_joints.h"

namespace smile::world {
namespace {

/// Of a chain's links: they swing, but do not spin.
constexpr double kLinkAngularDamping = 0.9;

/// Without bodies yet.
std::vector<Object> ObjectsOf(const scene::SceneSpec& scene) {
  std::vector<Object> objects;
  for (const scene::ObjectSpec& spec : scene.objects) {
    objects.push_back({std::make_shared<const scene::ObjectSpec>(spec), {}});
  }
  return objects;
}

bool HasPointable(const scene::Part& part, std::string_view id) {
  if (part.is_pointable && part.id == id) return true;
  const auto any = [id](const std::vector<scene::Part>& parts) {
    return std::ranges::any_of(parts,
                               [id](const scene::Part& child) { return HasPointable(child, id); });
  };
  if (const auto* composite = std::get_if<scene::Composite>(&part.shape)) {
    return any(composite->parts);
  }
  const auto* control = std::get_if<scene::CustomControl>(&part.shape);
  return control != nullptr &&
         std::ranges::any_of(control->states, any, &scene::CustomControl::State::parts);
}

std::vector<double> LinkPaddings(const scene::SceneSpec& scene) {
  std::vector<double> paddings(scene.objects.size());
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
      bonds_((AddBodiesAndJoints(scene), world), &objects_, &controls_) {
  // Bonds set controls from the start.
  for (std::size_t i = 0; i < objects_.size(); ++i) UpdateForm(i);
}

void Tabletop::AddBodiesAndJoints(const scene::SceneSpec& scene) {
  world_->AddBody({.solids = {TableSolid(table_)}, .restitution = kGroundRestitution});
  world_->AddBody({.solids = {FloorSolid()}, .restitution = kGroundRestitution});
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
         .angular_damping =
             link_padding_[i] > 0 ? std::optional(kLinkAngularDamping) : std::nullopt});
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
  for (const Object& object : objects_) {
    if (IsPresent(object) && HasPointable(object.spec->whole, id)) return &object;
  }
  return nullptr;
}

std::vector<scene::Solid> Tabletop::SolidsNow(std::size_t object) const {
  return scene::SolidsWith(LooksOf(object), scene::SolidsOf(objects_[object].spec->whole));
}

void Tabletop::UpdateForm(std::size_t object) {
  const Object& changed = objects_[object];
  if (!IsPresent(changed) || !HasControls(object)) return;
  const std::vector<scene::Solid> solids = SolidsNow(object);
  const physics::BodySpec& now = world_->body(changed.body).spec();
  if (solids == now.solids) return;
  world_->ChangeForm(
      changed.body, solids,
      scene::MassPropertiesOf(solids, changed.spec->mass, changed.spec->center_of_mass));
}

bool Tabletop::HasControls(std::size_t object) const {
  return std::ranges::any_of(controls_.all(),
                             [object](const Control& control) { return control.object == object; });
}

std::optional<Refusal> Tabletop::Trigger(std::string_view id, std::string_view part) {
  const auto control = controls_.Find(id);
  if (!control || !IsPresent(controls_.all()[*control])) {
    return "there is no control " + Named(id);
  }
  if (auto refusal = controls_.Trigger(*control, part)) return refusal;
  UpdateForms();
  return std::nullopt;
}

std::optional<Refusal> Tabletop::Fasten(const Object& object, const Vector3& p_WQ) {
  if (auto refusal = bonds_.Fasten(IndexOf(object), p_WQ, meters_per_unit_)) return refusal;
  UpdateForms();
  return std::nullopt;
}

std::optional<Refusal> Tabletop::Loosen(const Object& object, const Vector3& p_WQ) {
  if (auto refusal = bonds_.Loosen(IndexOf(object), p_WQ)) return refusal;
  UpdateForms();
  return std::nullopt;
}

void Tabletop::Destroy(const Object& object) {
  bonds_.EndBondsOf(IndexOf(object));
  world_->RemoveBody(object.body);
  UpdateForms();
}

void Tabletop::UpdateForms() {
  if (controls_.all().empty()) return;
  for (std::size_t i = 0; i < objects_.size(); ++i) UpdateForm(i);
}

void Tabletop::Restore(const TabletopState& state) {
  controls_.Restore(state.controls);
  bonds_.Restore(state.bonds);
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
}

}  // namespace smile::world
