#include "recording/joint_motion.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostic.h"
#include "motion/trajectory_shape.h"
#include "recording/trace_reader.h"

namespace smile::recording {
namespace {

/// Largest overshoot of a joint that is pushed against its limit, as the limits are soft [rad or
/// m].
constexpr double kGive = 1e-3;

/// Returns the position, or the limit if it lies beyond it by no more than kGive. Larger violations
/// stay visible.
double AtItsLimit(const motion::JointLimits& limits, double q) {
  const double clamped = std::clamp(q, limits.lower, limits.upper);
  return std::abs(q - clamped) <= kGive ? clamped : q;
}

}  // namespace

motion::JointTrajectory JointMotionOf(const Recording& recording,
                                      const std::vector<motion::TrajectoryChannel>& channels,
                                      const TimeRange& range, double points_per_second) {
  if (!recording.robot()) {
    throw InputError({recording.directory.string(), 0, "", "was made without a robot"});
  }
  const TickRange ticks = TicksOf(range, recording);
  motion::JointTrajectory trajectory;
  for (const motion::TrajectoryChannel& channel : channels)
    trajectory.joint_names.push_back(channel.name);
  TraceReader trace(recording);
  std::uint64_t frame = 0;
  for (auto moment = trace.At(ticks.first); moment && moment->tick <= ticks.last;
       moment = trace.Next()) {
    const std::uint64_t since = moment->tick - ticks.first;
    // The last tick is always included, due or not, so that the motion ends where the robot did.
    const bool is_due = IsFrameDue(frame, since, points_per_second);
    if (!is_due && moment->tick != ticks.last) continue;
    if (is_due) ++frame;
    motion::TrajectoryPoint point{.seconds = sim::SecondsOf(since)};
    for (const motion::TrajectoryChannel& channel : channels) {
      const double q = PositionOf(channel, recording.robot()->model, moment->joints);
      // Otherwise a robot that touched its limit would be refused when it follows its own motion.
      point.positions.push_back(AtItsLimit(channel.limits, q));
    }
    trajectory.points.push_back(std::move(point));
  }
  motion::SetVelocitiesFromPositions(&trajectory);
  return trajectory;
}

}  // namespace smile::recording
