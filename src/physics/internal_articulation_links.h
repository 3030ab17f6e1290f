#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <memory>
#include <vector>

#include "physics/articulation.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

/// Bullet's side of an Articulation. Bullet moves each link at its centre of mass along its
/// principal axes (frame Lcm).
struct Articulation::Links {
  struct Link {
    RigidTransform X_LLcm;
    CollisionShape collision;
    std::unique_ptr<btMultiBodyLinkCollider> collider;
    std::unique_ptr<btMultiBodyJointMotor> motor;
    std::unique_ptr<btMultiBodyJointLimitConstraint> limits;
  };
  CollisionShape base_collision;
  std::unique_ptr<btMultiBodyLinkCollider> base_collider;
  std::vector<Link> links;

  /// -1 is the base, null without solids.
  btMultiBodyLinkCollider* collider(int link) const {
    return link < 0 ? base_collider.get() : links[link].collider.get();
  }
};

}  // namespace smile::physics
