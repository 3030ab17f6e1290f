// MoveAlongLine(), see arm_moves.h: solves the inverse kinematics at evenly spaced places of the
// line, each from the solution before, connects them by cubics, and doubles the number of places
// until the cubics keep the tool on the line.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/wording.h"
#include "math/angles.h"
#include "motion/arm_moves.h"
#include "motion/internal_cubic.h"
#include "motion/internal_damped_least_squares.h"
#include "motion/internal_time_parameterize.h"
#include "motion/internal_timing.h"

namespace smile::motion {
namespace {

/// Initial distance of the places at which the joints are solved.
constexpr double kPlaceEvery = 0.005;  // [m]
constexpr double kAngleEvery = 0.03;   // [rad]
constexpr int kFewestPlaces = 8;
constexpr int kMostPlaces = 1000;
/// Upper bound of places after doubling.
constexpr int kMostPlacesInTheEnd = 8000;
/// Greatest motion of a joint between two places: more would be a jump to another solution [rad or
/// m].
constexpr double kLongestJump = 0.2;
/// Iterations per place: the solution at the next place is found in a few iterations or not at all.
constexpr int kIterationsPerPlace = 60;
/// Joints are solved more exactly than the line requires, so that their derivatives are smooth [m,
/// rad].
constexpr double kPlaceTolerance = 1e-9;
/// An arm of fewer than six joints cannot make up for the rounded numbers of its description, which
/// put its axes out of line: it keeps to the line as well as it can, and to within these [m, rad].
constexpr double kRoundedPlace = 1e-5, kRoundedAngle = 1e-3;

/// Path of the tool, by fractions of the line from 0 to 1.
class ToolLine {
 public:
  ToolLine(const RigidTransform& X_WG_from, const RigidTransform& X_WG_to,
           const LineOptions& options)
      : from_(X_WG_from), to_(X_WG_to), q_from_(from_.quaternion()), q_to_(to_.quaternion()) {
    if (options.any_rotation) {
      q_to_ = q_from_;
    } else if (options.any_turn) {
      // The smallest rotation that aligns the axes; the rotation about the axis is free.
      const Vector3 z_from = from_.rotation().col(2), z_to = to_.rotation().col(2);
      q_to_ = SmallestRotation(z_from, z_to) * q_from_;
    }
    // At most pi: the tool rotates the shorter way round.
    turn_ = RotationVectorBetween(q_from_, q_to_);
  }

  double length() const { return (to_.translation() - from_.translation()).norm(); }
  double angle() const { return turn_.norm(); }

  RigidTransform At(double fraction) const {
    const Vector3 p = from_.translation() + fraction * (to_.translation() - from_.translation());
    // An axis would be a division by zero.
    if (angle() == 0) return {from_.rotation(), p};
    const Quaternion turned(Eigen::AngleAxisd(fraction * angle(), turn_ / angle()));
    return {turned * q_from_, p};
  }
  /// Returns the distance of a point from the line [m].
  double Distance(const Vector3& p) const {
    if (length() == 0) return (p - from_.translation()).norm();
    const Vector3 along = (to_.translation() - from_.translation()) / length();
    const double distance = std::clamp((p - from_.translation()).dot(along), 0.0, length());
    return (p - from_.translation() - distance * along).norm();
  }

 private:
  RigidTransform from_, to_;
  Quaternion q_from_, q_to_;
  Vector3 turn_;
};

/// Joint positions at evenly spaced places of a line, and their derivatives by the fraction of it.
struct JointPath {
  std::vector<ArmVector> q;
  std::vector<ArmVector> derivatives;

  int num_spans() const { return static_cast<int>(q.size()) - 1; }
};

/// Returns a hint for a place that only the rotation of the tool makes unreachable; otherwise an
/// empty text.
std::string WayOut(const ArmKinematics& arm, const ArmVector& q_before, const RigidTransform& X_WG,
                   IkOptions options) {
  const auto is_reached = [&] {
    ArmVector q = q_before;
    int iterations_left = kIterationsPerPlace;
    return DampedLeastSquares(arm, X_WG, options).Run(&q, &iterations_left);
  };
  std::string hint = std::exchange(options.any_turn, true) || !is_reached()
                         ? ""
                         : "; it can with any turn of the tool about its axis";
  if (hint.empty() && !std::exchange(options.any_rotation, true) && is_reached()) {
    hint = "; it can with any rotation of the tool";
  }
  if (!hint.empty() && arm.num_joints() < 6) {
    hint += ", since an arm of " + std::to_string(arm.num_joints()) +
            " joints cannot keep every rotation";
  }
  return hint;
}

/// Moves `q` to a place of the line, as near to it as the arm can. Returns false if it cannot.
bool Reach(const ArmKinematics& arm, const RigidTransform& X_WG, IkOptions options, ArmVector* q) {
  int iterations_left = kIterationsPerPlace;
  if (DampedLeastSquares(arm, X_WG, options).Run(q, &iterations_left)) return true;
  if (arm.num_joints() >= 6) return false;
  options.position_tolerance = kRoundedPlace;
  options.angle_tolerance = kRoundedAngle;
  iterations_left = 1;  // only asks whether this is met
  return DampedLeastSquares(arm, X_WG, options).Run(q, &iterations_left);
}

/// Returns the joint positions at all places, or the first place that the arm cannot reach without
/// a jump.
std::variant<JointPath, LineFault> Follow(const ArmKinematics& arm, const ArmVector& q_from,
                                          const ToolLine& line, const RigidTransform& X_WG_goal,
                                          const LineOptions& line_options, int num_spans) {
  const IkOptions options{.position_tolerance = kPlaceTolerance,
                          .angle_tolerance = kPlaceTolerance,
                          .any_turn = line_options.any_turn,
                          .any_rotation = line_options.any_rotation};
  JointPath path{.q = {q_from}};
  for (int k = 1; k <= num_spans; ++k) {
    const bool is_end = k == num_spans;
    const double fraction = static_cast<double>(k) / num_spans;
    // The goal itself, without the rounding of an interpolation, so that the tool ends where it was
    // sent.
    const RigidTransform X_WG = is_end ? X_WG_goal : line.At(fraction);
    const auto fault = [&](const std::string& reason) {
      return LineFault{static_cast<double>(k - 1) / num_spans, X_WG, reason};
    };
    // Started at the place before, the solver stays in the same branch of solutions. It would find
    // other branches only from other starts, which are deliberately not tried: they are not
    // connected.
    ArmVector q = path.q.back();
    if (!Reach(arm, X_WG, options, &q)) {
      return fault("the arm cannot follow further: out of reach, or a joint is at its limit" +
                   WayOut(arm, path.q.back(), X_WG, options));
    }
    Eigen::Index joint = 0;
    // Near a singular configuration the solver may still leave the branch within one place.
    const double jump = (q - path.q.back()).cwiseAbs().maxCoeff(&joint);
    if (jump > kLongestJump) return fault(arm.joint_names()[joint] + " would have to jump");
    path.q.push_back(q);
  }
  return path;
}

/// Sets the derivatives to the central differences of the positions, one-sided at both ends.
void SetDerivatives(JointPath* path) {
  const int n = path->num_spans();
  for (int k = 0; k <= n; ++k) {
    const int before = std::max(0, k - 1), after = std::min(n, k + 1);
    // By the fraction of the line: places are 1 / n apart, one span at the ends and two in between.
    path->derivatives.push_back((path->q[after] - path->q[before]) * n / (after - before));
  }
}

/// Returns the largest deviation of the tool from the line between the places [m].
double LargestDeviation(const ArmKinematics& arm, const ToolLine& line, const JointPath& path) {
  double largest = 0;
  const int n = path.num_spans();
  for (int k = 0; k < n; ++k) {
    ArmVector q = path.q[k];
    // In the middle between two places, where a cubic through exact ends deviates most.
    for (int i = 0; i < q.size(); ++i) {
      q[i] = Cubic{path.q[k][i], path.q[k + 1][i], path.derivatives[k][i],
                   path.derivatives[k + 1][i], 1.0 / n}
                 .At(0.5);
    }
    const RigidTransform X_WG = arm.ToolPose({q.data(), static_cast<std::size_t>(q.size())});
    largest = std::max(largest, line.Distance(X_WG.translation()));
  }
  return largest;
}

/// Returns the path with the fraction of the line as its parameter.
std::vector<PathPlace> PlacesOf(const JointPath& path) {
  const int n = path.num_spans();
  std::vector<PathPlace> places;
  for (int k = 0; k <= n; ++k) {
    // Central second difference; the ends use that of their neighbors. n is at least kFewestPlaces,
    // so there is always a neighbor on both sides of the middle.
    const int middle = std::clamp(k, 1, n - 1);
    const Eigen::VectorXd d2q_ds2 =
        (path.q[middle + 1] - 2 * path.q[middle] + path.q[middle - 1]) * n * n;
    places.push_back(
        {static_cast<double>(k) / n, path.q[k], path.derivatives[k], d2q_ds2, d2q_ds2});
  }
  return places;
}

void CheckLine(const LineOptions& options) {
  CheckSpeed(options.speed);
  if (options.tool_speed > 0) return;
  throw std::invalid_argument("tool_speed is " + NumberText(options.tool_speed) +
                              ", expected above 0");
}

/// Returns the initial number of spans between places, even.
int NumSpans(const ToolLine& line) {
  const double wanted = std::max(line.length() / kPlaceEvery, line.angle() / kAngleEvery);
  const int spans =
      static_cast<int>(std::ceil(std::clamp(wanted, double{kFewestPlaces}, double{kMostPlaces})));
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
  const ToolLine line(arm.ToolPose(q_from), X_WG_goal, options);
  JointTrajectory trajectory{.joint_names = arm.joint_names()};
  if (line.length() < kPlaceTolerance && line.angle() < kPlaceTolerance) {
    trajectory.points.push_back({.positions = {q_from.begin(), q_from.end()},
                                 .velocities = std::vector(q_from.size(), 0.0)});
    return trajectory;
  }

  // Double the places until the joints' cubics keep to the line.
  for (int num_spans = NumSpans(line);; num_spans *= 2) {
    auto followed = Follow(arm, start, line, X_WG_goal, options, num_spans);
    if (auto* fault = std::get_if<LineFault>(&followed)) return std::move(*fault);
    JointPath& path = std::get<JointPath>(followed);
    SetDerivatives(&path);
    if (LargestDeviation(arm, line, path) > kLineTolerance) {
      // The deviation of cubics shrinks quickly with the distance of places, so doubling ends soon,
      // if the joints move smoothly at all.
      if (num_spans * 2 <= kMostPlacesInTheEnd) continue;
      return LineFault{0, X_WG_goal, "the joints cannot keep the tool on the line"};
    }
    // Fraction of the line per second [1/s]; infinite for a rotation in place.
    const double top_rate = options.tool_speed / line.length();
    trajectory.points = TimeParameterize(PlacesOf(path), arm.limits(), options.speed, top_rate);
    return trajectory;
  }
}

}  // namespace smile::motion
