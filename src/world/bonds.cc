#include "world/bonds.h"
#include "world/overlap.h"
#include "world/refusal_names.h"

#include <algorithm>
#include <map>

// Bonds between guest points (screws) and host points (holes). A bond is a fixed joint at the pose
// of its stage of tightness; changing the stage removes the joint, moves the guest with all that is
// connected to it, and adds another joint. docs/decisions/mechanisms.md lists the differences from
// the original.

namespace smile::world {

using texts::Say;
namespace {

/// Greatest distance of a guest from the host it is fastened to [units].
constexpr double kReachUnits = 2.0;

}  // namespace

Bonds::Bonds(physics::World* world, const model::Model& model, const std::vector<Object>* objects,
             const ObjectStates* object_states, Controls* controls)
    : world_(world),
      model_(&model),
      objects_(objects),
      object_states_(object_states),
      controls_(controls),
      states_(model.hosts().size()) {}

void Bonds::Grow(const model::Model& model) {
  model_ = &model;
  states_.resize(model.hosts().size());
}

void Bonds::Restore(std::vector<BondState> states, const model::Model& model) {
  states_ = std::move(states);
  model_ = &model;
}

void Bonds::FastenInitially(GuestIndex first) {
  for (GuestIndex guest : model_->guests()) {
    if (guest < first) continue;
    const scene::GuestPoint& point = *model_->guest(guest).point;
    const auto host = model_->FindHost(point.initial_host);
    if (!host || point.initial_tightness < 1) continue;
    // Without the checks of RefuseToMove(): the scene file decides.
    world_->MoveAssembly(BodyOf(guest), GuestBodyAt(guest, *host, point.initial_tightness));
    Join(guest, *host, point.initial_tightness);
  }
}

std::optional<HostIndex> Bonds::HostOf(GuestIndex guest) const {
  for (HostIndex host : model_->hosts()) {
    if (states_[host].guest == guest) return host;
  }
  return std::nullopt;
}

/// Returns the object's guest point nearest to a point, if it has any.
std::optional<GuestIndex> Bonds::NearestGuest(ObjectIndex object, const Vector3& p_WQ) const {
  std::optional<GuestIndex> nearest;
  double nearest_distance = 0;
  const RigidTransform X_WB = world_->body((*objects_)[object].body).pose_in_world();
  for (GuestIndex guest : model_->guests()) {
    if (model_->guest(guest).object != object) continue;
    const double distance = (X_WB * model_->guest(guest).X_BG.translation() - p_WQ).norm();
    // The first one in scene order wins a tie, so that the choice is deterministic.
    if (nearest && distance >= nearest_distance) continue;
    nearest = guest;
    nearest_distance = distance;
  }
  return nearest;
}

std::vector<bool> Bonds::ConnectedWith(ObjectIndex object) const {
  // Two sources of connections: bonds between static objects have no joint, and other joints have
  // no bond.
  std::multimap<std::size_t, std::size_t> neighbours;
  for (HostIndex host : model_->hosts()) {
    if (!states_[host].guest) continue;
    const std::size_t a = model_->host(host).object;
    const std::size_t b = model_->guest(*states_[host].guest).object;
    neighbours.insert({{a, b}, {b, a}});
  }
  std::vector<bool> is_connected(objects_->size());
  // Visits the graph of both kinds of connections, starting from the body's whole assembly.
  std::vector<std::size_t> to_visit{object};
  const std::vector<physics::BodyId> assembly = world_->Assembly((*objects_)[object].body);
  for (std::size_t i = 0; i < objects_->size(); ++i) {
    if (std::ranges::binary_search(assembly, (*objects_)[i].body)) to_visit.push_back(i);
  }
  while (!to_visit.empty()) {
    const std::size_t next = to_visit.back();
    to_visit.pop_back();
    if (is_connected[next]) continue;
    is_connected[next] = true;
    const auto [first, last] = neighbours.equal_range(next);
    for (auto other = first; other != last; ++other) to_visit.push_back(other->second);
  }
  return is_connected;
}

std::optional<HostIndex> Bonds::HostInReach(GuestIndex guest, double reach,
                                            Refusal* refusal) const {
  const model::Guest& plug = model_->guest(guest);
  const auto point_in_world = [this](ObjectIndex object, const RigidTransform& X_BPoint) {
    return world_->body((*objects_)[object].body).pose_in_world() * X_BPoint.translation();
  };
  const Vector3 p_WG = point_in_world(plug.object, plug.X_BG);
  const std::vector<bool> is_connected = ConnectedWith(plug.object);
  std::optional<HostIndex> nearest;
  // Hosts of connected objects are left out: such a bond would close a loop of joints.
  double nearest_distance = reach;
  bool is_any_locked = false;
  for (HostIndex host : model_->hosts()) {
    const model::Host& hole = model_->host(host);
    if (hole.point->type != plug.point->type || states_[host].guest || is_connected[hole.object] ||
        !IsInPlay(hole.object)) {
      continue;
    }
    // The distance from point to point decides, not that of the objects.
    const double distance = (point_in_world(hole.object, hole.X_BH) - p_WG).norm();
    if (distance >= nearest_distance) continue;
    // Locked hosts are noted for the message, but not used.
    if (states_[host].is_locked) {
      is_any_locked = true;
      continue;
    }
    nearest = host;
    nearest_distance = distance;
  }
  if (!nearest) {
    *refusal = is_any_locked ? Say("bonds.fitIsLocked", {{"point", plug.point->id}})
                             : Say("bonds.noFit", {{"point", plug.point->id}});
  }
  return nearest;
}

RigidTransform Bonds::GuestBodyAt(GuestIndex guest, HostIndex host, int tightness) const {
  return world_->body(BodyOf(host)).pose_in_world() *
         model::GuestBodyInHostBody(model_->host(host), model_->guest(guest), tightness);
}

std::optional<Refusal> Bonds::Fasten(ObjectIndex object, const Vector3& p_WQ) {
  const auto guest = NearestGuest(object, p_WQ);
  if (!guest) return Say("bonds.noGuestPoint", {{"object", (*objects_)[object].id()}});
  if (auto refusal = RefuseHands(*guest)) return refusal;
  return TurnByHand(*guest, 1);
}

std::optional<Refusal> Bonds::Loosen(ObjectIndex object, const Vector3& p_WQ) {
  const auto guest = NearestGuest(object, p_WQ);
  if (!guest || !HostOf(*guest)) {
    return Say("bonds.notFastened", {{"object", ObjectName((*objects_)[object].id())}});
  }
  if (auto refusal = RefuseHands(*guest)) return refusal;
  return TurnByHand(*guest, -1);
}

std::optional<Refusal> Bonds::RefuseHands(GuestIndex guest) const {
  const scene::GuestPoint& point = *model_->guest(guest).point;
  if (!point.refuses_hands) return std::nullopt;
  return Say("bonds.bareHands",
             {{"object", NameOf(BodyOf(guest))}, {"type", point.accepts.front().type}});
}

std::optional<Refusal> Bonds::TurnByHand(GuestIndex guest, int direction) {
  Refusal refusal;
  const auto turn = PlanTurn(guest, direction, {}, &refusal);
  if (!turn) return refusal;
  Turn(*turn);
  return std::nullopt;
}

std::optional<GuestTurn> Bonds::NextStage(GuestIndex guest, int direction, Refusal* refusal) const {
  if (const auto host = HostOf(guest)) {
    const int tightness = states_[*host].tightness + direction;
    // Stages count from 1; 0 means free.
    if (tightness <= static_cast<int>(model_->host(*host).point->stages.size())) {
      return GuestTurn{.guest = guest, .host = *host, .tightness = tightness};
    }
    *refusal = Say("bonds.tightest", {{"object", NameOf(BodyOf(guest))}});
    return std::nullopt;
  }
  if (direction < 0) {
    *refusal = Say("bonds.notFastened", {{"object", NameOf(BodyOf(guest))}});
    return std::nullopt;
  }
  const auto host = HostInReach(guest, kReachUnits * model_->scene().meters_per_unit, refusal);
  if (!host) return std::nullopt;
  return GuestTurn{.guest = guest, .host = *host, .tightness = 1};
}

std::optional<GuestTurn> Bonds::PlanTurn(GuestIndex guest, int direction, physics::BodyId tool,
                                         Refusal* refusal) const {
  auto turn = NextStage(guest, direction, refusal);
  if (!turn) return std::nullopt;
  turn->tool = tool;
  if (states_[turn->host].is_locked) {
    *refusal = Say("bonds.locked", {{"point", model_->host(turn->host).point->id}});
    return std::nullopt;
  }
  const RigidTransform X_WB = GuestBodyAt(guest, turn->host, turn->tightness);
  if (auto reason = RefuseToMove(guest, turn->host, X_WB, tool)) {
    *refusal = *std::move(reason);
    return std::nullopt;
  }
  return turn;
}

void Bonds::Turn(const GuestTurn& turn) {
  const physics::BodyId body = BodyOf(turn.guest);
  // The present bond ends before the guest moves.
  if (states_[turn.host].joint) world_->RemoveJoint(states_[turn.host].joint);
  states_[turn.host].joint = {};
  world_->MoveAssembly(body, GuestBodyAt(turn.guest, turn.host, turn.tightness));
  Join(turn.guest, turn.host, turn.tightness);
  // The tip of the tool is where the guest is now.
  if (turn.tool) world_->IgnoreCollisionUntilSeparated(turn.tool, body);
}

std::optional<Refusal> Bonds::RefuseToMove(GuestIndex guest, HostIndex host,
                                           const RigidTransform& X_WB, physics::BodyId tool) const {
  const physics::BodyId body = BodyOf(guest), holder = BodyOf(host);
  const physics::JointId bond = states_[host].joint;
  if (world_->body(body).is_static()) return Say("world.isFixed", {{"object", NameOf(body)}});
  // The bond itself does not count: it is about to change.
  if (world_->IsAnchored(body, bond)) return Say("bonds.anchored", {{"object", NameOf(body)}});
  const std::vector<physics::BodyId> moved = world_->Assembly(body, bond);
  if (std::ranges::binary_search(moved, holder)) {
    return Say("bonds.joined", {{"object", NameOf(body)}, {"other", NameOf(holder)}});
  }
  // The motion of the guest in the world; everything connected to it moves along rigidly.
  const RigidTransform X_moved = X_WB * world_->body(body).pose_in_world().inverse();
  for (physics::BodyId member : moved) {
    if (IsHeldByRobot(member)) return Say("world.heldByRobot", {{"object", NameOf(member)}});
    const RigidTransform X_there = X_moved * world_->body(member).pose_in_world();
    const physics::Overlaps overlaps = world_->OverlapsAt(member, X_there, kMaxOverlap);
    for (physics::BodyId blocker : overlaps.bodies) {
      // A guest is inside its host's hole by design.
      const bool is_hole = member == body && blocker == holder;
      if (is_hole || blocker == tool || std::ranges::binary_search(moved, blocker)) continue;
      return NoRoom(NameOf(member), NameOf(blocker));
    }
    if (overlaps.with_articulation) return NoRoom(NameOf(member), RobotName());
  }
  return std::nullopt;
}

bool Bonds::IsHeldByRobot(physics::BodyId body) const {
  return std::ranges::any_of(world_->joints(), [body](const physics::Joint& joint) {
    // Only grippers weld.
    return std::holds_alternative<physics::WeldSpec>(joint.spec) && Joins(joint.spec, body);
  });
}

Refusal Bonds::NameOf(physics::BodyId body) const {
  const auto object = std::ranges::find(*objects_, body, &Object::body);
  return object != objects_->end() ? ObjectName(object->id()) : TableName();
}

void Bonds::Join(GuestIndex guest, HostIndex host, int tightness) {
  const physics::BodyId holder = BodyOf(host), body = BodyOf(guest);
  BondState& state = states_[host];
  state.tightness = tightness;
  state.guest = tightness > 0 ? std::optional(guest) : std::nullopt;
  // Two static objects need no joint: neither moves.
  if (tightness > 0 && !(world_->body(holder).is_static() && world_->body(body).is_static())) {
    state.joint = world_->AddJoint(physics::FixedJointSpec{
        .a = holder,
        .b = body,
        .X_AB = model::GuestBodyInHostBody(model_->host(host), model_->guest(guest), tightness)});
  } else if (tightness == 0) {
    // The guest is still inside the hole: contacts would eject it.
    world_->IgnoreCollisionUntilSeparated(holder, body);
  }
  NotifyDownstream(host);
}

void Bonds::NotifyDownstream(HostIndex index) {
  const model::Host& host = model_->host(index);
  const int tightness = states_[index].tightness;
  // Set: the state is the tightness. Override: the stage decides what the control shows. Lock: the
  // stage decides whether another host can be turned.
  if (host.downstream) controls_->Set(*host.downstream, tightness);
  if (host.downstream_override) {
    controls_->Override(*host.downstream_override, model::OverrideAt(host, tightness));
  }
  if (host.downstream_lock) {
    states_[*host.downstream_lock].is_locked = model::LocksDownstreamAt(host, tightness);
  }
}

void Bonds::End(HostIndex host) {
  BondState& state = states_[host];
  const physics::BodyId body = BodyOf(*state.guest);
  if (state.joint) world_->RemoveJoint(state.joint);
  // The lock belongs to the host, not to the bond.
  state = BondState{{.is_locked = state.is_locked}};
  world_->IgnoreCollisionUntilSeparated(BodyOf(host), body);
  NotifyDownstream(host);
}

void Bonds::EndBondsOf(ObjectIndex object) {
  for (HostIndex host : model_->hosts()) {
    BondState& state = states_[host];
    if (!state.guest) continue;
    if (model_->host(host).object != object && model_->guest(*state.guest).object != object)
      continue;
    // The other object stays where it is, without its joint.
    if (state.joint) world_->RemoveJoint(state.joint);
    // The lock belongs to the host, not to the bond.
    state = BondState{{.is_locked = state.is_locked}};
    NotifyDownstream(host);
  }
}

}  // namespace smile::world
