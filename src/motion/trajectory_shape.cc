#include "motion/trajectory_shape.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/json.h"
#include "base/wording.h"

namespace smile::motion {
namespace {

constexpr std::size_t kMaxName = 256;

/// Returns true for a name that survives a round trip through CSV and JSON.
bool IsName(const std::string& name) {
  if (name.empty() || name.size() > kMaxName || name.front() == ' ' || name.back() == ' ') {
    return false;
  }
  // A comma or a line break would split a cell of a CSV table in two.
  const bool is_plain = std::ranges::none_of(name, [](char letter) {
    return letter == ',' || static_cast<unsigned char>(letter) < ' ' || letter == '\x7f';
  });
  // JSON would replace invalid UTF-8.
  return is_plain && ParseJson(ToText(Json(name))) == name;
}

/// Returns the fault in the values of a point, or an empty text.
/// @param what  `positions` or `velocities`.
std::string FaultOfNumbers(const std::vector<double>& numbers, std::size_t expected,
                           const char* what) {
  if (numbers.size() != expected) {
    return "there are " + std::to_string(numbers.size()) + " " + what + ", expected " +
           std::to_string(expected);
  }
  for (const double number : numbers) {
    // False for NaN and infinity, which are reported as well.
    if (std::abs(number) <= kMaxTrajectoryNumber) continue;
    return "one of the " + std::string(what) + " is " + NumberText(number) +
           ", expected at most 1e6";
  }
  return {};
}

/// Returns the tangent at a point, limited to keep the cubics monotone where the data are; `before`
/// and `after` are the slopes of the secants.
double LimitedTangent(double before, double after, double central) {
  // A local extreme, or a plateau: any other tangent would overshoot it.
  if (before * after <= 0) return 0;
  // Three times the smaller slope is the limit of Fritsch and Carlson for monotonicity.
  const double most = 3 * std::min(std::abs(before), std::abs(after));
  return std::clamp(central, -most, most);
}

}  // namespace

std::string FaultOfTime(double seconds, const TrajectoryPoint* before) {
  if (!(seconds >= 0 && seconds <= kMaxTrajectorySeconds)) {
    return "the time is " + NumberText(seconds) + " s, expected 0 to 86400";
  }
  if (before != nullptr && seconds <= before->seconds) {
    return "the time is " + NumberText(seconds) + " s, expected more than the " +
           NumberText(before->seconds) + " s before";
  }
  return {};
}

std::string FaultOfNames(const std::vector<std::string>& names) {
  if (names.size() > kMaxTrajectoryJoints) {
    return "there are more than " + std::to_string(kMaxTrajectoryJoints) + " joints";
  }
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (!IsName(*name)) {
      return "the name of a joint is " + Quoted(*name) +
             ", expected 1 to 256 characters in UTF-8 without commas";
    }
    if (std::find(names.begin(), name, *name) != name) {
      return "joint " + Quoted(*name) + " appears twice";
    }
  }
  return names.empty() ? "there are no joints" : "";
}

void CheckShape(const JointTrajectory& trajectory, bool has_velocities) {
  const auto fail_if = [](const std::string& place, const std::string& fault) {
    if (!fault.empty()) throw std::invalid_argument(place + fault);
  };
  const auto& points = trajectory.points;
  fail_if("", FaultOfNames(trajectory.joint_names));
  if (points.empty()) throw std::invalid_argument("there are no points");
  if (points.size() > kMaxTrajectoryPoints) {
    throw std::invalid_argument("there are more than " + std::to_string(kMaxTrajectoryPoints) +
                                " points");
  }
  const std::size_t num_joints = trajectory.joint_names.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string place = "points[" + std::to_string(i) + "]: ";
    fail_if(place, FaultOfTime(points[i].seconds, i == 0 ? nullptr : &points[i - 1]));
    fail_if(place, FaultOfNumbers(points[i].positions, num_joints, "positions"));
    fail_if(place,
            FaultOfNumbers(points[i].velocities, has_velocities ? num_joints : 0, "velocities"));
  }
}

void SetVelocitiesFromPositions(JointTrajectory* trajectory) {
  std::vector<TrajectoryPoint>& points = trajectory->points;
  const std::size_t num_joints = trajectory->joint_names.size();
  for (TrajectoryPoint& point : points) point.velocities.assign(num_joints, 0.0);
  if (points.size() < 2) return;
  const auto chord = [&](std::size_t from, std::size_t to, std::size_t joint) {
    return (points[to].positions[joint] - points[from].positions[joint]) /
           (points[to].seconds - points[from].seconds);
  };
  // Each joint by itself: its interior points have a secant on either side.
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i < num_joints; ++i) {
    points[0].velocities[i] = chord(0, 1, i);
    for (std::size_t k = 1; k < last; ++k) {
      points[k].velocities[i] =
          LimitedTangent(chord(k - 1, k, i), chord(k, k + 1, i), chord(k - 1, k + 1, i));
    }
    points[last].velocities[i] = chord(last - 1, last, i);
  }
}

void ScaleTime(double factor, JointTrajectory* trajectory) {
  for (TrajectoryPoint& point : trajectory->points) {
    point.seconds *= factor;
    for (double& velocity : point.velocities) velocity /= factor;
  }
}

}  // namespace smile::motion
