// Hands are goals with limits of force, not bodies. A command changes goals and holds at once or is
// refused with a reason and without effect.

#include "demonstrator/hands.h"

#include <algorithm>

#include "base/state_hash.h"
#include "math/angles.h"

namespace smile::demonstrator {

using mechanics::BodyId;
using texts::Say;

Refusal NameOf(HandName hand) { return Say("hands.name", {{"hand", ToString(hand)}}); }

Refusal Hands::WhatHolds(HandName name) const {
  return Say("hands.holds",
             {{"hand", NameOf(name)}, {"object", engine_.ObjectOf(hand(name).held)}});
}

bool Hands::IsInAHand(BodyId body) const {
  return std::ranges::any_of(states_, [body](const Hand& one) { return one.held == body; });
}

std::optional<Refusal> Hands::RefuseToTake(HandName name, std::string_view object_id) const {
  // The order of checks decides which reason people read: existence, then the hand, then the
  // object.
  if (auto refusal = engine_.RefuseToReach(object_id)) return refusal;
  if (hand(name).is_holding()) {
    return Say("hands.alreadyHolds",
               {{"hand", NameOf(name)}, {"object", engine_.ObjectOf(hand(name).held)}});
  }
  const BodyId body = engine_.BodyOf(object_id);
  if (IsInAHand(body)) return std::nullopt;
  return engine_.RefuseToCarry(body);
}

bool Hands::HoldsAnother(HandName name, BodyId body) const {
  return hand(name).is_holding() && hand(name).held != body;
}

/// Returns the reason why no physical hand is free for `any`, after `body` is handed over.
std::optional<Refusal> Hands::RefuseAny(BodyId body) const {
  using enum HandName;
  if (HoldsAnother(kBoth, body)) return Say("hands.pairIsOccupied", {{"why", WhatHolds(kBoth)}});
  if (HoldsAnother(kLeft, body) && HoldsAnother(kRight, body)) {
    return Say("hands.bothAreOccupied", {{"left", WhatHolds(kLeft)}, {"right", WhatHolds(kRight)}});
  }
  return std::nullopt;
}

/// Returns the hands that use a physical hand which `name` needs, after `body` is handed over.
std::vector<HandName> Hands::InTheWay(HandName name, BodyId body) const {
  using enum HandName;
  std::vector<HandName> needed;
  if (name == kBoth) {
    needed = {kLeft, kRight, kAny};
  } else if (name != kAny) {
    // A single hand needs one physical hand: not the pair's, and not the one that `any` uses while
    // the other is busy.
    needed = {kBoth};
    if (HoldsAnother(name == kLeft ? kRight : kLeft, body)) needed.push_back(kAny);
  }
  std::erase_if(needed, [&](HandName other) { return !HoldsAnother(other, body); });
  return needed;
}

GraspPlan Hands::PlanGrasp(HandName name, std::string_view object_id) const {
  if (auto refusal = RefuseToTake(name, object_id)) return {.refusal = std::move(refusal)};
  GraspPlan plan;
  const BodyId body = engine_.BodyOf(object_id);
  // The rules apply to the situation after the object is handed over. `any` stands for whichever
  // physical hand is free, so whether it conflicts depends on the others.
  if (name == HandName::kAny) {
    if (auto refusal = RefuseAny(body)) return {.refusal = std::move(refusal)};
  }
  for (HandName other : kHandNames) {
    // Whichever hand holds the object hands it over.
    if (hand(other).held == body) plan.to_release.push_back(other);
  }
  for (HandName other : InTheWay(name, body)) plan.to_release.push_back(other);
  return plan;
}

std::optional<Refusal> Hands::Grasp(HandName name, std::string_view object_id,
                                    const std::optional<Vector3>& p_WQ) {
  const GraspPlan plan = PlanGrasp(name, object_id);
  if (plan.refusal) return plan.refusal;
  if (!plan.to_release.empty()) {
    return Say("hands.releaseFirst", {{"why", WhatHolds(plan.to_release.front())}});
  }
  const BodyId body = engine_.BodyOf(object_id);
  // The goal starts where the body is, so a grasp moves nothing.
  const RigidTransform X_WB = engine_.MotionOf(body).X_WB;
  engine_.SetCarried(body, true);
  MutableHand(name) = {.held = body,
                       .X_WB_goal = X_WB,
                       .p_BH = p_WQ ? X_WB.inverse() * *p_WQ : Vector3(0, 0, 0),
                       .speed = servo_.max_speed};
  return std::nullopt;
}

std::optional<Refusal> Hands::RefuseIfEmpty(HandName name) const {
  if (hand(name).is_holding()) return std::nullopt;
  return Say("hands.isEmpty", {{"hand", NameOf(name)}});
}

std::optional<Refusal> Hands::MoveTo(HandName name, const Vector3& p_WH,
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

std::optional<Refusal> Hands::Rotate(HandName name, const Vector3& angles_deg) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  Hand& turner = MutableHand(name);
  // Rotates the goal, not the body: the servo turns the body at its own speed.
  turner.X_WB_goal =
      RigidTransform(Matrix3(RotationFromFixedAxes(angles_deg) * turner.X_WB_goal.rotation()),
                     turner.X_WB_goal.translation());
  return std::nullopt;
}

std::optional<Refusal> Hands::Release(HandName name) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  const BodyId body = hand(name).held;
  engine_.SetCarried(body, false);
  // A released object is not thrown.
  engine_.SetVelocity(body, Vector3::Zero(), Vector3::Zero());
  MutableHand(name) = Hand();
  return std::nullopt;
}

void Hands::BeforeStep() {
  for (const Hand& hand : states_) {
    if (!hand.is_holding()) continue;
    DriveTowards(hand.X_WB_goal, hand.speed, servo_, hand.held, &engine_);
  }
}

bool Hands::has_arrived(HandName name) const {
  // A servo approaches its goal asymptotically; below this no one sees a difference.
  constexpr double kNear = 0.0005, kAligned = DegreesToRadians(0.5);
  const Hand& wanting = hand(name);
  if (!wanting.is_holding()) return true;
  const RigidTransform X_WB = engine_.MotionOf(wanting.held).X_WB;
  const double gap = (X_WB.translation() - wanting.X_WB_goal.translation()).norm();
  const double turn =
      RotationVectorBetween(X_WB.quaternion(), wanting.X_WB_goal.quaternion()).norm();
  return gap <= kNear && turn <= kAligned;
}

void AddToHash(const HandStates& states, StateHash* hash) {
  for (const Hand& hand : states) {
    hash->Add(std::uint64_t{hand.held.value});
    // An empty hand has no goal; stale numbers must not enter the hash.
    if (!hand.is_holding()) continue;
    for (double number : hand.X_WB_goal.rotation().reshaped()) hash->Add(number);
    for (double number : hand.X_WB_goal.translation()) hash->Add(number);
    for (double number : hand.p_BH) hash->Add(number);
    hash->Add(hand.speed);
  }
}

}  // namespace smile::demonstrator
