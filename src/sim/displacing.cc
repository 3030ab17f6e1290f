#include "sim/displacing.h"

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/spawning.h"
#include "world/refusal_names.h"

// Several objects move as one rigid group: all checks come before the first change, each at the new
// place of one body, against everything that does not move with it.

namespace smile::sim {
namespace {

using texts::Say;
using world::ObjectName;
using world::Refusal;

/// Returns the reason why an object cannot be displaced.
std::optional<Refusal> RefuseToMove(const std::string& id, const world::Tabletop& tabletop,
                                    const physics::World& world) {
  if (auto refusal = tabletop.RefuseToReach(id)) return refusal;
  const world::Object& object = *tabletop.Find(id);
  if (world.body(object.body).is_static() || world.IsAnchored(object.body)) {
    return Say("objects.isFixed", {{"object", id}});
  }
  for (const physics::BodyId member : world.Assembly(object.body)) {
    if (!world.body(member).is_carried()) continue;
    return Say("objects.isHeld", {{"object", tabletop.Find(member)->id()}});
  }
  return std::nullopt;
}

/// Returns the reason why a body cannot be at a pose, apart from the bodies that move with it.
std::optional<Refusal> RefusePlace(physics::BodyId body, const RigidTransform& X_WB,
                                   const std::set<physics::BodyId>& moving,
                                   const world::Tabletop& tabletop, const physics::World& world) {
  const physics::Overlaps overlaps = world.OverlapsAt(body, X_WB, kTouching);
  const auto refuse = [&](Refusal blocker) {
    return world::NoRoom(ObjectName(tabletop.Find(body)->id()), std::move(blocker));
  };
  for (const physics::BodyId other : overlaps.bodies) {
    if (moving.contains(other)) continue;
    const world::Object* blocker = tabletop.Find(other);
    return refuse(blocker != nullptr ? ObjectName(blocker->id()) : world::TableName());
  }
  if (overlaps.with_articulation) return refuse(world::RobotName());
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> RefuseRepeated(const std::vector<std::string>& objects) {
  std::set<std::string_view> named;
  for (const std::string& id : objects) {
    if (!named.insert(id).second) return Say("objects.namedTwice", {{"object", id}});
  }
  return std::nullopt;
}

std::optional<Refusal> DisplaceObjects(const Displace& displace, const world::Tabletop& tabletop,
                                       physics::World* world) {
  if (auto refusal = RefuseRepeated(displace.objects)) return refusal;
  std::set<physics::BodyId> moving;
  std::vector<physics::BodyId> leaders;  // one of each assembly
  for (const std::string& id : displace.objects) {
    if (auto refusal = RefuseToMove(id, tabletop, *world)) return refusal;
    const physics::BodyId body = tabletop.Find(id)->body;
    if (moving.contains(body)) continue;
    leaders.push_back(body);
    for (const physics::BodyId member : world->Assembly(body)) moving.insert(member);
  }
  const RigidTransform X_moved(displace.by);
  for (const physics::BodyId body : moving) {
    const RigidTransform X_WB = X_moved * world->body(body).pose_in_world();
    if (auto refusal = RefusePlace(body, X_WB, moving, tabletop, *world)) return refusal;
  }
  for (const physics::BodyId leader : leaders) {
    world->MoveAssembly(leader, X_moved * world->body(leader).pose_in_world());
  }
  world->WakeAll();
  return std::nullopt;
}

}  // namespace smile::sim
