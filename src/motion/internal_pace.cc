#include "motion/internal_pace.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/internal_timing.h"

namespace smile::motion {
namespace {

/// A rate need not be known better than this share.
constexpr int kHalvings = 30;
/// The places see nothing of what is between them. Where that breaks a limit by more than this
/// share, it is passed more slowly in the next round.
constexpr double kHardlySlower = 1.02;
constexpr int kRounds = 6;
/// Stands for no limit at all: no rate is larger [1/s2].
constexpr double kHighest = 1e12;

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

/// From one place to the next, where the rate of s changes evenly. Squares of rates are linear
/// then: square_to = square_from + 2 * way * growth.
class Stretch {
 public:
  Stretch(const PathPlace& from, const PathPlace& to, std::span<const JointLimits> limits)
      : from_(from), to_(to), limits_(limits), way_(to.s - from.s) {}

  double SquareAfter(double square, double growth) const {
    return std::max(0.0, square + 2 * way_ * growth);
  }
  /// How the rate may grow from there, so that no joint breaks its limit of acceleration at either
  /// end and the next square is at most `next_square`.
  Interval Growths(double square, double next_square) const {
    Interval growths{-square / (2 * way_), (next_square - square) / (2 * way_)};
    for (std::size_t i = 0; i < limits_.size(); ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      const double bound = limits_[i].max_acceleration;
      growths.Restrict(from_.slope[j], from_.bend_after[j] * square, bound);
      growths.Restrict(to_.slope[j] + 2 * way_ * to_.bend_before[j], to_.bend_before[j] * square,
                       bound);
    }
    return growths;
  }
  /// The largest square, up to `top`, from which one can get to at most `next_square`. All from 0
  /// up to it are as good: what is allowed is convex, and standing still is always allowed.
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
  double way_;
};

/// What the limits of velocity and the bends alone allow at one place.
double TopSquare(const PathPlace& place, std::span<const JointLimits> limits, double speed,
                 double top_rate) {
  double square = std::min(kHighest, top_rate * top_rate);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    const double rate = speed * limits[i].max_velocity / std::abs(place.slope[j]);
    square = std::min(square, rate * rate);
  }
  return square;
}

/// Takes so much from velocities near limits of position that no cubic swings over one: the corners
/// of its control polygon, between which it lies, stay within.
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

/// The squares of the rates at all places, from rest to rest, each at most its top.
std::vector<double> FastestSquares(const std::vector<PathPlace>& path,
                                   std::span<const JointLimits> limits,
                                   const std::vector<double>& tops) {
  // Backwards: the largest rates from which one can still stop in time.
  const std::size_t count = path.size();
  std::vector<double> squares(count, 0.0);
  for (std::size_t k = count - 1; k-- > 0;) {
    squares[k] = Stretch(path[k], path[k + 1], limits).LargestSquare(tops[k], squares[k + 1]);
  }
  // Forwards: as fast as one gets, within those.
  squares[0] = 0;
  for (std::size_t k = 0; k + 1 < count; ++k) {
    const Stretch stretch(path[k], path[k + 1], limits);
    const double growth = stretch.Growths(squares[k], squares[k + 1]).high;
    squares[k + 1] = std::min(squares[k + 1], stretch.SquareAfter(squares[k], growth));
  }
  return squares;
}

std::vector<TrajectoryPoint> PointsAt(const std::vector<PathPlace>& path,
                                      const std::vector<double>& squares) {
  std::vector<TrajectoryPoint> points;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double rate = std::sqrt(squares[k]);
    TrajectoryPoint point;
    if (k > 0) {
      const double way = path[k].s - path[k - 1].s;
      point.seconds = points.back().seconds + 2 * way / (std::sqrt(squares[k - 1]) + rate);
    }
    for (Eigen::Index j = 0; j < path[k].q.size(); ++j) {
      point.positions.push_back(path[k].q[j]);
      point.velocities.push_back(rate * path[k].slope[j]);
    }
    points.push_back(std::move(point));
  }
  return points;
}

/// Lowers the tops where the cubics between two points break a limit.
/// @returns whether it had to.
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

std::vector<TrajectoryPoint> RunAlong(const std::vector<PathPlace>& path,
                                      std::span<const JointLimits> limits, double speed,
                                      double top_rate) {
  std::vector<double> tops;
  for (const PathPlace& place : path) tops.push_back(TopSquare(place, limits, speed, top_rate));
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
