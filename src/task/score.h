#pragma once

#include <map>
#include <string>

#include "task/goal.h"

namespace smile::task {

/// An object counts as rebuilt when it is this near to where it should be: a quarter of a unit
/// block.
inline constexpr double kTolerance = 0.025;  ///< [m]

/// How close an outcome came to a goal, wherever on the table it was built.
struct Score {
  ObjectPoses goal;  ///< where the demonstration's structure would stand in this scene, by demo id
  std::map<std::string, double> errors;  ///< distance from there, by demo id [m]
  double share = 0;                      ///< of goal objects within tolerance, 0 to 1
  double mean_error = 0;                 ///< over all goal objects [m]

  bool is_rebuilt() const { return share == 1.0; }
};

/// Compares up to a motion of the whole structure on the table: a shift along x and y and a turn
/// about z, chosen so that as many objects as possible are within tolerance, then with least
/// squares among these. Only positions count: turning a block in its place is no error.
///
/// @param outcome  poses in the end, of all objects that `match` names.
Score ScoreOutcome(const Goal& goal, const std::map<std::string, std::string>& match,
                   const ObjectPoses& outcome, double tolerance = kTolerance);

}  // namespace smile::task
