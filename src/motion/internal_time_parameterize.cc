// Time-optimal path parameterization by reachability analysis (TOPP-RA), in terms of the squared
// path velocity x = s'^2 and the path acceleration u = s''. Joint accelerations
// q'' = dq_ds u + d2q_ds2 x are linear in both, and x is linear in s for a constant u, so each span
// is a small linear problem. Limits at the places do not imply limits between them; a few rounds
// lower the velocity where that matters.

#include "motion/internal_time_parameterize.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/internal_timing.h"

namespace smile::motion {
namespace {

/// Bisections of a squared path velocity: the error is at most 2^-30 of its upper bound.
constexpr int kHalvings = 30;
/// Limits are checked at the places only. Where the cubic between two places exceeds a limit by
/// more than this factor, the path velocity there is reduced in the next round.
constexpr double kHardlySlower = 1.02;
constexpr int kRounds = 6;
/// Upper bound of all squared path velocities, stands for no limit [1/s2].
constexpr double kHighest = 1e12;

/// Closed interval of path accelerations.
struct Interval {
  double low = -HUGE_VAL, high = HUGE_VAL;

  bool is_empty() const { return low > high; }
  /// Keeps those x with |factor * x + offset| <= bound.
  void Restrict(double factor, double offset, double bound) {
    if (factor == 0) {
      if (std::abs(offset) > bound) high = -HUGE_VAL;
      return;
    }
    const double a = (-bound - offset) / factor, b = (bound - offset) / factor;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
};

/// Span between two places of a path, with a constant path acceleration `growth`. The squared path
/// velocity is then linear in s: square_to = square_from + 2 * length * growth.
class PathSpan {
 public:
  PathSpan(const PathPlace& from, const PathPlace& to, std::span<const JointLimits> limits)
      : from_(from), to_(to), limits_(limits), length_(to.s - from.s) {}

  double SquareAfter(double square, double growth) const {
    return std::max(0.0, square + 2 * length_ * growth);
  }
  /// Returns the path accelerations with which no joint exceeds its limit of acceleration at either
  /// end and the next square is at most `next_square`.
  Interval Growths(double square, double next_square) const {
    Interval growths{-square / (2 * length_), (next_square - square) / (2 * length_)};
    // At the start of the span x is `square`, at its end square + 2 length growth; both must
    // respect the limit.
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      const double bound = limits_[i].max_acceleration;
      growths.Restrict(from_.dq_ds[j], from_.d2q_ds2_after[j] * square, bound);
      growths.Restrict(to_.dq_ds[j] + 2 * length_ * to_.d2q_ds2_before[j],
                       to_.d2q_ds2_before[j] * square, bound);
    }
    return growths;
  }
  /// Returns the largest square, up to `top`, from which a square of at most `next_square` can be
  /// reached. The same holds for all smaller squares: the admissible set is convex and contains 0.
  double LargestSquare(double top, double next_square) const {
    if (!Growths(top, next_square).is_empty()) return top;
    double low = 0, high = top;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (low + high) / 2;
      (Growths(middle, next_square).is_empty() ? high : low) = middle;
    }
    return low;
  }

 private:
  const PathPlace& from_;
  const PathPlace& to_;
  std::span<const JointLimits> limits_;
  double length_;
};

/// Returns the squared path velocity that the limits of joint velocity alone allow at a place.
double TopSquare(const PathPlace& place, std::span<const JointLimits> limits, double speed,
                 double top_rate) {
  double square = std::min(kHighest, top_rate * top_rate);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    const double rate = speed * limits[i].max_velocity / std::abs(place.dq_ds[j]);
    square = std::min(square, rate * rate);
  }
  return square;
}

/// Reduces velocities near limits of position such that no cubic exceeds one: the corners of its
/// control polygon, whose convex hull contains the cubic, stay within.
void KeepWithin(std::span<const JointLimits> limits, std::vector<TrajectoryPoint>* points) {
  for (std::size_t k = 1; k < points->size(); ++k) {
    TrajectoryPoint &from = (*points)[k - 1], &to = (*points)[k];
    const double third = (to.seconds - from.seconds) / 3;
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const auto [lower, upper] = std::pair(limits[i].lower, limits[i].upper);
      from.velocities[i] = std::clamp(from.velocities[i], (lower - from.positions[i]) / third,
                                      (upper - from.positions[i]) / third);
      to.velocities[i] = std::clamp(to.velocities[i], (to.positions[i] - upper) / third,
                                    (to.positions[i] - lower) / third);
    }
  }
}

/// Returns the squared path velocities at all places, from rest to rest, each at most its top.
std::vector<double> FastestSquares(const std::vector<PathPlace>& path,
                                   std::span<const JointLimits> limits,
                                   const std::vector<double>& tops) {
  // Backward pass: the largest path velocities from which the motion can still stop in time.
  const std::size_t count = path.size();
  std::vector<double> squares(count, 0.0);
  for (std::size_t k = count - 1; k-- > 0;) {
    squares[k] = PathSpan(path[k], path[k + 1], limits).LargestSquare(tops[k], squares[k + 1]);
  }
  // Forward pass: the largest path velocities that can be reached, within those.
  squares[0] = 0;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const PathSpan span(path[k], path[k + 1], limits);
    const double growth = span.Growths(squares[k], squares[k + 1]).high;
    squares[k + 1] = std::min(squares[k + 1], span.SquareAfter(squares[k], growth));
  }
  return squares;
}

/// Returns the points of a motion with these squared path velocities. With constant path
/// acceleration, a span takes its length divided by the mean of the velocities at its ends.
std::vector<TrajectoryPoint> PointsAt(const std::vector<PathPlace>& path,
                                      const std::vector<double>& squares) {
  std::vector<TrajectoryPoint> points;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double rate = std::sqrt(squares[k]);
    TrajectoryPoint point;
    if (k > 0) {
      const double length = path[k].s - path[k - 1].s;
      point.seconds = points.back().seconds + 2 * length / (std::sqrt(squares[k - 1]) + rate);
    }
    for (Eigen::Index j = 0; j < path[k].q.size(); ++j) {
      point.positions.push_back(path[k].q[j]);
      point.velocities.push_back(rate * path[k].dq_ds[j]);
    }
    points.push_back(std::move(point));
  }
  return points;
}

/// Lowers the tops where the cubics between two points exceed a limit.
/// @returns true if any top was lowered.
bool LowerTops(const std::vector<TrajectoryPoint>& points, std::span<const JointLimits> limits,
               double speed, const std::vector<double>& squares, std::vector<double>* tops) {
  bool had_to = false;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double needed = SlownessNeeded(points[k - 1], points[k], limits, speed);
    if (needed <= kHardlySlower) continue;
    had_to = true;
    for (const std::size_t end : {k - 1, k}) {
      (*tops)[end] = std::min((*tops)[end], squares[end] / (needed * needed));
    }
  }
  return had_to;
}

}  // namespace

std::vector<TrajectoryPoint> TimeParameterize(const std::vector<PathPlace>& path,
                                              std::span<const JointLimits> limits, double speed,
                                              double top_rate) {
  std::vector<double> tops;
  for (const PathPlace& place : path) tops.push_back(TopSquare(place, limits, speed, top_rate));
  // After the last round, the remaining small excess is removed by scaling the whole trajectory.
  for (int round = 1;; ++round) {
    const std::vector<double> squares = FastestSquares(path, limits, tops);
    std::vector<TrajectoryPoint> points = PointsAt(path, squares);
    KeepWithin(limits, &points);
    if (round < kRounds && LowerTops(points, limits, speed, squares, &tops)) continue;
    SlowDownToLimits(limits, speed, &points);
    return points;
  }
}

}  // namespace smile::motion
