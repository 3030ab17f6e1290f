#pragma once

#include <map>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "catalog/robot_guess.h"
#include "robot/robot_model.h"

namespace smile::catalog::internal {

/// Number of random configurations in which overlaps are counted.
inline constexpr int kSamples = 300;

/// Returns a random number from 0 to below 1, the same on each machine.
double Fraction(std::mt19937_64* random);

/// Returns a random configuration within limits; joints that turn on and on stay within a turn.
std::vector<double> RandomConfiguration(const robot::RobotModel& model, std::mt19937_64* random);

/// Pairs of links, the smaller number first; -1 is the base.
using LinkPairs = std::set<std::pair<int, int>>;

/// Returns the fraction of random configurations in which links overlap, for those that do.
/// @param without  pairs to leave out.
/// @throws std::runtime_error if `progress` cancels.
std::map<std::pair<int, int>, double> OverlapFractions(const robot::RobotModel& model,
                                                       const LinkPairs& without,
                                                       const Progress& progress);

/// Returns the distance from the shoulder of an arm to its tool along its joints [m].
double ReachOf(const robot::RobotModel& model, const robot::Arm& arm, std::span<const double> q);

/// Returns angles that bring the tool of an arm to a place, pointing down, in any turn about its
/// axis.
/// @param q  positions of all joints; the attempt begins at those of the arm.
std::optional<std::vector<double>> ReachDown(const robot::RobotModel& model, const robot::Arm& arm,
                                             const RigidTransform& X_WBase, const Vector3& p_WG,
                                             std::span<const double> q);

}  // namespace smile::catalog::internal
