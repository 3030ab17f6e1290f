#include "motion/internal_timing.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/wording.h"
#include "motion/internal_cubic.h"

namespace smile::motion {
namespace {

/// Returns the maximum absolute derivative of a cubic.
double MaxAbsDerivative(const Cubic& cubic) {
  double top = std::max(std::abs(cubic.from_derivative), std::abs(cubic.to_derivative));
  const double from_second_derivative = cubic.SecondDerivativeAt(0),
               to_second_derivative = cubic.SecondDerivativeAt(1);
  // The derivative is a parabola: its vertex is where the second derivative changes sign.
  if (from_second_derivative * to_second_derivative < 0) {
    top = std::max(top,
                   std::abs(cubic.DerivativeAt(from_second_derivative /
                                               (from_second_derivative - to_second_derivative))));
  }
  return top;
}

}  // namespace

double SlownessNeeded(const TrajectoryPoint& from, const TrajectoryPoint& to,
                      std::span<const JointLimits> limits, double speed) {
  double needed = 0;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    // The second derivative of a cubic is linear, so its extremes are at the ends.
    const Cubic cubic{from.positions[i], to.positions[i], from.velocities[i], to.velocities[i],
                      to.seconds - from.seconds};
    const double max_second_derivative =
        std::max(std::abs(cubic.SecondDerivativeAt(0)), std::abs(cubic.SecondDerivativeAt(1)));
    needed = std::max({needed, MaxAbsDerivative(cubic) / (speed * limits[i].max_velocity),
                       std::sqrt(max_second_derivative / limits[i].max_acceleration)});
  }
  return needed;
}

void SlowDownToLimits(std::span<const JointLimits> limits, double speed,
                      std::vector<TrajectoryPoint>* points) {
  // One factor for the whole motion keeps its path and its rest at both ends. Scaling single spans
  // would make velocities jump between them.
  double factor = 1;
  for (std::size_t k = 1; k < points->size(); ++k) {
    factor = std::max(factor, SlownessNeeded((*points)[k - 1], (*points)[k], limits, speed));
  }
  if (factor == 1) return;
  for (TrajectoryPoint& point : *points) {
    point.seconds *= factor;
    for (double& velocity : point.velocities) velocity /= factor;
  }
}

double MonotoneTangent(double before, double after, double seconds_before, double seconds_after) {
  // A local extreme of the data: the curve must rest here to stay monotone on both sides.
  if (before * after <= 0) return 0;
  // Weighted harmonic mean of the slopes: never more than three times the smaller one, which keeps
  // cubics monotone.
  const double weight_before = 2 * seconds_after + seconds_before;
  const double weight_after = seconds_after + 2 * seconds_before;
  return (weight_before + weight_after) / (weight_before / before + weight_after / after);
}

void CheckSpeed(double speed) {
  if (speed > 0 && speed <= 1) return;
  throw std::invalid_argument("speed is " + NumberText(speed) + ", expected above 0, at most 1");
}

void CheckConfiguration(std::span<const double> q, std::span<const JointLimits> limits,
                        const std::string& what) {
  if (q.size() != limits.size()) {
    throw std::invalid_argument(what + " has " + std::to_string(q.size()) + " values, expected " +
                                std::to_string(limits.size()));
  }
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (q[i] >= limits[i].lower && q[i] <= limits[i].upper) continue;
    throw std::invalid_argument(what + ": joint " + std::to_string(i) + " would be at " +
                                NumberText(q[i]) + ", expected " + NumberText(limits[i].lower) +
                                " to " + NumberText(limits[i].upper));
  }
}

}  // namespace smile::motion
