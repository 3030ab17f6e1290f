#include "physics/internal_held_bodies.h"

#include <algorithm>
#include <utility>

#include "physics/internal_articulation_links.h"
#include "physics/internal_body_dynamics.h"

// Bodies that a gripper holds by a weld. To a robot with motors it is a constraint with a large but
// bounded effort; to a kinematic robot the body becomes kinematic itself and is placed with the
// link. Held bodies weigh nothing up to the payload of the arm.

namespace smile::physics {
namespace {

/// Force and torque that a weld may use against obstacles [N, N m].
constexpr double kWeldEffort = 2000.0;

}  // namespace

HeldBodies::HeldBodies(const WorldConfig& config, const WorldObjects& objects, Engine& engine)
    : config_(config), objects_(objects), engine_(engine) {}

void HeldBodies::Hold(JointId id, const WeldSpec& spec) {
  Body& held = objects_.body(spec.body);
  held.SetCarried(true);
  // The fingers touch the body: contacts would fight the weld.
  ForEachLinkNotColliding(spec, [&](const btCollisionObject& link) {
    engine_.broadphase.Exclude(link, held.dynamics().bullet(), &engine_.dispatcher);
  });
  Weld& weld = welds_[id];
  weld.spec = spec;
  if (IsKinematic(spec)) {
    SetKinematic(spec.body, true);
  } else {
    weld.constraint = MakeConstraint(spec);
    engine_.world.addMultiBodyConstraint(weld.constraint.get());
  }
}

void HeldBodies::Release(JointId id) {
  const auto found = welds_.find(id);
  // Keep the weld alive until its constraint has left Bullet's world.
  const Weld weld = std::move(found->second);
  welds_.erase(found);
  const BodyId body = weld.spec.body;
  ForEachLinkNotColliding(weld.spec, [&](const btCollisionObject& link) {
    engine_.broadphase.filter().Include(OrderOf(&link), static_cast<int>(body.value));
  });
  if (weld.constraint) engine_.world.RemoveConstraintInOrder(weld.constraint.get());

  // Another weld may still hold it.
  bool is_held = false, is_kinematic = false;
  for (const auto& [other_id, other] : welds_) {
    if (other.spec.body != body) continue;
    is_held = true;
    is_kinematic = is_kinematic || IsKinematic(other.spec);
  }
  objects_.body(body).SetCarried(is_held);
  SetKinematic(body, is_kinematic);
}

void HeldBodies::Rejoin(BodyId id) {
  for (auto& [joint, weld] : welds_) {
    if (weld.spec.body != id) continue;
    if (IsKinematic(weld.spec)) {
      SetKinematic(id, true);
    } else {
      // The constraint refers to Bullet's object of the body, which has changed.
      auto fresh = MakeConstraint(weld.spec);
      engine_.world.ReplaceConstraint(weld.constraint.get(), fresh.get());
      weld.constraint = std::move(fresh);
    }
  }
}

bool HeldBodies::IsKinematic(const WeldSpec& weld) const {
  return objects_.articulation(weld.articulation).spec().is_kinematic;
}

/// Changes whether a body is kinematic. Two objects that nothing can push make no pair, so its
/// pairs are dropped and found again.
void HeldBodies::SetKinematic(BodyId id, bool is_kinematic) {
  Body::Dynamics& held = objects_.body(id).dynamics();
  if (held.is_kinematic() == is_kinematic) return;
  held.SetKinematic(is_kinematic);
  engine_.broadphase.DropPairsOf(held.bullet(), &engine_.dispatcher);
}

std::unique_ptr<btMultiBodyFixedConstraint> HeldBodies::MakeConstraint(const WeldSpec& weld) const {
  const Articulation& holder = objects_.articulation(weld.articulation);
  Body::Dynamics& held = objects_.body(weld.body).dynamics();
  // Bullet's constraint is between the frames of the centers of mass.
  const Articulation::Links::Link& link = holder.links().links[weld.link];
  const RigidTransform X_LcmBcm = link.X_LLcm.inverse() * weld.X_LB * held.X_BcmB().inverse();
  auto constraint = std::make_unique<btMultiBodyFixedConstraint>(
      link.tree, link.index, &held.bullet(), ToBullet(X_LcmBcm.translation()), btVector3(0, 0, 0),
      ToBullet(X_LcmBcm.rotation()), btMatrix3x3::getIdentity());
  constraint->setMaxAppliedImpulse(kWeldEffort * config_.step_seconds);
  return constraint;
}

template <class Visit>
void HeldBodies::ForEachLinkNotColliding(const WeldSpec& weld, Visit visit) const {
  const Articulation& holder = objects_.articulation(weld.articulation);
  for (int link : weld.links_not_colliding) {
    if (const auto* collider = holder.links().collider(link)) visit(*collider);
  }
}

void HeldBodies::ApplyExcessWeight() {
  for (const auto& [id, weld] : welds_) {
    Body& held = objects_.body(weld.spec.body);
    // A carried body is weightless; gravity acts on the excess only, spread over the loaded mass.
    const double excess = std::max(0.0, held.spec().mass.mass - weld.spec.holds_up);
    Body::Dynamics& dynamics = held.dynamics();
    dynamics.bullet().setGravity(
        btVector3(0, 0, -config_.gravity * excess / dynamics.loaded_mass()));
    // The motors of the arm must bear the excess with their listed effort only.
    if (excess > 0) objects_.articulation(weld.spec.articulation).NoteOverload(weld.spec.link);
  }
}

void HeldBodies::SetKinematicVelocities() {
  for (const auto& [id, weld] : welds_) {
    if (!IsKinematic(weld.spec)) continue;
    const auto X_WL = objects_.articulation(weld.spec.articulation).next_link_poses();
    objects_.body(weld.spec.body)
        .dynamics()
        .SetVelocityToReach(X_WL[weld.spec.link] * weld.spec.X_LB, config_.step_seconds);
  }
}

void HeldBodies::MoveKinematicBodies() {
  for (const auto& [id, weld] : welds_) {
    if (!IsKinematic(weld.spec)) continue;
    const auto X_WL = objects_.articulation(weld.spec.articulation).link_poses();
    objects_.body(weld.spec.body).dynamics().SetPose(X_WL[weld.spec.link] * weld.spec.X_LB);
  }
}

}  // namespace smile::physics
