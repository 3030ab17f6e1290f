#pragma once

#include <memory>
#include <span>
#include <vector>

#include "physics/internal_bullet.h"
#include "scene/solid.h"

namespace smile::physics {

/// Where a part P of a shape is.
struct PosedPart {
  btTransform X_WP;
  btVector3 min, max;  ///< corners of its bounding box in the world
};

/// Bullet's shape of several parts, which remembers where they are: all pairs of an object ask for
/// the same in a step.
class PosedCompound : public btCompoundShape {
 public:
  // Without Bullet's tree of parts: CompoundPairAlgorithm visits all pairs itself.
  PosedCompound() : btCompoundShape(/*enableDynamicAabbTree=*/false) {}

  /// Returns the parts while the shape is at a pose, valid until it is asked for another pose.
  std::span<const PosedPart> PartsAt(const btTransform& X_WA) const;

 private:
  mutable btTransform X_WA_;
  mutable std::vector<PosedPart> parts_;  ///< at X_WA_; empty before the first call
};

/// Bullet's collision shape for a set of solids, and the parts it is made of.
struct CollisionShape {
  std::vector<std::unique_ptr<btCollisionShape>> parts;
  std::unique_ptr<PosedCompound> compound;  ///< null when one centered part is enough; may be empty

  btCollisionShape* shape() const { return compound ? compound.get() : parts.front().get(); }
};

/// Makes Bullet's shape of some solids.
/// @param X_AB  the solids' frame B in the frame A that Bullet moves (its principal axes).
CollisionShape MakeCollisionShape(const std::vector<scene::Solid>& solids,
                                  const RigidTransform& X_AB);

}  // namespace smile::physics
