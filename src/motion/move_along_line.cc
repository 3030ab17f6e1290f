// MoveAlongLine(): see arm_moves.h.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/wording.h"
#include "math/angles.h"
#include "motion/arm_moves.h"
#include "motion/internal_cubic.h"
#include "motion/internal_descent.h"
#include "motion/internal_timing.h"

namespace smile::motion {
namespace {

/// The joints are asked for at places so close together.
constexpr double kPlaceEvery = 0.005;  // [m]
constexpr double kAngleEvery = 0.03;   // [rad]
constexpr int kFewestPlaces = 8;
constexpr int kMostPlaces = 8000;
/// From one place to the next no joint may go further: it would be a jump [rad or m].
constexpr double kLongestJump = 0.2;
/// A neighbour is found in a few iterations or not at all.
constexpr int kIterationsPerPlace = 60;
/// Joints are told closer than is asked of the line, so that their slopes are smooth [m, rad].
constexpr double kPlaceTolerance = 1e-9;
/// Of a limit of acceleration, for speeding up along the line; the rest is for its bends.
constexpr double kShareForSpeedingUp = 0.5;

/// The way of the tool, by shares from 0 to 1.
class ToolLine {
 public:
  ToolLine(const RigidTransform& X_WG_from, const RigidTransform& X_WG_to, bool any_turn)
      : from_(X_WG_from), to_(X_WG_to), q_from_(from_.quaternion()), q_to_(to_.quaternion()) {
    if (any_turn) {
      const Vector3 z_from = from_.rotation().col(2), z_to = to_.rotation().col(2);
      q_to_ = Quaternion::FromTwoVectors(z_from, z_to) * q_from_;
    }
    turn_ = RotationVectorBetween(q_from_, q_to_);
  }

  double length() const { return (to_.translation() - from_.translation()).norm(); }
  double angle() const { return turn_.norm(); }

  RigidTransform At(double share) const {
    const Vector3 p = from_.translation() + share * (to_.translation() - from_.translation());
    if (angle() == 0) return {from_.rotation(), p};
    const Quaternion turned(Eigen::AngleAxisd(share * angle(), turn_ / angle()));
    return {turned * q_from_, p};
  }
  /// How far a point is off the line [m].
  double Distance(const Vector3& p) const {
    if (length() == 0) return (p - from_.translation()).norm();
    const Vector3 along = (to_.translation() - from_.translation()) / length();
    const double share = std::clamp((p - from_.translation()).dot(along), 0.0, length());
    return (p - from_.translation() - share * along).norm();
  }

 private:
  RigidTransform from_, to_;
  Quaternion q_from_, q_to_;
  Vector3 turn_;
};

/// The joints at evenly spaced places of a line, and how they change from there with the share.
struct JointPath {
  std::vector<ArmVector> q;
  std::vector<ArmVector> slopes;

  int num_spans() const { return static_cast<int>(q.size()) - 1; }
};

std::variant<JointPath, LineFault> Follow(const ArmKinematics& arm, const ArmVector& q_from,
                                          const ToolLine& line, const RigidTransform& X_WG_goal,
                                          bool any_turn, int num_spans) {
  const IkOptions options{.position_tolerance = kPlaceTolerance,
                          .angle_tolerance = kPlaceTolerance,
                          .any_turn = any_turn};
  JointPath path{.q = {q_from}};
  for (int k = 1; k <= num_spans; ++k) {
    const bool is_end = k == num_spans;
    const double share = static_cast<double>(k) / num_spans;
    const RigidTransform X_WG = is_end ? X_WG_goal : line.At(share);
    const auto fault = [&](const std::string& reason) {
      return LineFault{static_cast<double>(k - 1) / num_spans, X_WG, reason};
    };
    ArmVector q = path.q.back();
    int iterations_left = kIterationsPerPlace;
    if (!Descent(arm, X_WG, options).Run(&q, &iterations_left)) {
      return fault("the arm cannot follow further: out of reach, or a joint is at its limit");
    }
    Eigen::Index joint = 0;
    const double jump = (q - path.q.back()).cwiseAbs().maxCoeff(&joint);
    if (jump > kLongestJump) return fault(arm.joint_names()[joint] + " would have to jump");
    path.q.push_back(q);
  }
  return path;
}

/// Slopes as the neighbours tell them; a joint on its limit stays there for a moment, and one that
/// would swing over it takes the calm slopes.
void FindSlopes(std::span<const JointLimits> limits, JointPath* path) {
  const int n = path->num_spans();
  path->slopes.assign(path->q.size(), ArmVector::Zero(path->q[0].size()));
  const auto secant = [&](int k, int i) { return (path->q[k + 1][i] - path->q[k][i]) * n; };
  const auto leaves_limits = [&](int i) {
    for (int k = 0; k < n; ++k) {
      const Cubic cubic{path->q[k][i], path->q[k + 1][i], path->slopes[k][i],
                        path->slopes[k + 1][i], 1.0 / n};
      // Close enough to the limits to look: the corners of the cubic's control polygon.
      for (const double corner : {cubic.from + cubic.from_slope * cubic.seconds / 3,
                                  cubic.to - cubic.to_slope * cubic.seconds / 3}) {
        if (corner < limits[i].lower || corner > limits[i].upper) return true;
      }
    }
    return false;
  };
  for (int i = 0; i < path->q[0].size(); ++i) {
    for (int k = 0; k <= n; ++k) {
      const double before = secant(std::max(0, k - 1), i), after = secant(std::min(k, n - 1), i);
      path->slopes[k][i] = (before + after) / 2;
    }
    if (!leaves_limits(i)) continue;
    for (int k = 0; k <= n; ++k) {
      const double before = secant(std::max(0, k - 1), i), after = secant(std::min(k, n - 1), i);
      path->slopes[k][i] = CalmSlope(before, after, 1, 1);
    }
  }
}

/// How far the tool strays between the places [m].
double LargestDeviation(const ArmKinematics& arm, const ToolLine& line, const JointPath& path) {
  double largest = 0;
  const int n = path.num_spans();
  for (int k = 0; k < n; ++k) {
    ArmVector q = path.q[k];
    for (int i = 0; i < q.size(); ++i) {
      q[i] =
          Cubic{path.q[k][i], path.q[k + 1][i], path.slopes[k][i], path.slopes[k + 1][i], 1.0 / n}
              .At(0.5);
    }
    const RigidTransform X_WG = arm.ToolPose({q.data(), static_cast<std::size_t>(q.size())});
    largest = std::max(largest, line.Distance(X_WG.translation()));
  }
  return largest;
}

/// The share of the way over time: faster and faster, evenly, slower and slower. It changes from
/// one to the next at places of the path.
struct Pace {
  double rate = 0;    ///< while it goes evenly [1/s]
  double growth = 0;  ///< of the rate before that [1/s2]
};

Pace PaceFor(const JointPath& path, std::span<const JointLimits> limits, double length,
             const LineOptions& options) {
  const int n = path.num_spans();
  Pace pace{.rate = options.tool_speed / length, .growth = HUGE_VAL};  // infinite without length
  for (int k = 0; k <= n; ++k) {
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const double slope = std::abs(path.slopes[k][i]);
      const double bend =
          k == 0 || k == n
              ? 0
              : std::abs(path.q[k + 1][i] - 2 * path.q[k][i] + path.q[k - 1][i]) * n * n;
      const double acceleration = limits[i].max_acceleration;
      pace.rate = std::min({pace.rate, options.speed * limits[i].max_velocity / slope,
                            std::sqrt((1 - kShareForSpeedingUp) * acceleration / bend)});
      pace.growth = std::min(pace.growth, kShareForSpeedingUp * acceleration / slope);
    }
  }
  return pace;
}

std::vector<TrajectoryPoint> PointsAlong(const JointPath& path, Pace pace) {
  const int n = path.num_spans();
  const double ramp_share = pace.rate * pace.rate / (2 * pace.growth);
  const int ramp =
      ramp_share < 0.5 ? std::max(1, static_cast<int>(std::ceil(ramp_share * n))) : n / 2;
  const double ramp_end = std::min(0.5, static_cast<double>(ramp) / n);
  pace.rate = std::min(pace.rate, std::sqrt(2 * pace.growth * ramp_end));
  pace.growth = pace.rate * pace.rate / (2 * ramp_end);
  const double ramp_seconds = pace.rate / pace.growth;
  const double seconds = 2 * ramp_seconds + (1 - 2 * ramp_end) / pace.rate;

  std::vector<TrajectoryPoint> points;
  for (int k = 0; k <= n; ++k) {
    const double share = static_cast<double>(k) / n;
    const double to_end = std::min(share, 1 - share);
    double rate = pace.rate, from_end = ramp_seconds + (to_end - ramp_end) / pace.rate;
    if (std::min(k, n - k) <= ramp) {
      from_end = std::sqrt(2 * to_end / pace.growth);
      rate = pace.growth * from_end;
    }
    TrajectoryPoint point{.seconds = 2 * k <= n ? from_end : seconds - from_end};
    for (int i = 0; i < path.q[k].size(); ++i) {
      point.positions.push_back(path.q[k][i]);
      point.velocities.push_back(rate * path.slopes[k][i]);
    }
    points.push_back(std::move(point));
  }
  return points;
}

void CheckLine(const LineOptions& options) {
  CheckSpeed(options.speed);
  if (options.tool_speed > 0) return;
  throw std::invalid_argument("tool_speed is " + NumberText(options.tool_speed) +
                              ", expected above 0");
}

int NumSpans(const ToolLine& line) {
  const double wanted = std::max(line.length() / kPlaceEvery, line.angle() / kAngleEvery);
  const int spans = static_cast<int>(
      std::ceil(std::clamp(wanted, double{kFewestPlaces}, double{kMostPlaces / 8})));
  return spans + spans % 2;  // even: there is a place in the middle
}

}  // namespace

std::variant<JointTrajectory, LineFault> MoveAlongLine(const ArmKinematics& arm,
                                                       std::span<const double> q_from,
                                                       const RigidTransform& X_WG_goal,
                                                       const LineOptions& options) {
  CheckGoal(X_WG_goal);
  CheckLine(options);
  CheckConfiguration(q_from, arm.limits(), "q_from");
  const ArmVector start = WithinLimits(arm, q_from);
  const ToolLine line(arm.ToolPose(q_from), X_WG_goal, options.any_turn);
  JointTrajectory trajectory{.joint_names = arm.joint_names()};
  if (line.length() < kPlaceTolerance && line.angle() < kPlaceTolerance) {
    trajectory.points.push_back({.positions = {q_from.begin(), q_from.end()},
                                 .velocities = std::vector(q_from.size(), 0.0)});
    return trajectory;
  }

  // Closer and closer places, until the joints' cubics keep to the line.
  for (int num_spans = NumSpans(line);; num_spans *= 2) {
    auto followed = Follow(arm, start, line, X_WG_goal, options.any_turn, num_spans);
    if (auto* fault = std::get_if<LineFault>(&followed)) return std::move(*fault);
    JointPath& path = std::get<JointPath>(followed);
    FindSlopes(arm.limits(), &path);
    if (LargestDeviation(arm, line, path) > kLineTolerance) {
      if (num_spans * 2 <= kMostPlaces) continue;
      return LineFault{0, X_WG_goal, "the joints cannot keep the tool on the line"};
    }
    trajectory.points = PointsAlong(path, PaceFor(path, arm.limits(), line.length(), options));
    SlowDownToLimits(arm.limits(), options.speed, &trajectory.points);
    return trajectory;
  }
}

}  // namespace smile::motion
