// World::Save() and World::Restore(); the recipe stands in docs/decisions/physics.md.

#include <algorithm>
#include <stdexcept>

#include "base/bytes.h"
#include "physics/internal_articulation_links.h"
#include "physics/internal_checks.h"
#include "physics/internal_contact_cache.h"
#include "physics/internal_engine.h"
#include "physics/world.h"

namespace smile::physics {
namespace {

void Put(ByteWriter* out, const btVector3& v) {
  for (int i = 0; i < 3; ++i) out->Put(static_cast<double>(v[i]));
}
void Put(ByteWriter* out, const btTransform& X) {
  for (int row = 0; row < 3; ++row) Put(out, X.getBasis()[row]);
  Put(out, X.getOrigin());
}
btVector3 GetVector(ByteReader* in) {
  const double x = in->Get<double>(), y = in->Get<double>(), z = in->Get<double>();
  return {x, y, z};
}
btTransform GetTransform(ByteReader* in) {
  btMatrix3x3 R;
  for (int row = 0; row < 3; ++row) R[row] = GetVector(in);
  return btTransform(R, GetVector(in));
}

/// What bodies and links have in common.
void SaveObject(const btCollisionObject& object, ByteWriter* out) {
  Put(out, object.getWorldTransform());
  Put(out, object.getInterpolationWorldTransform());
  Put(out, object.getInterpolationLinearVelocity());
  Put(out, object.getInterpolationAngularVelocity());
  out->Put(object.getActivationState());
  out->Put(static_cast<double>(object.getDeactivationTime()));
  out->Put(static_cast<double>(object.getHitFraction()));
  Put(out, object.getBroadphaseHandle()->m_aabbMin);
  Put(out, object.getBroadphaseHandle()->m_aabbMax);
}

void RestoreObject(ByteReader* in, btCollisionObject* object) {
  object->setWorldTransform(GetTransform(in));
  object->setInterpolationWorldTransform(GetTransform(in));
  object->setInterpolationLinearVelocity(GetVector(in));
  object->setInterpolationAngularVelocity(GetVector(in));
  object->forceActivationState(in->Get<int>());
  object->setDeactivationTime(in->Get<double>());
  object->setHitFraction(in->Get<double>());
  object->getBroadphaseHandle()->m_aabbMin = GetVector(in);
  object->getBroadphaseHandle()->m_aabbMax = GetVector(in);
}

/// True when the entry is of this very thing.
template <class Thing, class Entry>
bool Is(const Thing& thing, const Entry& entry) {
  return thing.id() == entry.id &&
         (&thing.spec() == entry.spec.get() || thing.spec() == *entry.spec);
}

}  // namespace

Snapshot World::Save() const {
  Snapshot snapshot{.next_id = next_id_,
                    .next_joint_id = next_joint_id_,
                    .joints = joints_,
                    .passing = passing_,
                    .close_fits = close_fits_};
  ByteWriter out;
  for (const auto& body : bodies_) {
    snapshot.bodies.push_back({body->id(), body->spec_});
    const btRigidBody& bullet = *body->bullet_;
    SaveObject(bullet, &out);
    Put(&out, bullet.getLinearVelocity());
    Put(&out, bullet.getAngularVelocity());
    out.Put(body->is_carried_);
  }
  for (const auto& articulation : articulations_) {
    snapshot.articulations.push_back({articulation->id(), articulation->spec_});
    for (int i = 0; i < articulation->num_joints(); ++i) {
      out.Put(static_cast<double>(articulation->bullet_->getJointPos(i)));
      out.Put(static_cast<double>(articulation->bullet_->getJointVel(i)));
      out.Put(articulation->velocity_targets_[i]);
      out.Put(articulation->position_references_[i]);
    }
    for (int i = -1; i < articulation->num_joints(); ++i) {
      if (const auto* collider = articulation->links_->collider(i)) SaveObject(*collider, &out);
    }
  }
  for (const auto& [id, joint] : engine_->joints) joint->Save(&out);
  out.Put(static_cast<std::uint64_t>(engine_->solver.getRandSeed()));
  SaveContacts(engine_->world, &out);
  snapshot.state = out.Take();
  return snapshot;
}

void World::Restore(const Snapshot& snapshot) {
  CheckSnapshot(snapshot);
  MatchObjects(snapshot);
  ByteReader in(snapshot.state);
  for (const auto& body : bodies_) {
    btRigidBody& bullet = *body->bullet_;
    RestoreObject(&in, &bullet);
    bullet.setLinearVelocity(GetVector(&in));
    bullet.setAngularVelocity(GetVector(&in));
    bullet.clearForces();
    bullet.updateInertiaTensor();
    body->is_carried_ = in.Get<bool>();
  }
  for (const auto& articulation : articulations_) {
    for (int i = 0; i < articulation->num_joints(); ++i) {
      articulation->bullet_->setJointPos(i, in.Get<double>());
      articulation->bullet_->setJointVel(i, in.Get<double>());
      articulation->velocity_targets_[i] = in.Get<double>();
      articulation->position_references_[i] = in.Get<double>();
    }
    articulation->UpdateLinkTransforms();
    for (int i = -1; i < articulation->num_joints(); ++i) {
      if (auto* collider = articulation->links_->collider(i)) RestoreObject(&in, collider);
    }
  }
  for (const auto& [id, joint] : engine_->joints) joint->Restore(&in);
  engine_->solver.setRandSeed(static_cast<unsigned long>(in.Get<std::uint64_t>()));
  RestoreContacts(engine_->world, engine_->broadphase, &in);
  if (!in.ok() || in.remaining() > 0) {
    throw std::invalid_argument("snapshot: its state does not fit its objects");
  }
}

/// Adds, removes and rebuilds until the world holds the snapshot's objects and joints, nothing
/// else. Joints are made anew: they read their own state later. What can fail comes first.
void World::MatchObjects(const Snapshot& snapshot) {
  std::vector<std::unique_ptr<Articulation>> fresh_articulations;
  for (std::size_t i = 0; i < std::max(articulations_.size(), snapshot.articulations.size()); ++i) {
    if (i >= articulations_.size()) {
      const auto& entry = snapshot.articulations[i];
      fresh_articulations.emplace_back(new Articulation(entry.id, entry.spec, config_.motor));
    } else if (i >= snapshot.articulations.size() ||
               !Is(*articulations_[i], snapshot.articulations[i])) {
      throw std::invalid_argument("snapshot: it is of a world without this robot");
    }
  }
  std::vector<std::unique_ptr<Body>> fresh_bodies;
  std::vector<BodyId> gone;
  auto old = bodies_.begin();
  for (const auto& entry : snapshot.bodies) {
    while (old != bodies_.end() && (*old)->id() < entry.id) gone.push_back((*old++)->id());
    const bool is_there = old != bodies_.end() && (*old)->id() == entry.id;
    if (is_there && Is(**old++, entry)) continue;
    if (is_there) gone.push_back(entry.id);
    fresh_bodies.emplace_back(new Body(entry.id, entry.spec));
  }
  while (old != bodies_.end()) gone.push_back((*old++)->id());

  while (!joints_.empty()) RemoveJoint(joints_.back().id);
  EndAllPassing();
  while (!gone.empty()) {
    Erase(body(gone.back()));
    gone.pop_back();
  }
  for (auto& fresh : fresh_bodies) Insert(std::move(fresh));
  for (auto& fresh : fresh_articulations) Insert(std::move(fresh));
  for (const Joint& joint : snapshot.joints) Insert(joint);
  for (const auto& [a, b] : snapshot.passing) LetPass(a, b);
  close_fits_ = snapshot.close_fits;
  next_id_ = snapshot.next_id;
  next_joint_id_ = snapshot.next_joint_id;
}

}  // namespace smile::physics
