// Hands are goals with limits of force, not bodies. A command changes goals and holds at once or is
// refused with a reason and without effect; motion happens in BeforeStep(). All state is in
// DemonstratorState, so saving and undoing copy one value.

#include "demonstrator/demonstrator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/angles.h"

namespace smile::demonstrator {

using world::Named;

namespace {

/// Returns the name of a hand as a singular subject.
std::string NameOf(HandName hand) {
  if (hand == HandName::kBoth) return "the pair of hands";
  if (hand == HandName::kAny) return "the hand 'any'";
  return "the " + std::string(ToString(hand)) + " hand";
}

}  // namespace

Demonstrator::Demonstrator(physics::World* world, world::Tabletop* tabletop)
    : world_(world), tabletop_(tabletop) {}

std::string Demonstrator::WhatHolds(HandName name) const {
  return NameOf(name) + " holds " + Named(tabletop_->Find(hand(name).held)->id());
}

/// Returns true if one of the hands holds a body; otherwise a carried body is held by the robot.
bool Demonstrator::IsInAHand(physics::BodyId body) const {
  return std::ranges::any_of(state_.hands, [body](const Hand& one) { return one.held == body; });
}

std::optional<Refusal> Demonstrator::RefuseToTake(HandName name, std::string_view object_id) const {
  // The order of checks decides which reason people read: existence, then the hand, then the
  // object.
  if (auto refusal = tabletop_->RefuseToReach(object_id)) return refusal;
  const Hand& own = hand(name);
  if (own.is_holding()) {
    return NameOf(name) + " already holds " + Named(tabletop_->Find(own.held)->id()) +
           "; release it first";
  }
  const physics::Body& body = world_->body(tabletop_->Find(object_id)->body);
  if (body.is_static()) return Named(object_id) + " is fixed (its mass is 0)";
  if (body.is_carried() && !IsInAHand(body.id())) return Named(object_id) + " is held by the robot";
  return std::nullopt;
}

GraspPlan Demonstrator::PlanGrasp(HandName name, std::string_view object_id) const {
  if (auto refusal = RefuseToTake(name, object_id)) return {.refusal = std::move(refusal)};
  GraspPlan plan;
  const physics::BodyId body = tabletop_->Find(object_id)->body;
  for (HandName other : kHandNames) {
    // Whichever hand holds the object hands it over.
    if (hand(other).held == body) plan.to_release.push_back(other);
  }
  // The rules apply to the situation after the object is handed over. `any` stands for whichever
  // physical hand is free, so whether it conflicts depends on the others.
  const auto holds = [&](HandName other) {
    return hand(other).is_holding() && hand(other).held != body;
  };
  const auto release = [&](HandName other) {
    if (holds(other)) plan.to_release.push_back(other);
  };
  using enum HandName;
  switch (name) {
    case kLeft:
    case kRight:
      // A single hand needs one physical hand: not the pair's, and not the one that `any` uses
      // while the other is busy.
      release(kBoth);
      if (holds(name == kLeft ? kRight : kLeft)) release(kAny);
      break;
    case kBoth:
      for (HandName other : {kLeft, kRight, kAny}) release(other);
      break;
    case kAny:
      if (holds(kBoth)) return {.refusal = "both hands are occupied: " + WhatHolds(kBoth)};
      if (holds(kLeft) && holds(kRight)) {
        return {.refusal =
                    "both hands are occupied: " + WhatHolds(kLeft) + ", " + WhatHolds(kRight)};
      }
      break;
  }
  return plan;
}

std::optional<Refusal> Demonstrator::Grasp(HandName name, std::string_view object_id,
                                           const std::optional<Vector3>& p_WQ) {
  const GraspPlan plan = PlanGrasp(name, object_id);
  if (plan.refusal) return plan.refusal;
  if (!plan.to_release.empty()) return WhatHolds(plan.to_release.front()) + "; release it first";
  physics::Body& body = world_->body(tabletop_->Find(object_id)->body);
  // The goal starts where the body is, so a grasp moves nothing.
  const RigidTransform X_WB = body.pose_in_world();
  body.SetCarried(true);
  MutableHand(name) = {.held = body.id(),
                       .X_WB_goal = X_WB,
                       .p_BH = p_WQ ? X_WB.inverse() * *p_WQ : Vector3(0, 0, 0),
                       .speed = servo_.max_speed};
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::RefuseIfEmpty(HandName name) const {
  if (hand(name).is_holding()) return std::nullopt;
  return NameOf(name) + " holds nothing";
}

std::optional<Refusal> Demonstrator::MoveTo(HandName name, const Vector3& p_WH,
                                            const std::optional<double>& speed) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  Hand& mover = MutableHand(name);
  // Keep the orientation; the grasped point goes to p_WH. Of the goal, not of the body: turns that
  // are still in progress are not lost.
  const Matrix3 R_WB = mover.X_WB_goal.rotation();
  mover.X_WB_goal = RigidTransform(R_WB, p_WH - R_WB * mover.p_BH);
  mover.speed = speed.value_or(servo_.max_speed);
  return std::nullopt;
}

void Demonstrator::TurnPlane(HandName name, double angle_deg) {
  state_.plane_angles_deg[static_cast<std::size_t>(name)] = angle_deg;
}

std::optional<Vector3> Demonstrator::PointOnPlane(HandName name, const Ray& ray, bool is_level,
                                                  Refusal* refusal) const {
  constexpr double kParallel = 1e-9, kFar = 100;  // sine of an angle, [m]
  const auto no = [refusal](Refusal why) {
    *refusal = std::move(why);
    return std::nullopt;
  };
  if (auto empty = RefuseIfEmpty(name)) return no(*empty);
  // Directions of any length come from clients; a zero or infinite one has no norm of 1.
  const Vector3 direction = ray.direction_in_world.stableNormalized();
  if (!(direction.norm() > 0.5)) return no("the ray has no direction");

  const double angle = DegreesToRadians(plane_angle_deg(name));
  const Vector3 normal =
      is_level ? Vector3::UnitZ() : Vector3(-std::sin(angle), std::cos(angle), 0);
  // Through the goal and not the body, which lags behind: the plane must not move while people
  // drag.
  const Vector3 p_WH = hand(name).X_WB_goal * hand(name).p_BH;
  // Intersection of the ray with the plane through the hand's goal.
  const double approach = normal.dot(direction);
  const std::string plane =
      std::string(is_level ? "the horizontal plane of " : "the motion plane of ") + NameOf(name);
  if (!(std::abs(approach) > kParallel)) return no("the ray is parallel to " + plane);
  const double distance = normal.dot(p_WH - ray.p_WOrigin) / approach;
  if (!(distance >= 0)) return no("the ray points away from " + plane);
  const Vector3 p_WHit = ray.p_WOrigin + distance * direction;
  if (!(distance <= kFar)) return no("the ray meets " + plane + " more than 100 m away");
  return p_WHit;
}

std::optional<Refusal> Demonstrator::Rotate(HandName name, const Vector3& angles_deg) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  Hand& turner = MutableHand(name);
  // Rotates the goal, not the body: the servo turns the body at its own speed.
  turner.X_WB_goal =
      RigidTransform(Matrix3(RotationFromFixedAxes(angles_deg) * turner.X_WB_goal.rotation()),
                     turner.X_WB_goal.translation());
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::Release(HandName name) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  physics::Body& body = world_->body(hand(name).held);
  body.SetCarried(false);
  // A released object is not thrown.
  body.SetVelocity(Vector3::Zero(), Vector3::Zero());
  MutableHand(name) = Hand();
  return std::nullopt;
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
    if (hand(name).held == object.body) return WhatHolds(name) + "; release it first";
  }
  if (world_->body(object.body).is_carried()) return Named(object.id()) + " is held by the robot";
  state_.attention.erase(object.body);
  tabletop_->Destroy(object);
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::RefuseIfHolding(HandName name, const char* what) const {
  if (!hand(name).is_holding()) return std::nullopt;
  return WhatHolds(name) + "; it must be empty to " + what;
}

std::optional<Refusal> Demonstrator::PointAt(HandName name, std::string_view part_id) const {
  if (auto refusal = RefuseIfHolding(name, "point")) return refusal;
  return tabletop_->RefuseToPoint(part_id);
}

std::optional<Refusal> Demonstrator::Trigger(HandName name, std::string_view control,
                                             std::string_view part) {
  if (auto refusal = RefuseIfHolding(name, "trigger a control")) return refusal;
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
    return RefuseIfHolding(name, "fasten or loosen anything else");
  }
  const physics::Body& body = world_->body(object->body);
  if (body.is_carried() && !IsInAHand(body.id())) return Named(object_id) + " is held by the robot";
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
  // Overlap that the tool may have with other objects at its new place [m].
  constexpr double kMaxOverlap = 0.002;
  const Vector3 moved = world_->body(work.body).pose_in_world().translation() - p_WW_before;
  if (moved == Vector3(Vector3::Zero())) return;
  const RigidTransform X_WB = world_->body(tool.body).pose_in_world();
  const RigidTransform X_there(X_WB.rotation(), X_WB.translation() + moved);
  for (const physics::BodyId blocker : world_->OverlapsAt(tool.body, X_there, kMaxOverlap).bodies) {
    if (blocker != work.body) return;
  }
  world_->MoveAssembly(tool.body, X_there);
}

void Demonstrator::BeforeStep() {
  for (const Hand& hand : state_.hands) {
    if (!hand.is_holding()) continue;
    DriveTowards(hand.X_WB_goal, hand.speed, world_->config().step_seconds, servo_,
                 &world_->body(hand.held));
  }
}

bool Demonstrator::has_arrived() const {
  return std::ranges::all_of(kHandNames, [this](HandName name) { return has_arrived(name); });
}

bool Demonstrator::has_arrived(HandName name) const {
  // A servo approaches its goal asymptotically; below this no one sees a difference.
  constexpr double kNear = 0.0005, kAligned = DegreesToRadians(0.5);
  const Hand& wanting = hand(name);
  if (!wanting.is_holding()) return true;
  const RigidTransform X_WB = world_->body(wanting.held).pose_in_world();
  const double gap = (X_WB.translation() - wanting.X_WB_goal.translation()).norm();
  const double turn =
      RotationVectorBetween(X_WB.quaternion(), wanting.X_WB_goal.quaternion()).norm();
  return gap <= kNear && turn <= kAligned;
}

void Demonstrator::AddToHash(StateHash* hash) const {
  for (const Hand& hand : state_.hands) {
    hash->Add(std::uint64_t{hand.held.value});
    // An empty hand has no goal; stale numbers must not enter the hash.
    if (!hand.is_holding()) continue;
    for (double number : hand.X_WB_goal.rotation().reshaped()) hash->Add(number);
    for (double number : hand.X_WB_goal.translation()) hash->Add(number);
    for (double number : hand.p_BH) hash->Add(number);
    hash->Add(hand.speed);
  }
  hash->Add(state_.plane_angles_deg);
  for (const auto& [body, properties] : state_.attention) {
    hash->Add(std::uint64_t{body.value});
    hash->Add(std::uint64_t{properties.size()});
    for (const std::string& property : properties) hash->Add(property);
  }
}

}  // namespace smile::demonstrator
