// Carrying is the task of Hands, on our physics as their Engine; here are the rules of our worlds.
// All state is in DemonstratorState, so saving and undoing copy one value.

#include "demonstrator/demonstrator.h"

#include <algorithm>
#include <utility>

#include "demonstrator/internal_tabletop_engine.h"
#include "demonstrator/motion_plane.h"
#include "world/overlap.h"
#include "world/refusal_names.h"

namespace smile::demonstrator {

using texts::Say;

namespace {

/// Hands on our physics, for the time of a call.
struct OurHands {
  OurHands(physics::World* world, const world::Tabletop* tabletop, HandStates* states,
           const ServoConfig& servo)
      : engine(world, tabletop), hands(&engine, states, servo) {}
  Hands* operator->() { return &hands; }

  TabletopEngine engine;
  Hands hands;
};

}  // namespace

Demonstrator::Demonstrator(physics::World* world, world::Tabletop* tabletop)
    : world_(world), tabletop_(tabletop) {}

Refusal Demonstrator::WhatHolds(HandName name) const {
  HandStates states = state_.hands;
  return OurHands(world_, tabletop_, &states, servo_)->WhatHolds(name);
}

/// A carried body that is in no hand is held by the robot.
bool Demonstrator::IsInAHand(physics::BodyId body) const {
  HandStates states = state_.hands;
  return OurHands(world_, tabletop_, &states, servo_)->IsInAHand(body);
}

GraspPlan Demonstrator::PlanGrasp(HandName name, std::string_view object_id) const {
  HandStates states = state_.hands;
  return OurHands(world_, tabletop_, &states, servo_)->PlanGrasp(name, object_id);
}

std::optional<Refusal> Demonstrator::Grasp(HandName name, std::string_view object_id,
                                           const std::optional<Vector3>& p_WQ) {
  return OurHands(world_, tabletop_, &state_.hands, servo_)->Grasp(name, object_id, p_WQ);
}

std::optional<Refusal> Demonstrator::RefuseIfEmpty(HandName name) const {
  HandStates states = state_.hands;
  return OurHands(world_, tabletop_, &states, servo_)->RefuseIfEmpty(name);
}

std::optional<Refusal> Demonstrator::MoveTo(HandName name, const Vector3& p_WH,
                                            const std::optional<double>& speed) {
  return OurHands(world_, tabletop_, &state_.hands, servo_)->MoveTo(name, p_WH, speed);
}

void Demonstrator::TurnPlane(HandName name, double angle_deg) {
  state_.plane_angles_deg[static_cast<std::size_t>(name)] = angle_deg;
}

std::optional<Vector3> Demonstrator::PointOnPlane(HandName name, const Ray& ray, bool is_level,
                                                  Refusal* refusal) const {
  if (auto empty = RefuseIfEmpty(name)) {
    *refusal = *std::move(empty);
    return std::nullopt;
  }
  const MotionPlane plane = {.angle_deg = plane_angle_deg(name), .is_level = is_level};
  return MeetPlane(name, hand(name), plane, ray, refusal);
}

std::optional<Refusal> Demonstrator::Rotate(HandName name, const Vector3& angles_deg) {
  return OurHands(world_, tabletop_, &state_.hands, servo_)->Rotate(name, angles_deg);
}

std::optional<Refusal> Demonstrator::Release(HandName name) {
  return OurHands(world_, tabletop_, &state_.hands, servo_)->Release(name);
}

std::optional<Refusal> Demonstrator::Destroy(HandName name) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  const world::Object& object = *tabletop_->Find(hand(name).held);
  // Before the object vanishes: a hand must never refer to a missing body.
  MutableHand(name) = Hand();
  state_.attention.erase(object.body);
  tabletop_->Destroy(object);
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::Remove(const world::Object& object) {
  for (HandName name : kHandNames) {
    if (hand(name).held == object.body) {
      return Say("hands.releaseFirst", {{"why", WhatHolds(name)}});
    }
  }
  if (world_->body(object.body).is_carried()) {
    return Say("world.heldByRobot", {{"object", world::ObjectName(object.id())}});
  }
  state_.attention.erase(object.body);
  tabletop_->Destroy(object);
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::RefuseIfHolding(HandName name, const char* action) const {
  if (!hand(name).is_holding()) return std::nullopt;
  return Say("hands.mustBeEmpty", {{"why", WhatHolds(name)}, {"action", action}});
}

std::optional<Refusal> Demonstrator::PointAt(HandName name, std::string_view part_id) const {
  if (auto refusal = RefuseIfHolding(name, "point")) return refusal;
  return tabletop_->RefuseToPoint(part_id);
}

std::optional<Refusal> Demonstrator::Trigger(HandName name, std::string_view control,
                                             std::string_view part) {
  if (auto refusal = RefuseIfHolding(name, "trigger")) return refusal;
  return tabletop_->Trigger(control, part);
}

std::optional<Refusal> Demonstrator::Fasten(HandName name, std::string_view object_id,
                                            const std::optional<Vector3>& p_WQ) {
  return Turn(name, object_id, p_WQ, &world::Tabletop::Fasten);
}

std::optional<Refusal> Demonstrator::Loosen(HandName name, std::string_view object_id,
                                            const std::optional<Vector3>& p_WQ) {
  return Turn(name, object_id, p_WQ, &world::Tabletop::Loosen);
}

std::optional<Refusal> Demonstrator::Turn(HandName name, std::string_view object_id,
                                          const std::optional<Vector3>& p_WQ, Turning turning) {
  if (auto refusal = tabletop_->RefuseToReach(object_id)) return refusal;
  const world::Object* object = tabletop_->Find(object_id);
  const Hand& own = hand(name);
  if (own.is_holding() && own.held != object->body) {
    return RefuseIfHolding(name, "turn");
  }
  const physics::Body& body = world_->body(object->body);
  if (body.is_carried() && !IsInAHand(body.id())) {
    return Say("world.heldByRobot", {{"object", world::ObjectName(object_id)}});
  }
  // Of several guest points of an object, the one nearest to this point is turned.
  const Vector3 p_WPoint = p_WQ.value_or(body.pose_in_world().translation());
  return MoveGoalsWith([&] { return (tabletop_->*turning)(*object, p_WPoint); });
}

std::optional<Refusal> Demonstrator::MoveGoalsWith(
    const std::function<std::optional<Refusal>()>& change) {
  // Remember where held objects are: fastening may move them with their assemblies. Compared bit by
  // bit below, which is exact as bodies that are not moved keep their poses.
  std::array<RigidTransform, kHandNames.size()> before;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (state_.hands[i].is_holding())
      before[i] = world_->body(state_.hands[i].held).pose_in_world();
  }
  if (auto refusal = change()) return refusal;
  // Held objects that the bond moved: their goals move with them, or hands would pull them back.
  for (std::size_t i = 0; i < before.size(); ++i) {
    Hand& hand_of = state_.hands[i];
    if (!hand_of.is_holding()) continue;
    const RigidTransform X_WB = world_->body(hand_of.held).pose_in_world();
    if (X_WB == before[i]) continue;
    hand_of.X_WB_goal = X_WB * (before[i].inverse() * hand_of.X_WB_goal);
  }
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::Use(HandName name, bool loosens, world::ToolUse* use) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  const world::Object& tool = *tabletop_->Find(hand(name).held);
  return MoveGoalsWith([&]() -> std::optional<Refusal> {
    Refusal refusal;
    const auto planned = tabletop_->PlanUse(tool, loosens, &refusal);
    if (!planned) return refusal;
    const world::Object& work = tabletop_->objects()[planned->object];
    const Vector3 p_WW = world_->body(work.body).pose_in_world().translation();
    tabletop_->Use(*planned);
    *use = *planned;
    FollowWork(tool, work, p_WW);
    return std::nullopt;
  });
}

void Demonstrator::FollowWork(const world::Object& tool, const world::Object& work,
                              const Vector3& p_WW_before) {
  const Vector3 moved = world_->body(work.body).pose_in_world().translation() - p_WW_before;
  if (moved == Vector3(Vector3::Zero())) return;
  const RigidTransform X_WB = world_->body(tool.body).pose_in_world();
  const RigidTransform X_there(X_WB.rotation(), X_WB.translation() + moved);
  for (const physics::BodyId blocker :
       world_->OverlapsAt(tool.body, X_there, world::kMaxOverlap).bodies) {
    if (blocker != work.body) return;
  }
  world_->MoveAssembly(tool.body, X_there);
}

void Demonstrator::BeforeStep() {
  OurHands(world_, tabletop_, &state_.hands, servo_)->BeforeStep();
}

bool Demonstrator::has_arrived() const {
  return std::ranges::all_of(kHandNames, [this](HandName name) { return has_arrived(name); });
}

bool Demonstrator::has_arrived(HandName name) const {
  HandStates states = state_.hands;
  return OurHands(world_, tabletop_, &states, servo_)->has_arrived(name);
}

void Demonstrator::AddToHash(StateHash* hash) const {
  demonstrator::AddToHash(state_.hands, hash);
  hash->Add(state_.plane_angles_deg);
  for (const auto& [body, properties] : state_.attention) {
    hash->Add(std::uint64_t{body.value});
    hash->Add(std::uint64_t{properties.size()});
    for (const std::string& property : properties) hash->Add(property);
  }
}

}  // namespace smile::demonstrator
