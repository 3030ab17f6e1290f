#pragma once

#include <memory>
#include <vector>

#include "physics/internal_bullet.h"
#include "scene/solid.h"

namespace smile::physics {

/// Bullet's collision shape for a set of solids, and the parts it is made of.
struct CollisionShape {
  std::vector<std::unique_ptr<btCollisionShape>> parts;
  std::unique_ptr<btCompoundShape>
      compound;  ///< null when one centered part is enough; may be empty

  btCollisionShape* shape() const { return compound ? compound.get() : parts.front().get(); }
};

/// Makes Bullet's shape of some solids.
/// @param X_AB  the solids' frame B in the frame A that Bullet moves (its principal axes).
CollisionShape MakeCollisionShape(const std::vector<scene::Solid>& solids,
                                  const RigidTransform& X_AB);

}  // namespace smile::physics
