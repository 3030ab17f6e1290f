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
///
/// The links that one joint connects with the base are a tree, such as an arm, and a multibody of
/// their own: the base does not move, so that trees have no effect on each other, and Bullet's work
/// grows with the square of the joints of a multibody.
struct Articulation::Links {
  struct Link {
    btMultiBody* tree = nullptr;
    int index = 0;  ///< of the link in its tree
    RigidTransform X_LLcm;
    CollisionShape collision;
    std::unique_ptr<btCollisionObject> collider;
    std::unique_ptr<JointDrive> drive;  ///< null if kinematic

    double position() const { return tree->getJointPos(index); }
    double velocity() const { return tree->getJointVel(index); }
    void SetPosition(double q) { tree->setJointPos(index, q); }
    void SetVelocity(double v) { tree->setJointVel(index, v); }
  };
  std::vector<std::unique_ptr<btMultiBody>> trees;  ///< in the order of their first links
  CollisionShape base_collision;
  std::unique_ptr<btCollisionObject> base_collider;
  std::vector<Link> links;

  /// Returns the collider of a link or of the base (-1); null for a base without solids.
  btCollisionObject* collider(int link) const {
    return link < 0 ? base_collider.get() : links[link].collider.get();
  }
};

}  // namespace smile::physics
