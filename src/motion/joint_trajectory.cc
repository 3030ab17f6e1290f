#include "motion/joint_trajectory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/wording.h"
#include "motion/internal_cubic.h"

namespace smile::motion {
namespace {

/// Returns the point with zero velocities.
TrajectoryPoint AtRest(TrajectoryPoint point) {
  std::fill(point.velocities.begin(), point.velocities.end(), 0.0);
  return point;
}

void CheckMove(std::span<const double> from, std::span<const double> to,
               std::span<const JointLimits> limits, double speed) {
  if (from.size() != limits.size() || to.size() != limits.size()) {
    throw std::invalid_argument("a move from " + std::to_string(from.size()) + " values to " +
                                std::to_string(to.size()) + ", expected " +
                                std::to_string(limits.size()) + " each");
  }
  for (std::size_t i = 0; i < limits.size(); ++i) {
    for (const double q : {from[i], to[i]}) {
      if (q >= limits[i].lower && q <= limits[i].upper) continue;
      throw std::invalid_argument("joint " + std::to_string(i) + " would be at " + NumberText(q) +
                                  ", expected " + NumberText(limits[i].lower) + " to " +
                                  NumberText(limits[i].upper));
    }
  }
  if (!(speed > 0 && speed <= 1)) {
    throw std::invalid_argument("speed is " + NumberText(speed) + ", expected above 0, at most 1");
  }
}

}  // namespace

TrajectoryPoint SampleAt(const JointTrajectory& trajectory, double seconds) {
  const auto& points = trajectory.points;
  if (points.empty()) throw std::invalid_argument("the trajectory has no points");
  const auto after =
      std::upper_bound(points.begin(), points.end(), seconds,
                       [](double t, const TrajectoryPoint& point) { return t < point.seconds; });
  // Outside the trajectory the joints rest at its ends.
  if (after == points.begin()) return AtRest(points.front());
  if (after == points.end()) return AtRest(points.back());

  const TrajectoryPoint &from = *(after - 1), &to = *after;
  // Positive, as upper_bound() has found a later point after an earlier one.
  const double span = to.seconds - from.seconds;
  const double u = (seconds - from.seconds) / span;
  TrajectoryPoint sample{.seconds = seconds};
  for (std::size_t i = 0; i < from.positions.size(); ++i) {
    const Cubic cubic{from.positions[i], to.positions[i], from.velocities[i], to.velocities[i],
                      span};
    sample.positions.push_back(cubic.At(u));
    sample.velocities.push_back(cubic.DerivativeAt(u));
  }
  return sample;
}

std::vector<JointLimits> LimitsOf(const robot::RobotModel& model, std::span<const int> joints) {
  std::vector<JointLimits> limits;
  for (const int joint : joints) {
    if (joint < 0 || joint >= model.num_joints()) {
      throw std::invalid_argument("there is no joint " + std::to_string(joint));
    }
    const scene::LinkSpec& link = model.links[joint];
    // Accelerations are not part of a URDF; see kSecondsToFullSpeed.
    limits.push_back({.lower = link.lower,
                      .upper = link.upper,
                      .max_velocity = link.max_velocity,
                      .max_acceleration = link.max_velocity / kSecondsToFullSpeed,
                      .slides = link.joint_type == scene::JointType::kPrismatic});
  }
  return limits;
}

std::vector<TrajectoryPoint> MoveStraight(std::span<const double> from, std::span<const double> to,
                                          std::span<const JointLimits> limits, double speed) {
  CheckMove(from, to, limits, speed);
  // The path parameter s goes from 0 to 1; the joint with the longest distance for its limits
  // decides the rates [1/s, 1/s2].
  double rate = std::numeric_limits<double>::infinity(), growth = rate;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const double distance = std::abs(to[i] - from[i]);
    if (distance == 0) continue;
    rate = std::min(rate, speed * limits[i].max_velocity / distance);
    growth = std::min(growth, limits[i].max_acceleration / distance);
  }
  const auto point = [&](double seconds, double s, double s_rate) {
    TrajectoryPoint made{.seconds = seconds};
    for (std::size_t i = 0; i < limits.size(); ++i) {
      // The end is exact, without rounding.
      made.positions.push_back(s == 1 ? to[i] : from[i] + s * (to[i] - from[i]));
      made.velocities.push_back(s_rate * (to[i] - from[i]));
    }
    return made;
  };
  if (!std::isfinite(rate)) return {point(0, 0, 0)};

  // Trapezoidal velocity profile: accelerate, constant speed, decelerate. A short distance is a
  // triangle without the middle part.
  const bool has_even_part = rate < std::sqrt(growth);
  const double top = has_even_part ? rate : std::sqrt(growth);
  // A ramp takes top / growth seconds and covers half of top * ramp of the distance.
  const double ramp = top / growth;
  const double even = has_even_part ? std::max(0.0, 1 / top - ramp) : 0.0;
  std::vector<TrajectoryPoint> points{point(0, 0, 0), point(ramp, top * ramp / 2, top)};
  if (has_even_part) points.push_back(point(ramp + even, 1 - top * ramp / 2, top));
  points.push_back(point(2 * ramp + even, 1, 0));
  return points;
}

}  // namespace smile::motion
