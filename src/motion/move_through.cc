// MoveThrough(), see arm_moves.h: a monotone cubic path through the waypoints, with time-optimal
// velocity along it.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "motion/arm_moves.h"
#include "motion/internal_cubic.h"
#include "motion/internal_time_parameterize.h"
#include "motion/internal_timing.h"

namespace smile::motion {
namespace {

/// Numbers of places at which the path velocity is decided: at least between two waypoints, and
/// about in all.
constexpr int kFewestPlacesBetween = 4;
constexpr int kPlacesInAll = 120;

/// Returns the waypoints without those that repeat the one before.
std::vector<std::vector<double>> Distinct(std::span<const std::vector<double>> waypoints,
                                          std::span<const JointLimits> limits) {
  std::vector<std::vector<double>> distinct;
  for (std::size_t k = 0; k < waypoints.size(); ++k) {
    CheckConfiguration(waypoints[k], limits, "waypoint " + std::to_string(k));
    // Equal neighbors would be spans without length, whose secants are 0 / 0. The message counts
    // waypoints as the caller does, hence the check before.
    if (distinct.empty() || distinct.back() != waypoints[k]) distinct.push_back(waypoints[k]);
  }
  return distinct;
}

/// Returns the distance of two waypoints: the time that the slowest joint takes at its full speed
/// [s].
double Between(const std::vector<double>& from, const std::vector<double>& to,
               std::span<const JointLimits> limits) {
  // The path parameter is thereby about time: a path velocity of 1 is full speed for the slowest
  // joint, and tangents have the scale of velocities.
  double longest = 0;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    longest = std::max(longest, std::abs(to[i] - from[i]) / limits[i].max_velocity);
  }
  return longest;
}

/// Monotone piecewise cubic path through all waypoints: it overshoots none.
class MonotonePath {
 public:
  MonotonePath(const std::vector<std::vector<double>>& waypoints,
               std::span<const JointLimits> limits)
      : waypoints_(waypoints) {
    for (std::size_t k = 1; k < waypoints.size(); ++k) {
      spans_.push_back(Between(waypoints[k - 1], waypoints[k], limits));
    }
    for (std::size_t k = 0; k < waypoints.size(); ++k) {
      std::vector<double>& tangents = tangents_.emplace_back();
      for (std::size_t i = 0; i < limits.size(); ++i) tangents.push_back(TangentAt(k, i));
    }
  }

  std::vector<PathPlace> Places() const {
    const int num_spans = static_cast<int>(spans_.size());
    const int between = std::max(kFewestPlacesBetween, kPlacesInAll / num_spans);
    std::vector<PathPlace> places;
    double s = 0;
    for (std::size_t k = 0; k < spans_.size(); ++k) {
      for (int part = 0; part <= between; ++part) {
        const double fraction = static_cast<double>(part) / between;
        PathPlace place = PlaceIn(k, fraction, s + fraction * spans_[k]);
        if (part == 0 && k > 0) {  // also the end of the span before
          // A waypoint is one place with two second derivatives: those of a piecewise cubic jump
          // there.
          places.back().d2q_ds2_after = place.d2q_ds2_after;
        } else {
          places.push_back(std::move(place));
        }
      }
      s += spans_[k];
    }
    return places;
  }

 private:
  double Secant(std::size_t k, std::size_t i) const {
    return (waypoints_[k + 1][i] - waypoints_[k][i]) / spans_[k];
  }
  double TangentAt(std::size_t k, std::size_t i) const {
    // At both ends the path velocity is 0, so any tangent gives rest there; the secant is monotone.
    if (k == 0) return Secant(0, i);
    if (k == spans_.size()) return Secant(k - 1, i);
    return MonotoneTangent(Secant(k - 1, i), Secant(k, i), spans_[k - 1], spans_[k]);
  }
  PathPlace PlaceIn(std::size_t k, double fraction, double s) const {
    const auto count = static_cast<Eigen::Index>(waypoints_[k].size());
    PathPlace place{.s = s, .q = Eigen::VectorXd(count), .dq_ds = Eigen::VectorXd(count)};
    place.d2q_ds2_before = Eigen::VectorXd(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const Cubic cubic{waypoints_[k][j], waypoints_[k + 1][j], tangents_[k][j],
                        tangents_[k + 1][j], spans_[k]};
      place.q[j] = fraction == 0 ? cubic.from : fraction == 1 ? cubic.to : cubic.At(fraction);
      place.dq_ds[j] = cubic.DerivativeAt(fraction);
      place.d2q_ds2_before[j] = cubic.SecondDerivativeAt(fraction);
    }
    place.d2q_ds2_after = place.d2q_ds2_before;
    return place;
  }

  const std::vector<std::vector<double>>& waypoints_;
  std::vector<double> spans_;
  std::vector<std::vector<double>> tangents_;
};

}  // namespace

std::vector<TrajectoryPoint> MoveThrough(std::span<const std::vector<double>> waypoints,
                                         std::span<const JointLimits> limits, double speed) {
  CheckSpeed(speed);
  if (waypoints.empty()) throw std::invalid_argument("no waypoints are given");
  const std::vector<std::vector<double>> distinct = Distinct(waypoints, limits);
  // A straight motion has a closed form; no discretization can be as fast or as exact.
  if (distinct.size() < 3) return MoveStraight(distinct.front(), distinct.back(), limits, speed);
  return TimeParameterize(MonotonePath(distinct, limits).Places(), limits, speed);
}

}  // namespace smile::motion
