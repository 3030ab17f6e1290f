#include "physics/internal_joint_set.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "base/state_hash.h"
#include "mechanics/checks.h"
#include "physics/internal_body_dynamics.h"

// All joints of a world, in the order in which they were made. Welds are forwarded to HeldBodies;
// all others are constraints of the solver. The map of constraints is sorted by id, so saving and
// restoring visit them in the same order.

namespace smile::physics {

JointSet::JointSet(const WorldObjects& objects, HeldBodies& held_bodies, Engine& engine)
    : objects_(objects), held_bodies_(held_bodies), engine_(engine) {}

JointSet::~JointSet() {
  engine_.dormant_islands.ReturnAll();
  RemoveAll();
}

void JointSet::Check(const JointSpec& spec) const {
  CheckJoint(
      spec, [this](BodyId id) { return objects_.body(id).is_static(); },
      [this](ArticulationId id) { return objects_.articulation(id).num_joints(); });
}

JointId JointSet::Add(const JointSpec& spec) {
  Check(spec);
  Insert(Joint{JointId{next_id_++}, spec});
  return joints_.back().id;
}

void JointSet::Insert(const Joint& joint) {
  if (const auto* weld = std::get_if<WeldSpec>(&joint.spec)) {
    held_bodies_.Hold(joint.id, *weld);
  } else {
    const auto [a, b] = *BodyPairOf(joint.spec);
    Wake({a, b});
    // Bodies that are joined usually touch: without the exclusion, contacts would work against the
    // joint.
    if (!DoCollide(joint.spec)) {
      engine_.broadphase.Exclude(objects_.body(a).dynamics().bullet(),
                                 objects_.body(b).dynamics().bullet(), &engine_.dispatcher);
    }
    auto& constraint = constraints_[joint.id] = MakeConstraint(joint);
    engine_.world.addConstraint(constraint.get());
  }
  // Last: if something above throws, the list has no half-made joint.
  joints_.push_back(joint);
}

void JointSet::Remove(JointId id) {
  const auto found = std::find_if(joints_.begin(), joints_.end(),
                                  [id](const Joint& other) { return other.id == id; });
  if (found == joints_.end()) {
    throw std::logic_error("joint " + std::to_string(id.value) + " does not exist");
  }
  if (const auto pair = BodyPairOf(found->spec)) {
    if (!DoCollide(found->spec)) {
      engine_.broadphase.filter().Include(static_cast<int>(pair->first.value),
                                          static_cast<int>(pair->second.value));
    }
    // Bullet's world does not own constraints: remove, then destroy.
    engine_.world.RemoveConstraintInOrder(constraints_.at(id).get());
    constraints_.erase(id);
    Wake(*pair);
  } else {
    held_bodies_.Release(id);
  }
  joints_.erase(found);
}

void JointSet::RemoveAllOf(BodyId id) {
  // Collect first: Remove() changes the list.
  std::vector<JointId> ended;
  for (const Joint& joint : joints_) {
    if (Joins(joint.spec, id)) ended.push_back(joint.id);
  }
  for (JointId joint : ended) Remove(joint);
}

void JointSet::RemoveAll() {
  while (!joints_.empty()) Remove(joints_.back().id);
}

void JointSet::Rejoin(BodyId id) {
  held_bodies_.Rejoin(id);
  for (const Joint& joint : joints_) {
    const auto found = constraints_.find(joint.id);
    if (found == constraints_.end() || !Joins(joint.spec, id)) continue;
    auto& old = found->second;
    // The new constraint refers to the new Bullet body; held offset and pressed limits carry over.
    auto fresh = MakeConstraint(joint);
    ByteWriter state;
    old->Save(&state);
    const std::vector<std::byte> bytes = state.Take();
    ByteReader in(bytes);
    fresh->Restore(&in);
    engine_.world.ReplaceConstraint(old.get(), fresh.get());
    old = std::move(fresh);
  }
}

std::unique_ptr<JointConstraint> JointSet::MakeConstraint(const Joint& joint) const {
  const auto pair = *BodyPairOf(joint.spec);
  Body::Dynamics &a = objects_.body(pair.first).dynamics(),
                 &b = objects_.body(pair.second).dynamics();
  return std::make_unique<JointConstraint>(static_cast<int>(joint.id.value), joint.spec, a.bullet(),
                                           a.X_BcmB(), b.bullet(), b.X_BcmB());
}

void JointSet::Wake(const std::pair<BodyId, BodyId>& pair) {
  objects_.body(pair.first).WakeUp();
  objects_.body(pair.second).WakeUp();
}

void JointSet::Save(Snapshot* snapshot, ByteWriter* state) const {
  snapshot->next_joint_id = next_id_;
  snapshot->joints = joints_;
  for (const auto& [id, constraint] : constraints_) constraint->Save(state);
}

void JointSet::Restore(const Snapshot& snapshot) {
  if (!AreThoseOf(snapshot)) {
    for (const Joint& joint : snapshot.joints) Insert(joint);
  }
  next_id_ = snapshot.next_joint_id;
}

void JointSet::RestoreState(ByteReader* in) {
  for (const auto& [id, constraint] : constraints_) constraint->Restore(in);
}

void JointSet::AddTo(StateHash* hash) const {
  for (const Joint& joint : joints_) {
    // Hash the serialized form, which contains each field of any kind of joint.
    ByteWriter bytes;
    PutJoint(joint, &bytes);
    // Welds have no state of their own.
    const auto constraint = constraints_.find(joint.id);
    if (constraint != constraints_.end()) constraint->second->Save(&bytes);
    hash->Add(std::string_view(reinterpret_cast<const char*>(bytes.bytes().data()), bytes.size()));
  }
}

}  // namespace smile::physics
