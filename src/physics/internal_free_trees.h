#pragma once

#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>

#include <span>
#include <vector>

#include "mechanics/tree_motion.h"
#include "physics/internal_bullet.h"
#include "physics/internal_joint_drive.h"

namespace smile::physics {

/// Trees of articulations that nothing touches and no weld holds. In a step, their joints get the
/// velocities that are wanted of them, if the motors can do that; Bullet would have rows for each
/// motor and limit, in all of its iterations.
class FreeTrees {
 public:
  /// Gives free trees their velocities, and removes them and their drives from what Bullet is to
  /// solve in this step.
  void Solve(std::span<btPersistentManifold* const> manifolds, double seconds,
             btAlignedObjectArray<btMultiBody*>* trees,
             btAlignedObjectArray<btMultiBodyConstraint*>* constraints);

 private:
  struct Tree {
    btMultiBody* multibody = nullptr;
    bool is_free = true;
    std::vector<const JointDrive*> drives;
    mechanics::TreeMotion motion;
  };
  bool IsFree(const btMultiBody* multibody) const;
  void Touch(const btMultiBody* multibody);
  static bool Move(double seconds, Tree* tree);

  std::vector<Tree> trees_;  ///< scratch space of Solve()
};

}  // namespace smile::physics
