#pragma once

#include <map>
#include <string>
#include <vector>

#include "math/angles.h"
#include "task/match.h"
#include "task/order.h"

namespace smile::task {

/// Largest distance from its goal at which an object is in place: a quarter of a unit block.
inline constexpr double kTolerance = 0.025;  ///< [m]
/// Largest visible rotation from its goal at which an object is in place.
inline constexpr double kAngleTolerance = DegreesToRadians(15.0);  ///< [rad]

/// Deviation of an object from its goal pose.
struct ObjectError {
  double distance = 0;   ///< [m]
  double angle = 0;      ///< visible rotation, see Symmetry [rad]
  bool is_held = false;  ///< by a hand or a gripper: it is not placed

  bool is_within() const { return distance <= kTolerance && angle <= kAngleTolerance && !is_held; }
  bool operator==(const ObjectError&) const = default;
};

/// Comparison of an outcome with a demonstrated structure, wherever on the table it was built.
struct StructureComparison {
  Match match;       ///< of the structure's objects, and of others that its effects refer to
  ObjectPoses goal;  ///< poses of the structure in this scene, by demo id
  std::map<std::string, ObjectError> errors;  ///< by demo id
  Order order;
  std::vector<bool> achieved;  ///< for each effect
  double score = 0;            ///< fraction of objects within tolerance and effects achieved

  bool is_achieved() const { return score == 1; }
  ObjectError mean_error() const;  ///< over all objects; 0 without any
};

/// Compares up to a motion of the whole structure on the table, a shift along x and y and a turn
/// about z, and up to an exchange of objects that look alike. Motion and match are chosen together
/// so that as many objects as possible are within tolerance, then with least errors among these.
/// What stands on a fixed object stands where this is in the scene; of several fixed objects, each
/// determines the place of what it carries.
StructureComparison CompareWith(const Structure& structure, const Episode& outcome);

}  // namespace smile::task
