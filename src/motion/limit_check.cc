// Exact check of limits. Within a span each joint follows a cubic, whose value, velocity and
// acceleration can be extreme only at the ends or where a derivative vanishes: a few evaluations
// per span replace dense sampling, and no excess between two samples is missed.

#include "motion/limit_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "base/wording.h"
#include "motion/internal_cubic.h"

namespace smile::motion {
namespace {

/// Relative excess that counts as rounding.
constexpr double kRoundingShare = 1e-9;

/// Checks the size and numbers of a point, and that it follows the one before.
void CheckPoint(const TrajectoryPoint& point, std::size_t num_joints, double seconds_before) {
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (point.positions.size() != num_joints || point.velocities.size() != num_joints) {
    throw std::invalid_argument("a point of the trajectory has " +
                                std::to_string(point.positions.size()) + " positions and " +
                                std::to_string(point.velocities.size()) + " velocities, expected " +
                                std::to_string(num_joints) + " each");
  }
  if (!is_finite(point.seconds) || !std::ranges::all_of(point.positions, is_finite) ||
      !std::ranges::all_of(point.velocities, is_finite)) {
    throw std::invalid_argument("a point of the trajectory is not finite");
  }
  if (point.seconds <= seconds_before) {
    throw std::invalid_argument("the points of the trajectory are not in time order");
  }
}

void Check(const JointTrajectory& trajectory, std::size_t num_limits) {
  if (trajectory.joint_names.size() != num_limits) {
    throw std::invalid_argument("there are " + std::to_string(num_limits) + " limits, expected " +
                                std::to_string(trajectory.joint_names.size()));
  }
  // Times must be strictly ascending: spans of zero length have no derivative.
  double before = -HUGE_VAL;
  for (const TrajectoryPoint& point : trajectory.points) {
    CheckPoint(point, num_limits, before);
    before = point.seconds;
  }
}

/// Collects the worst violation of one limit.
class WorstBreach {
 public:
  WorstBreach(const std::string& joint, bool slides, LimitedQuantity quantity, double lower,
              double upper)
      : joint_(joint), slides_(slides), quantity_(quantity), lower_(lower), upper_(upper) {}

  /// @param rounding  error of the value that follows from the rounding of positions.
  void See(double seconds, double value, double rounding = 0) {
    const double limit = value > upper_ ? upper_ : lower_;
    const double beyond = std::max(value - upper_, lower_ - value) - rounding;
    // Relative to the limit's size, with a floor for limits near zero.
    const double size = std::max({1e-3, std::abs(lower_), std::abs(upper_)});
    // Of equal violations the first one counts, as only a larger one replaces it.
    if (beyond <= std::max(beyond_, kRoundingShare * size)) return;
    beyond_ = beyond;
    breach_ = LimitBreach{seconds, joint_, quantity_, value, limit, slides_};
  }
  const std::optional<LimitBreach>& breach() const { return breach_; }

 private:
  std::string joint_;
  bool slides_;
  LimitedQuantity quantity_;
  double lower_, upper_;
  double beyond_ = 0;
  std::optional<LimitBreach> breach_;
};

/// Returns the fractions of a cubic's span at which its value or its derivative may be extreme.
std::vector<double> TurningPoints(const Cubic& cubic) {
  // DerivativeAt(u) = a u^2 + b u + c.
  const double secant_term = 6 * (cubic.from - cubic.to) / cubic.seconds;
  const double a = secant_term + 3 * (cubic.from_derivative + cubic.to_derivative);
  const double b = -secant_term - 4 * cubic.from_derivative - 2 * cubic.to_derivative;
  const double c = cubic.from_derivative;
  std::vector<double> fractions{0, 1};
  const auto add = [&](double u) {
    if (u > 0 && u < 1) fractions.push_back(u);  // false for NaN, too
  };
  // Divisions by zero below give infinities or NaN, which `add` drops: a cubic may be a parabola or
  // a line. First the extreme of the derivative.
  add(-b / (2 * a));
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
  // Both roots, neither as a difference of nearly equal numbers.
  const double q = -0.5 * (b + std::copysign(root, b));
  // Extremes of the value.
  add(q / a);
  add(c / q);
  return fractions;
}

}  // namespace

std::string_view NameOf(LimitedQuantity quantity) {
  constexpr std::array<std::string_view, 3> kNames{"position", "velocity", "acceleration"};
  return kNames[static_cast<std::size_t>(quantity)];
}

std::string ToString(const LimitBreach& breach) {
  constexpr std::array<std::string_view, 3> kPerTime{"", "/s", "/s2"};
  const std::string unit = std::string(breach.slides ? " m" : " rad") +
                           std::string(kPerTime[static_cast<std::size_t>(breach.quantity)]);
  const bool is_above = breach.value > breach.limit;
  return breach.joint_name + ": " + std::string(NameOf(breach.quantity)) + " is " +
         NumberText(breach.value) + unit + ", expected at " + (is_above ? "most " : "least ") +
         NumberText(breach.limit) + unit;
}

std::vector<LimitBreach> CheckLimits(const JointTrajectory& trajectory,
                                     std::span<const JointLimits> limits) {
  Check(trajectory, limits.size());
  std::vector<LimitBreach> breaches;
  const auto& points = trajectory.points;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const JointLimits& limit = limits[i];
    const std::string& name = trajectory.joint_names[i];
    WorstBreach position(name, limit.slides, LimitedQuantity::kPosition, limit.lower, limit.upper);
    WorstBreach velocity(name, limit.slides, LimitedQuantity::kVelocity, -limit.max_velocity,
                         limit.max_velocity);
    WorstBreach acceleration(name, limit.slides, LimitedQuantity::kAcceleration,
                             -limit.max_acceleration, limit.max_acceleration);
    // A trajectory of one point has no span.
    if (!points.empty()) {
      position.See(points[0].seconds, points[0].positions[i]);
      velocity.See(points[0].seconds, points[0].velocities[i]);
    }
    for (std::size_t k = 1; k < points.size(); ++k) {
      const TrajectoryPoint &from = points[k - 1], &to = points[k];
      const Cubic cubic{from.positions[i], to.positions[i], from.velocities[i], to.velocities[i],
                        to.seconds - from.seconds};
      // Of a span as short as a motion to where the joint already is, the derivatives are nothing
      // but rounding. Their greatest factors of the distance: see Cubic.
      const double rounding = std::numeric_limits<double>::epsilon() *
                              (std::abs(cubic.from) + std::abs(cubic.to)) / cubic.seconds;
      for (const double u : TurningPoints(cubic)) {
        const double seconds = from.seconds + u * cubic.seconds;
        position.See(seconds, cubic.At(u));
        velocity.See(seconds, cubic.DerivativeAt(u), 1.5 * rounding);
        // The acceleration jumps at points, so each span is evaluated at both of its ends.
        acceleration.See(seconds, cubic.SecondDerivativeAt(u), 6 * rounding / cubic.seconds);
      }
    }
    for (const WorstBreach* worst : {&position, &velocity, &acceleration}) {
      if (worst->breach()) breaches.push_back(*worst->breach());
    }
  }
  // Stable: simultaneous violations stay in the order of joints and quantities, so messages are
  // deterministic.
  std::ranges::stable_sort(breaches, {}, &LimitBreach::seconds);
  return breaches;
}

}  // namespace smile::motion
