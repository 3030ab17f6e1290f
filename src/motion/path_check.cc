#include "motion/path_check.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/wording.h"
#include "motion/limit_check.h"

namespace smile::motion {
namespace {

/// Motion of a joint between two checks [rad or m]: thinner obstacles may be missed.
constexpr double kCheckSpacing = 0.02;
/// Bounds the work for a trajectory that oscillates.
constexpr int kMaxChecksPerSpan = 10'000;

/// Returns the joint indices of a trajectory's columns.
/// @throws std::invalid_argument if the robot lacks one.
std::vector<int> JointsOf(const robot::RobotModel& model, const JointTrajectory& trajectory) {
  std::vector<int> joints;
  for (const std::string& name : trajectory.joint_names) {
    const std::optional<int> joint = robot::FindJoint(model, name);
    if (!joint) throw std::invalid_argument("the robot has no joint " + Quoted(name));
    joints.push_back(*joint);
  }
  return joints;
}

/// Returns a sentence that names the overlapping links.
std::string Describe(const robot::RobotModel& model, const LinkOverlap& overlap) {
  const auto name = [&](int link) -> std::string {
    if (link == kEnvironment) return "an obstacle";
    return link < 0 ? "the base" : model.links[link].name;
  };
  return name(overlap.link) + " would touch " + name(overlap.other);
}

/// Returns the number of checks between two points. No joint moves farther than the length of its
/// cubic's control polygon.
int NumChecks(const TrajectoryPoint& from, const TrajectoryPoint& to) {
  // A cubic is a Bezier curve; its inner control points lie a third of the time along the end
  // velocities. The curve is never longer than the polygon of its control points.
  const double third = (to.seconds - from.seconds) / 3;
  double longest = 0;
  for (std::size_t i = 0; i < from.positions.size(); ++i) {
    const double out = third * from.velocities[i], in = third * to.velocities[i];
    const double between = to.positions[i] - from.positions[i] - out - in;
    longest = std::max(longest, std::abs(out) + std::abs(between) + std::abs(in));
  }
  return static_cast<int>(
      std::clamp(std::ceil(longest / kCheckSpacing), 1.0, double{kMaxChecksPerSpan}));
}

/// Returns the first moment up to `until` at which links touch.
std::optional<InvalidMoment> FirstTouch(const robot::RobotModel& model,
                                        const JointTrajectory& trajectory, std::vector<double> q,
                                        double until, ArticulationProbe* probe) {
  const std::vector<int> joints = JointsOf(model, trajectory);
  // Moves only the trajectory's joints in q; all others keep the positions of the caller.
  const auto check = [&](double seconds) -> std::optional<InvalidMoment> {
    const TrajectoryPoint now = SampleAt(trajectory, seconds);
    for (std::size_t i = 0; i < joints.size(); ++i) q[joints[i]] = now.positions[i];
    const auto overlap = probe->FirstOverlap(q);
    if (!overlap) return std::nullopt;
    return InvalidMoment{seconds, Describe(model, *overlap)};
  };
  const auto& points = trajectory.points;
  if (auto touch = check(points.front().seconds)) return touch;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const int num_checks = NumChecks(points[k - 1], points[k]);
    const double span = points[k].seconds - points[k - 1].seconds;
    for (int check_number = 1; check_number <= num_checks; ++check_number) {
      // The exact time of a point, not a sum of fractions: its rounding could exceed the last
      // point.
      const double seconds = check_number == num_checks
                                 ? points[k].seconds
                                 : points[k - 1].seconds + span * check_number / num_checks;
      if (seconds > until) return std::nullopt;
      if (auto touch = check(seconds)) return touch;
    }
  }
  return std::nullopt;
}

/// Returns the worst moment of the first span between two points that violates a limit.
/// CheckLimits() on the whole trajectory would report the worst moments overall instead.
std::optional<InvalidMoment> FirstBreach(const JointTrajectory& trajectory,
                                         std::span<const JointLimits> limits) {
  if (CheckLimits(trajectory, limits).empty()) return std::nullopt;
  const auto& points = trajectory.points;
  // The last round checks the last point alone, which matters for a trajectory of a single point.
  for (std::size_t k = 0; k < points.size(); ++k) {
    JointTrajectory span{trajectory.joint_names, {points[k]}};
    if (k + 1 < points.size()) span.points.push_back(points[k + 1]);
    const std::vector<LimitBreach> breaches = CheckLimits(span, limits);
    if (!breaches.empty()) return InvalidMoment{breaches[0].seconds, ToString(breaches[0])};
  }
  return std::nullopt;
}

}  // namespace

std::optional<InvalidMoment> FirstInvalid(const robot::RobotModel& model,
                                          const JointTrajectory& trajectory,
                                          std::span<const double> q_others,
                                          ArticulationProbe* probe) {
  if (q_others.size() != model.links.size()) {
    throw std::invalid_argument("q_others has " + std::to_string(q_others.size()) +
                                " values, expected " + std::to_string(model.links.size()));
  }
  const std::vector<int> joints = JointsOf(model, trajectory);
  const auto breach = FirstBreach(trajectory, LimitsOf(model, joints));
  if (trajectory.points.empty()) return breach;
  // Contacts after the first violation of a limit do not matter.
  auto touch = FirstTouch(model, trajectory, {q_others.begin(), q_others.end()},
                          breach ? breach->seconds : HUGE_VAL, probe);
  return touch ? touch : breach;
}

}  // namespace smile::motion
