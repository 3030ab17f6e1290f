#pragma once

#include "math/angles.h"
#include "task/structure.h"

namespace smile::task {

/// Largest distance from its goal at which an object is in place: a quarter of a unit block.
inline constexpr double kTolerance = 0.025;  ///< [m]
/// Largest visible rotation from its goal at which an object is in place.
inline constexpr double kAngleTolerance = DegreesToRadians(15.0);  ///< [rad]
/// The same of the place of an object relative to a neighbor.
inline constexpr double kNeighborTolerance = 0.015;                       ///< [m]
inline constexpr double kNeighborAngleTolerance = DegreesToRadians(9.0);  ///< [rad]

/// Deviation of an object from its goal pose.
struct ObjectError {
  double distance = 0;    ///< [m]
  double angle = 0;       ///< visible rotation, see Symmetry [rad]
  bool is_held = false;   ///< by a hand or a gripper: it is not placed
  bool is_apart = false;  ///< too far from its place relative to a neighbor, see NeighborError

  bool is_pose_within() const { return distance <= kTolerance && angle <= kAngleTolerance; }
  bool is_within() const { return is_pose_within() && !is_held && !is_apart; }
  bool operator==(const ObjectError&) const = default;
};

/// Deviation of an object from its place relative to a neighbor. What stands on, in or beside one
/// another is compared more closely than places on the table: blocks that are each within tolerance
/// are not a tower if they point in all directions.
struct NeighborError {
  Neighbors pair;       ///< demo ids
  double distance = 0;  ///< [m]
  double angle = 0;     ///< about the vertical [rad]

  bool is_within() const {
    return distance <= kNeighborTolerance && angle <= kNeighborAngleTolerance;
  }
  bool operator==(const NeighborError&) const = default;
};

}  // namespace smile::task
