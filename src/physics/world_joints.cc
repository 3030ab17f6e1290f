// Joints of a World: how they come and go, and what they hold together.

#include <algorithm>
#include <stdexcept>
#include <string>

#include "physics/internal_articulation_links.h"
#include "physics/internal_checks.h"
#include "physics/internal_engine.h"
#include "physics/world.h"

namespace smile::physics {
namespace {

/// Force and torque a weld may use against what the held body runs into [N s per second of step].
constexpr double kWeldEffort = 2000.0;

}  // namespace

void World::CheckJoint(const JointSpec& spec) const {
  physics::CheckJoint(
      spec, [this](BodyId id) { return body(id).is_static(); },
      [this](ArticulationId id) { return articulation(id).num_joints(); });
}

JointId World::AddJoint(const JointSpec& spec) {
  CheckJoint(spec);
  if (const auto* weld = std::get_if<WeldSpec>(&spec)) body(weld->body).SetCarried(true);
  WakeJoined(spec);
  Insert(Joint{JointId{next_joint_id_++}, spec});
  return joints_.back().id;
}

/// The joint is the newest.
void World::Insert(const Joint& joint) {
  if (const auto* weld = std::get_if<WeldSpec>(&joint.spec)) {
    ExcludeLinks(*weld);
    if (IsLed(*weld)) {
      SetLed(weld->body, true);
    } else {
      auto& bullet = engine_->welds[joint.id] = MakeBulletWeld(*weld);
      engine_->world.addMultiBodyConstraint(bullet.get());
    }
  } else {
    if (!DoCollide(joint.spec)) {
      const auto [a, b] = *BodyPairOf(joint.spec);
      engine_->broadphase.Exclude(*body(a).bullet_, *body(b).bullet_, &engine_->dispatcher);
    }
    auto& bullet = engine_->joints[joint.id] = MakeBulletJoint(joint);
    engine_->world.addConstraint(bullet.get());
  }
  joints_.push_back(joint);
}

void World::ExcludeLinks(const WeldSpec& weld) {
  const Articulation& holder = articulation(weld.articulation);
  const Body& held = body(weld.body);
  for (int link : weld.links_not_colliding) {
    if (const auto* collider = holder.links_->collider(link)) {
      engine_->broadphase.Exclude(*collider, *held.bullet_, &engine_->dispatcher);
    }
  }
}

std::unique_ptr<btMultiBodyFixedConstraint> World::MakeBulletWeld(const WeldSpec& spec) {
  const Articulation& holder = articulation(spec.articulation);
  const Body& held = body(spec.body);
  const RigidTransform X_LcmBcm =
      holder.links_->links[spec.link].X_LLcm.inverse() * spec.X_LB * held.X_BcmB_.inverse();
  auto weld = std::make_unique<btMultiBodyFixedConstraint>(
      holder.bullet_.get(), spec.link, held.bullet_.get(), ToBullet(X_LcmBcm.translation()),
      btVector3(0, 0, 0), ToBullet(X_LcmBcm.rotation()), btMatrix3x3::getIdentity());
  weld->setMaxAppliedImpulse(kWeldEffort * config_.step_seconds);
  return weld;
}

std::unique_ptr<JointConstraint> World::MakeBulletJoint(const Joint& joint) {
  const auto pair = *BodyPairOf(joint.spec);
  const Body &a = body(pair.first), &b = body(pair.second);
  return std::make_unique<JointConstraint>(static_cast<int>(joint.id.value), joint.spec, *a.bullet_,
                                           a.X_BcmB_, *b.bullet_, b.X_BcmB_);
}

void World::RemoveJoint(JointId id) {
  const auto found = std::find_if(joints_.begin(), joints_.end(),
                                  [id](const Joint& other) { return other.id == id; });
  if (found == joints_.end()) {
    throw std::logic_error("joint " + std::to_string(id.value) + " does not exist");
  }
  const Joint joint = *found;
  joints_.erase(found);
  PairFilter& filter = engine_->broadphase.filter();
  if (const auto* weld = std::get_if<WeldSpec>(&joint.spec)) {
    const Articulation& holder = articulation(weld->articulation);
    for (int link : weld->links_not_colliding) {
      const auto* collider = holder.links_->collider(link);
      if (collider) filter.Include(OrderOf(collider), static_cast<int>(weld->body.value));
    }
    if (const auto bullet = engine_->welds.find(id); bullet != engine_->welds.end()) {
      engine_->world.RemoveConstraintInOrder(bullet->second.get());
      engine_->welds.erase(bullet);
    }
    bool is_held_still = false, is_led_still = false;
    for (const Joint& other : joints_) {
      const auto* holds = std::get_if<WeldSpec>(&other.spec);
      if (holds == nullptr || holds->body != weld->body) continue;
      is_held_still = true;
      is_led_still = is_led_still || IsLed(*holds);
    }
    body(weld->body).SetCarried(is_held_still);
    SetLed(weld->body, is_led_still);
  } else {
    const auto [a, b] = *BodyPairOf(joint.spec);
    if (!DoCollide(joint.spec))
      filter.Include(static_cast<int>(a.value), static_cast<int>(b.value));
    engine_->world.RemoveConstraintInOrder(engine_->joints.at(id).get());
    engine_->joints.erase(id);
  }
  WakeJoined(joint.spec);
}

/// What nothing can push collides with less than others.
void World::SetLed(BodyId id, bool is_led) {
  Body& held = body(id);
  if (held.is_led_ == is_led) return;
  held.SetLed(is_led);
  engine_->broadphase.DropPairsOf(*held.bullet_, &engine_->dispatcher);
}

void World::LeadHeldBodies() {
  for (const Joint& joint : joints_) {
    const auto* weld = std::get_if<WeldSpec>(&joint.spec);
    if (weld == nullptr || !IsLed(*weld)) continue;
    const auto X_WL = articulation(weld->articulation).next_link_poses();
    body(weld->body).LeadTo(X_WL[weld->link] * weld->X_LB, config_.step_seconds);
  }
}

void World::PlaceHeldBodies() {
  for (const Joint& joint : joints_) {
    const auto* weld = std::get_if<WeldSpec>(&joint.spec);
    if (weld == nullptr || !IsLed(*weld)) continue;
    const auto X_WL = articulation(weld->articulation).link_poses();
    body(weld->body).PlaceAt(X_WL[weld->link] * weld->X_LB);
  }
}

void World::WakeJoined(const JointSpec& spec) {
  if (const auto pair = BodyPairOf(spec)) {
    body(pair->first).WakeUp();
    body(pair->second).WakeUp();
  } else {
    body(std::get<WeldSpec>(spec).body).WakeUp();
  }
}

/// Ties the joints of a body that was rebuilt to the new one, each in its place in the order.
void World::RejoinBullet(BodyId id) {
  for (const Joint& joint : joints_) {
    if (!Joins(joint.spec, id)) continue;
    if (const auto* weld = std::get_if<WeldSpec>(&joint.spec)) {
      if (IsLed(*weld)) {
        SetLed(id, true);
        continue;
      }
      auto& old = engine_->welds.at(joint.id);
      auto fresh = MakeBulletWeld(*weld);
      engine_->world.ReplaceConstraint(old.get(), fresh.get());
      old = std::move(fresh);
    } else {
      auto& old = engine_->joints.at(joint.id);
      auto fresh = MakeBulletJoint(joint);
      ByteWriter state;
      old->Save(&state);
      const std::vector<std::byte> bytes = state.Take();
      ByteReader in(bytes);
      fresh->Restore(&in);
      engine_->world.ReplaceConstraint(old.get(), fresh.get());
      old = std::move(fresh);
    }
  }
}

std::vector<BodyId> World::BodiesJoinedWith(BodyId id, JointId without) const {
  std::vector<std::pair<BodyId, BodyId>> ties;
  for (const Joint& joint : joints_) {
    if (joint.id == without) continue;
    const auto pair = BodyPairOf(joint.spec);
    if (!pair) continue;
    ties.push_back(*pair);
    ties.emplace_back(pair->second, pair->first);
  }
  std::sort(ties.begin(), ties.end());
  std::vector<BodyId> found = {id};  // sorted
  std::vector<BodyId> to_visit = {id};
  while (!to_visit.empty()) {
    const BodyId from = to_visit.back();
    to_visit.pop_back();
    if (body(from).is_static()) continue;
    for (auto tie = std::lower_bound(ties.begin(), ties.end(), std::pair(from, BodyId{0}));
         tie != ties.end() && tie->first == from; ++tie) {
      const auto place = std::lower_bound(found.begin(), found.end(), tie->second);
      if (place != found.end() && *place == tie->second) continue;
      found.insert(place, tie->second);
      to_visit.push_back(tie->second);
    }
  }
  return found;
}

std::vector<BodyId> World::Assembly(BodyId id, JointId without) const {
  std::vector<BodyId> members = BodiesJoinedWith(id, without);
  std::erase_if(members,
                [this, id](BodyId member) { return member != id && body(member).is_static(); });
  return members;
}

bool World::IsAnchored(BodyId id, JointId without) const {
  const std::vector<BodyId> members = BodiesJoinedWith(id, without);
  return std::any_of(members.begin(), members.end(), [this, id](BodyId member) {
    return member != id && body(member).is_static();
  });
}

void World::MoveAssembly(BodyId id, const RigidTransform& X_WB) {
  const RigidTransform X_moved = X_WB * body(id).pose_in_world().inverse();
  for (BodyId member : Assembly(id)) {
    Body& one = body(member);
    one.SetPose(member == id ? X_WB : X_moved * one.pose_in_world());
  }
}

}  // namespace smile::physics
