// World::Save() and World::Restore(); the recipe stands in docs/decisions/physics.md.

#include <algorithm>
#include <stdexcept>

#include "base/bytes.h"
#include "physics/internal_articulation_links.h"
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

}  // namespace

Snapshot World::Save() const {
  Snapshot snapshot{
      .next_id = next_id_, .next_joint_id = next_joint_id_, .joints = joints_, .passing = passing_};
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
/// else. Joints are made anew: they read their own state later.
void World::MatchObjects(const Snapshot& snapshot) {
  while (!joints_.empty()) RemoveJoint(joints_.back().id);
  EndAllPassing();

  const auto is_saved = [&snapshot](const Body& body) {
    return std::any_of(snapshot.bodies.begin(), snapshot.bodies.end(), [&](const auto& entry) {
      return entry.id == body.id() && (entry.spec == body.spec_ || *entry.spec == *body.spec_);
    });
  };
  for (std::size_t i = bodies_.size(); i-- > 0;) {
    if (!is_saved(*bodies_[i])) Erase(*bodies_[i]);
  }
  for (const auto& entry : snapshot.bodies) {
    if (!Has(entry.id)) Insert(std::unique_ptr<Body>(new Body(entry.id, entry.spec)));
  }

  for (const auto& articulation : articulations_) {
    const bool is_same = std::any_of(
        snapshot.articulations.begin(), snapshot.articulations.end(), [&](const auto& entry) {
          return entry.id == articulation->id() &&
                 (entry.spec == articulation->spec_ || *entry.spec == *articulation->spec_);
        });
    if (!is_same) throw std::invalid_argument("snapshot: it is of a world without this robot");
  }
  for (std::size_t i = articulations_.size(); i < snapshot.articulations.size(); ++i) {
    const auto& entry = snapshot.articulations[i];
    Insert(std::unique_ptr<Articulation>(new Articulation(entry.id, entry.spec, config_.motor)));
  }

  MatchJoints(snapshot);
  next_id_ = snapshot.next_id;
  next_joint_id_ = snapshot.next_joint_id;
}

void World::MatchJoints(const Snapshot& snapshot) {
  const auto check = [this](BodyId id) {
    if (!Has(id)) throw std::invalid_argument("snapshot: a joint is of an unknown body");
  };
  for (const Joint& joint : snapshot.joints) {
    if (!joints_.empty() && !(joints_.back().id < joint.id)) {
      throw std::invalid_argument("snapshot: its joints are out of order");
    }
    if (const auto pair = BodyPairOf(joint.spec)) {
      check(pair->first);
      check(pair->second);
    } else {
      const auto& weld = std::get<WeldSpec>(joint.spec);
      check(weld.body);
      const bool has_holder =
          std::any_of(articulations_.begin(), articulations_.end(),
                      [&weld](const auto& one) { return one->id() == weld.articulation; });
      if (!has_holder) throw std::invalid_argument("snapshot: a weld is to an unknown robot");
    }
    CheckJoint(joint.spec);
    Insert(joint);
  }
  for (const auto& [a, b] : snapshot.passing) {
    check(a);
    check(b);
    LetPass(a, b);
  }
}

}  // namespace smile::physics
