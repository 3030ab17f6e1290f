#include "demonstrator/demonstrator.h"

#include "math/angles.h"

namespace smile::demonstrator {

using world::Named;

namespace {

std::string NameOf(HandName hand) { return "the " + std::string(ToString(hand)) + " hand"; }

}  // namespace

Demonstrator::Demonstrator(physics::World* world, world::Tabletop* tabletop)
    : world_(world), tabletop_(tabletop) {}

std::optional<Refusal> Demonstrator::Grasp(HandName name, std::string_view object_id,
                                           const std::optional<Vector3>& p_WQ) {
  const world::Object* object = tabletop_->Find(object_id);
  if (object == nullptr) return "there is no object " + Named(object_id);
  const Hand& own = hand(name);
  if (own.is_holding()) {
    return NameOf(name) + " already holds " + Named(tabletop_->Find(own.held)->id()) +
           "; release it first";
  }
  for (HandName other : kHandNames) {
    if (hand(other).held == object->body) {
      return Named(object_id) + " is already held by " + NameOf(other);
    }
  }
  physics::Body& body = world_->body(object->body);
  if (body.is_static()) return Named(object_id) + " is fixed (its mass is 0)";
  if (body.is_carried()) return Named(object_id) + " is held by the robot";

  const RigidTransform X_WB = body.pose_in_world();
  body.SetCarried(true);
  MutableHand(name) = {.held = object->body,
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
  const Matrix3 R_WB = mover.X_WB_goal.rotation();
  mover.X_WB_goal = RigidTransform(R_WB, p_WH - R_WB * mover.p_BH);
  mover.speed = speed.value_or(servo_.max_speed);
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::Rotate(HandName name, const Vector3& angles_deg) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  Hand& turner = MutableHand(name);
  turner.X_WB_goal =
      RigidTransform(Matrix3(RotationFromFixedAxes(angles_deg) * turner.X_WB_goal.rotation()),
                     turner.X_WB_goal.translation());
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::Release(HandName name) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  physics::Body& body = world_->body(hand(name).held);
  body.SetCarried(false);
  body.SetVelocity(Vector3::Zero(), Vector3::Zero());
  MutableHand(name) = Hand();
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::Destroy(HandName name) {
  if (auto refusal = RefuseIfEmpty(name)) return refusal;
  const world::Object& object = *tabletop_->Find(hand(name).held);
  MutableHand(name) = Hand();
  tabletop_->Destroy(object);
  return std::nullopt;
}

std::optional<Refusal> Demonstrator::RefuseIfHolding(HandName name, const char* what) const {
  if (!hand(name).is_holding()) return std::nullopt;
  return NameOf(name) + " holds " + Named(tabletop_->Find(hand(name).held)->id()) +
         "; it must be empty to " + what;
}

std::optional<Refusal> Demonstrator::PointAt(HandName name, std::string_view part_id) const {
  if (auto refusal = RefuseIfHolding(name, "point")) return refusal;
  if (tabletop_->FindPointable(part_id) != nullptr) return std::nullopt;
  return "there is no object " + Named(part_id) + ", nor a part so called that is pointable";
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
  const world::Object* object = tabletop_->Find(object_id);
  if (object == nullptr) return "there is no object " + Named(object_id);
  const Hand& own = hand(name);
  if (own.is_holding() && own.held != object->body) {
    return RefuseIfHolding(name, "fasten or loosen anything else");
  }
  const physics::Body& body = world_->body(object->body);
  bool is_in_hand = false;
  for (const Hand& any : state_.hands) is_in_hand = is_in_hand || any.held == object->body;
  if (body.is_carried() && !is_in_hand) return Named(object_id) + " is held by the robot";

  std::array<RigidTransform, kHandNames.size()> before;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (state_.hands[i].is_holding())
      before[i] = world_->body(state_.hands[i].held).pose_in_world();
  }
  const Vector3 p_WPoint = p_WQ.value_or(body.pose_in_world().translation());
  if (auto refusal = (tabletop_->*turning)(*object, p_WPoint)) return refusal;
  // What a hand holds was put elsewhere: where the hand wants it goes along.
  for (std::size_t i = 0; i < before.size(); ++i) {
    Hand& hand_of = state_.hands[i];
    if (!hand_of.is_holding()) continue;
    const RigidTransform X_WB = world_->body(hand_of.held).pose_in_world();
    if (X_WB == before[i]) continue;
    hand_of.X_WB_goal = X_WB * (before[i].inverse() * hand_of.X_WB_goal);
  }
  return std::nullopt;
}

void Demonstrator::BeforeStep() {
  for (const Hand& hand : state_.hands) {
    if (!hand.is_holding()) continue;
    DriveTowards(hand.X_WB_goal, hand.speed, world_->config().step_seconds, servo_,
                 &world_->body(hand.held));
  }
}

bool Demonstrator::has_arrived() const {
  constexpr double kNear = 0.0005, kAligned = DegreesToRadians(0.5);
  for (const Hand& hand : state_.hands) {
    if (!hand.is_holding()) continue;
    const RigidTransform X_WB = world_->body(hand.held).pose_in_world();
    const double gap = (X_WB.translation() - hand.X_WB_goal.translation()).norm();
    const double turn =
        RotationVectorBetween(X_WB.quaternion(), hand.X_WB_goal.quaternion()).norm();
    if (!(gap <= kNear && turn <= kAligned)) return false;
  }
  return true;
}

}  // namespace smile::demonstrator
