#pragma once

#include "task/match.h"
#include "task/object_error.h"

namespace smile::task {

/// Motion and match with which an outcome is compared to a structure.
struct Placing {
  RigidTransform motion;  ///< from the demonstrated structure to where it was built
  double turn = 0;        ///< of the motion about the vertical, within [-pi, pi] [rad]
  Match match;            ///< of its objects
};

/// Returns the best placing of those that single objects or pairs of objects suggest; see
/// CompareWith().
/// @param match  from MatchObjects(); objects outside the structure (Structure::others) keep their
///               counterparts.
Placing FindPlacing(const Structure& structure, const Episode& outcome, const Match& match);

/// Returns the deviation of an object from its goal pose. The angle is 0 if the two have different
/// forms.
ObjectError ErrorOf(const scene::ObjectSpec& wanted, const RigidTransform& X_WGoal,
                    const scene::ObjectSpec& counterpart, const RigidTransform& X_WB);

}  // namespace smile::task
