#pragma once

#include "task/comparison.h"

namespace smile::task {

/// Where a structure was built, and of what.
struct Placing {
  RigidTransform motion;  ///< carries the structure from the demonstration to there
  Match match;            ///< of its objects
};

/// The best placing of all that one object or two objects suggest; see CompareWith().
/// @param match  some match, as MatchObjects() finds it; the other objects keep their parts in it.
Placing FindPlacing(const Structure& structure, const scene::SceneSpec& scene,
                    const ObjectPoses& outcome, const Match& match);

/// How far an object is from its place in a goal.
ObjectError ErrorOf(const scene::ObjectSpec& wanted, const RigidTransform& X_WGoal,
                    const scene::ObjectSpec& counterpart, const RigidTransform& X_WB);

}  // namespace smile::task
