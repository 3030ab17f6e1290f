#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <memory>
#include <vector>

#include "physics/articulation.h"
#include "physics/internal_joint_drive.h"
#include "physics/internal_shapes.h"

namespace smile::physics {

/// Bullet's part of an Articulation. Bullet moves each link at its center of mass along its
/// principal axes (frame Lcm). If the articulation is kinematic, Bullet's world contains only the
/// colliders, which are kinematic objects.
struct Articulation::Links {
  struct Link {
    RigidTransform X_LLcm;
    CollisionShape collision;
    std::unique_ptr<btCollisionObject> collider;
    std::unique_ptr<JointDrive> drive;  ///< null if kinematic
  };
  CollisionShape base_collision;
  std::unique_ptr<btCollisionObject> base_collider;
  std::vector<Link> links;

  /// Returns the collider of a link or of the base (-1); null for a base without solids.
  btCollisionObject* collider(int link) const {
    return link < 0 ? base_collider.get() : links[link].collider.get();
  }
};

}  // namespace smile::physics
