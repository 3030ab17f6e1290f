// Rules for objects that hands can reach, and for objects that have fallen to the floor.

#include <algorithm>

#include "base/wording.h"
#include "scene/parts.h"
#include "world/tabletop.h"

namespace smile::world {

using texts::Say;
namespace {

/// An object this much lower than at the start has come down [m].
constexpr double kFall = 0.1;

bool HasPart(const scene::Part& whole, std::string_view id) {
  bool has = false;
  scene::ForEachPart(whole, [&](const scene::Part& part) { has = has || part.id == id; });
  return has;
}

}  // namespace

std::optional<Refusal> Tabletop::RefuseToReach(const Object& object) const {
  if (!IsPresent(object)) return Say("world.wasDestroyed", {{"object", object.id()}});
  if (HasFallen(object)) return Say("world.hasFallen", {{"object", object.id()}});
  return std::nullopt;
}

std::optional<Refusal> Tabletop::RefuseToReach(std::string_view id) const {
  // The most specific reason first: this object, a part of another one, and last a spelling
  // suggestion.
  if (const auto index = model_->FindObject(id)) return RefuseToReach(objects_[*index]);
  std::vector<std::string_view> known;
  for (const Object& object : objects_) {
    if (IsPresent(object)) known.push_back(object.id());
  }
  for (const Object& object : objects_) {
    if (!id.empty() && IsPresent(object) && HasPart(object.spec->whole, id)) {
      return Say("world.isPart", {{"part", id}, {"object", object.id()}});
    }
  }
  return Say("world.noObject", {{"object", id}, {"suggestion", DidYouMean(id, known)}});
}

std::optional<Refusal> Tabletop::RefuseToPoint(std::string_view id) const {
  if (const Object* object = FindPointable(id)) return RefuseToReach(*object);
  // An object that exists no longer has a better reason than an unknown id.
  const auto gone = std::ranges::find(objects_, id, &Object::id);
  if (gone != objects_.end()) return RefuseToReach(*gone);
  return Say("world.notPointable", {{"object", id}});
}

std::vector<const Object*> Tabletop::NoticeFallen() {
  std::vector<const Object*> candidates;
  // An object that sleeps was looked at while it was awake.
  for (const physics::BodyId id : world_->awake_bodies()) {
    const Object* object = Find(id);
    if (object == nullptr) continue;
    const ObjectState state = object_states_[object->index];
    if (state.has_fallen) continue;
    const physics::Body& body = world_->body(id);
    // An object that starts on the floor has not fallen; after it was raised it can fall.
    const bool is_raised = body.is_carried() && body.pose_in_world().translation().z() > 0;
    if (is_raised && !state.was_raised) {
      object_states_.Set(object->index, {.was_raised = true});
    }
    if (HasComeDown(*object) && !IsHeld(*object)) candidates.push_back(object);
  }
  if (candidates.empty()) return {};
  const std::vector<physics::BodyId> on_floor = world_->BodiesTouching(floor_);
  std::vector<const Object*> fallen;
  for (const Object* object : candidates) {
    if (!std::ranges::binary_search(on_floor, object->body)) continue;
    ObjectState state = object_states_[object->index];
    state.has_fallen = true;
    object_states_.Set(object->index, state);
    fallen.push_back(object);
  }
  return fallen;
}

bool Tabletop::HasComeDown(const Object& object) const {
  const double start = object.spec->pose_in_world().translation().z();
  const double now = world_->body(object.body).pose_in_world().translation().z();
  return object_states_[object.index].was_raised || now < start - kFall;
}

bool Tabletop::IsHeld(const Object& object) const {
  // The usual case, and an assembly takes a look at all joints.
  if (world_->body(object.body).is_carried()) return true;
  return std::ranges::any_of(world_->Assembly(object.body), [this](physics::BodyId body) {
    return world_->body(body).is_carried();
  });
}

}  // namespace smile::world
