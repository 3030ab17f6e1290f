#include "sim/trajectory_follower.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "base/wording.h"
#include "motion/limit_check.h"
#include "motion/trajectory_shape.h"
#include "sim/tick.h"

// A trajectory becomes joint velocities, tick by tick: the mean velocity of the trajectory over the
// tick plus a correction of the position error.

namespace smile::sim {

using texts::Say;
namespace {

/// Gain: fraction of a joint's error that is corrected per second [1/s]. Measured in November 2026
/// with all joints oscillating by 0.3 rad each second: with 5 they lag by 1.6 mrad, with 20 by 0.6.
constexpr double kGain = 20;
/// A trajectory starts at once if all joints are this close to its start [rad or m].
constexpr double kNear = 0.02, kNearOpening = 0.002;
/// Fraction of full speed on the approach to the start.
constexpr double kSpeedToStart = 0.5;
/// Tolerances of limits for measured trajectories: an arm recorded at full speed is sometimes
/// slightly faster.
constexpr double kPositionSlack = 1e-3, kVelocitySlack = 0.01;
/// A holding gripper releases if it is commanded to open by this much more than its opening [m].
constexpr double kReleaseMargin = 0.005;

double ClampedTo(const motion::JointLimits& limits, double q) {
  return std::clamp(q, limits.lower, limits.upper);
}

/// Returns a hash of a trajectory, computed once when it starts.
std::uint64_t HashOf(const motion::JointTrajectory& trajectory) {
  StateHash hash;
  // Lists are hashed with their lengths, so that their boundaries count.
  const auto add_numbers = [&hash](std::span<const double> numbers) {
    hash.Add(std::uint64_t{numbers.size()});
    hash.Add(numbers);
  };
  hash.Add(std::uint64_t{trajectory.joint_names.size()});
  for (const std::string& name : trajectory.joint_names) hash.Add(std::string_view(name));
  hash.Add(std::uint64_t{trajectory.points.size()});
  for (const motion::TrajectoryPoint& point : trajectory.points) {
    hash.Add(point.seconds);
    add_numbers(point.positions);
    add_numbers(point.velocities);
  }
  return hash.value();
}

/// Returns the violated limit without the tolerances, for messages.
double TrueLimit(const motion::LimitBreach& breach, const motion::JointLimits& limits) {
  const bool is_above = breach.value > breach.limit;
  if (breach.quantity == motion::LimitedQuantity::kPosition) {
    return is_above ? limits.upper : limits.lower;
  }
  return is_above ? limits.max_velocity : -limits.max_velocity;
}

}  // namespace

TrajectoryFollower::TrajectoryFollower(world::RobotBody* robot)
    : robot_(*robot), channels_(motion::ChannelsOf(robot->model())) {}

std::optional<Refusal> TrajectoryFollower::FindColumns(
    const motion::JointTrajectory& trajectory, std::vector<Following::Column>* columns) const {
  std::vector<std::string_view> names;
  for (const motion::TrajectoryChannel& channel : channels_) names.push_back(channel.name);
  for (std::size_t i = 0; i < trajectory.joint_names.size(); ++i) {
    const std::string& name = trajectory.joint_names[i];
    const motion::TrajectoryChannel* channel = FindChannel(channels_, name);
    if (channel == nullptr) {
      return "the robot has no joint " + Quoted(name) + DidYouMean(name, names);
    }
    columns->push_back(
        {.column = i, .channel = static_cast<std::size_t>(channel - channels_.data())});
  }
  return std::nullopt;
}

std::optional<Refusal> TrajectoryFollower::RefuseBeyondLimits(
    const motion::JointTrajectory& trajectory, std::span<const Following::Column> columns) const {
  std::vector<motion::JointLimits> limits;
  for (const Following::Column& column : columns) {
    const motion::JointLimits& true_limits = channels_[column.channel].limits;
    limits.push_back({.lower = true_limits.lower - kPositionSlack,
                      .upper = true_limits.upper + kPositionSlack,
                      .max_velocity = true_limits.max_velocity * (1 + kVelocitySlack),
                      // Accelerations are not refused: those of measured trajectories are noisy.
                      .max_acceleration = HUGE_VAL,
                      .slides = true_limits.slides});
  }
  const std::vector<motion::LimitBreach> breaches = CheckLimits(trajectory, limits);
  if (breaches.empty()) return std::nullopt;
  // Report the true limit: the tolerance is an implementation detail.
  motion::LimitBreach first = breaches.front();
  first.limit = TrueLimit(first, FindChannel(channels_, first.joint_name)->limits);
  return "at " + NumberText(first.seconds) + " s, " + ToString(first);
}

motion::JointTrajectory TrajectoryFollower::WithApproachToStart(
    motion::JointTrajectory trajectory, std::span<const Following::Column> columns) const {
  const std::vector<double> q = robot_.positions();
  const motion::TrajectoryPoint& first = trajectory.points.front();
  std::vector<double> from, to;
  std::vector<motion::JointLimits> limits;
  bool is_near = true;
  for (const Following::Column& column : columns) {
    const motion::TrajectoryChannel& channel = channels_[column.channel];
    // Clamped, since servo errors and measured trajectories exceed limits slightly, which
    // MoveStraight() would refuse.
    from.push_back(ClampedTo(channel.limits, PositionOf(channel, robot_.model(), q)));
    to.push_back(ClampedTo(channel.limits, first.positions[column.column]));
    limits.push_back(channel.limits);
    const double near = channel.is_gripper() ? kNearOpening : kNear;
    is_near = is_near && std::abs(to.back() - from.back()) <= near;
  }
  if (is_near) return trajectory;

  // A first point later than 0 leaves time for the motion to the start.
  std::vector<motion::TrajectoryPoint> points =
      motion::MoveStraight(from, to, limits, kSpeedToStart);
  const double delay = std::max(0.0, points.back().seconds - first.seconds);
  for (motion::TrajectoryPoint& point : trajectory.points) point.seconds += delay;
  // A robot that arrives early rests until just before the start: a single cubic from rest to the
  // velocity of the first point would swing far back to gain it.
  motion::TrajectoryPoint rest = points.back();
  // Times must increase strictly; this is the largest time before the first point.
  rest.seconds = std::nextafter(first.seconds, 0.0);
  if (points.back().seconds >= rest.seconds) points.pop_back();
  points.push_back(std::move(rest));
  trajectory.points.insert(trajectory.points.begin(), points.begin(), points.end());
  return trajectory;
}

void TrajectoryFollower::Start(motion::JointTrajectory trajectory,
                               std::vector<Following::Column> columns, std::uint64_t tick) {
  // The newest trajectory takes over its joints.
  for (const Following::Column& column : columns) Leave(channels_[column.channel].joint);
  // Computed once: the state hash of each tick contains it instead of all points.
  const std::uint64_t hash = HashOf(trajectory);
  state_.followings.push_back(
      {.trajectory = std::make_shared<const motion::JointTrajectory>(std::move(trajectory)),
       .hash = hash,
       .start_tick = tick,
       .columns = std::move(columns)});
}

std::optional<Refusal> TrajectoryFollower::Follow(const motion::JointTrajectory& trajectory,
                                                  std::uint64_t tick) {
  try {
    CheckShape(trajectory);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  std::vector<Following::Column> columns;
  if (auto refusal = FindColumns(trajectory, &columns)) return refusal;
  if (auto refusal = RefuseBeyondLimits(trajectory, columns)) return refusal;
  motion::JointTrajectory whole = WithApproachToStart(trajectory, columns);
  Start(std::move(whole), std::move(columns), tick);
  return std::nullopt;
}

std::optional<Refusal> TrajectoryFollower::MoveTo(const std::string& pose, double speed,
                                                  std::uint64_t tick) {
  const robot::RobotModel& model = robot_.model();
  if (!(speed > 0 && speed <= 1)) {
    return "the speed is " + NumberText(speed) + ", expected above 0, at most 1";
  }
  const robot::NamedPose* found = FindPose(model, pose);
  if (found == nullptr) {
    std::vector<std::string_view> names;
    for (const robot::NamedPose& named : model.poses) names.push_back(named.name);
    if (names.empty()) return Say("robot.noPoses");
    return Say("robot.noPose", {{"pose", Quoted(pose)}, {"known", OneOf(names)}});
  }
  const std::vector<double> q = robot_.positions();
  std::vector<bool> belongs_to_pose(model.links.size());
  for (const robot::Arm& arm : model.arms) {
    for (const int joint : arm.joints) belongs_to_pose[joint] = true;
  }
  for (const int joint : model.head ? model.head->joints : std::vector<int>()) {
    belongs_to_pose[joint] = true;
  }
  motion::JointTrajectory trajectory;
  std::vector<Following::Column> columns;
  std::vector<double> from, to;
  std::vector<motion::JointLimits> limits;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const motion::TrajectoryChannel& channel = channels_[i];
    // Poses move arms and head only.
    if (channel.is_gripper() || !belongs_to_pose[channel.joint]) continue;
    columns.push_back({.column = columns.size(), .channel = i});
    trajectory.joint_names.push_back(channel.name);
    limits.push_back(channel.limits);
    from.push_back(ClampedTo(channel.limits, q[channel.joint]));
    to.push_back(ClampedTo(channel.limits, found->q[channel.joint]));
  }
  if (columns.empty()) return Say("robot.noJointsForPoses");
  trajectory.points = motion::MoveStraight(from, to, limits, speed);
  Start(std::move(trajectory), std::move(columns), tick);
  return std::nullopt;
}

void TrajectoryFollower::Leave(int joint) {
  for (Following& following : state_.followings) {
    std::erase_if(following.columns, [&](const Following::Column& column) {
      return channels_[column.channel].joint == joint;
    });
  }
  std::erase_if(state_.followings,
                [](const Following& following) { return following.columns.empty(); });
}

void TrajectoryFollower::BeforeTick(std::uint64_t tick) {
  for (const Following& following : state_.followings) {
    // The tick at the end stops the joints: they would keep their last velocity otherwise.
    if (SecondsOf(tick - following.start_tick) < following.trajectory->seconds()) {
      Drive(following, tick);
    } else {
      Stop(following);
    }
  }
  std::erase_if(state_.followings, [&](const Following& following) {
    return SecondsOf(tick - following.start_tick) >= following.trajectory->seconds();
  });
}

void TrajectoryFollower::Drive(const Following& following, std::uint64_t tick) {
  const std::uint64_t elapsed = tick - following.start_tick;
  const motion::TrajectoryPoint now = SampleAt(*following.trajectory, SecondsOf(elapsed));
  // The mean velocity over the tick, so that the joint is at the next sample when it ends.
  const motion::TrajectoryPoint next = SampleAt(*following.trajectory, SecondsOf(elapsed + 1));
  const std::vector<double> q = robot_.positions();
  for (const Following::Column& column : following.columns) {
    const motion::TrajectoryChannel& channel = channels_[column.channel];
    const double at = now.positions[column.column];
    const double rate = (next.positions[column.column] - at) * kTicksPerSecond;
    const double error = at - PositionOf(channel, robot_.model(), q);
    if (channel.is_gripper()) {
      DriveGripper(channel.gripper_of, rate, error);
    } else {
      robot_.SetJointVelocity(channel.joint, rate + kGain * error);
    }
  }
}

void TrajectoryFollower::DriveGripper(int arm, double rate, double error) {
  // A held object is released when the trajectory opens the gripper, not by a correction. With an
  // object between them the fingers cannot reach the opening of the trajectory: the error remains,
  // and must not count as a command.
  const bool keeps = !robot_.HeldBodies(arm).empty() && !(rate > 0 && error > kReleaseMargin);
  robot_.SetGripperVelocity(arm, keeps ? 0.0 : rate + kGain * error);
}

void TrajectoryFollower::Stop(const Following& following) {
  for (const Following::Column& column : following.columns) {
    const motion::TrajectoryChannel& channel = channels_[column.channel];
    if (channel.is_gripper()) {
      robot_.SetGripperVelocity(channel.gripper_of, 0);
    } else {
      robot_.SetJointVelocity(channel.joint, 0);
    }
  }
}

void TrajectoryFollower::AddToHash(StateHash* hash) const {
  hash->Add(std::uint64_t{state_.followings.size()});
  for (const Following& following : state_.followings) {
    hash->Add(following.hash);
    hash->Add(following.start_tick);
    hash->Add(std::uint64_t{following.columns.size()});
    for (const Following::Column& column : following.columns) {
      hash->Add(std::uint64_t{column.column});
      hash->Add(std::uint64_t{column.channel});
    }
  }
}

}  // namespace smile::sim
