#pragma once

#include <map>
#include <string>
#include <vector>

#include "math/angles.h"
#include "task/match.h"
#include "task/order.h"

namespace smile::task {

/// An object counts as rebuilt when it is this near to where it should be: a quarter of a unit
/// block.
inline constexpr double kTolerance = 0.025;  ///< [m]
/// And when it looks turned by no more than this.
inline constexpr double kAngleTolerance = DegreesToRadians(15.0);  ///< [rad]

/// How far an object is from where it should be.
struct ObjectError {
  double distance = 0;   ///< [m]
  double angle = 0;      ///< by which it looks turned, see Symmetry [rad]
  bool is_held = false;  ///< by a hand or a gripper: then it is placed nowhere

  bool is_within() const { return distance <= kTolerance && angle <= kAngleTolerance && !is_held; }
  bool operator==(const ObjectError&) const = default;
};

/// How close an outcome came to a demonstrated structure, wherever on the table it was built.
struct Comparison {
  Match match;       ///< of the structure's objects, and of what else its effects are about
  ObjectPoses goal;  ///< where the structure would stand in this scene, by demo id
  std::map<std::string, ObjectError> errors;  ///< by demo id
  Order order;
  std::vector<bool> achieved;  ///< of each effect
  double share = 0;            ///< of objects within tolerance and effects achieved, 0 to 1

  bool is_rebuilt() const { return share == 1; }
  ObjectError mean_error() const;  ///< over all objects; 0 without any
};

/// Compares up to a motion of the whole structure on the table, a shift along x and y and a turn
/// about z, and up to an exchange of objects that look alike. Motion and match are chosen together
/// so that as many objects as possible are within tolerance, then with least errors among these. A
/// structure with something fixed stands where that is in the scene.
Comparison CompareWith(const Structure& structure, const Episode& outcome);

}  // namespace smile::task
