#include "control.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "base/wording.h"
#include "math/angles.h"
#include "motion/arm_moves.h"
#include "motion/inverse_kinematics.h"

namespace smile::python {
namespace {

/// Numbers of a gripper nearer to 0 leave it as it is: noise of a policy must not drop things.
constexpr double kGripperRest = 0.1;
/// Speed of the opening of a gripper that has none [m/s].
constexpr double kOpeningSpeed = 0.1;
/// After a waypoint the gripper moves for so long [ticks].
constexpr int kGripperTicks = sim::kTicksPerSecond / 2;
/// Limit of the duration of a waypoint [ticks].
constexpr int kMaxWaypointTicks = 10 * sim::kTicksPerSecond;
/// Damping of the inverse of the Jacobian: limits velocities near singular configurations.
constexpr double kDamping = 0.03;
/// Attempts to find a configuration for a waypoint are short: an action that is out of reach must
/// not take longer than others.
constexpr int kMaxIterations = 300;

constexpr double kTickSeconds = 1.0 / sim::kTicksPerSecond;

double Between(double low, double high, double number) {
  return low + (number + 1) / 2 * (high - low);
}

/// Scales velocities so that none is beyond its limit.
void LimitSpeeds(const std::vector<motion::JointLimits>& limits, double speed,
                 std::vector<double>* velocities) {
  double scale = 1;
  for (std::size_t i = 0; i < velocities->size(); ++i) {
    const double most = speed * limits[i].max_velocity;
    scale = std::min(scale, most / std::max(most, std::abs((*velocities)[i])));
  }
  for (double& velocity : *velocities) velocity *= scale;
}

}  // namespace

Control::Control(std::shared_ptr<const model::Model> model, ControlOptions options)
    : model_(std::move(model)), options_(std::move(options)) {
  if (model_->robot() == nullptr) throw std::invalid_argument("there is no robot, expected one");
  const robot::RobotModel& robot = *model_->robot();
  std::vector<std::string_view> known;
  for (const robot::Arm& arm : robot.arms) known.push_back(arm.name);
  if (options_.arms.empty()) options_.arms.assign(known.begin(), known.end());
  for (const std::string& name : options_.arms) {
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) {
      throw std::invalid_argument("arm is " + Quoted(name) + ", expected " + OneOf(known));
    }
    const int index = static_cast<int>(found - known.begin());
    const robot::Arm& arm = robot.arms[static_cast<std::size_t>(index)];
    ControlledArm controlled{
        .index = index,
        .name = name,
        .kinematics = motion::ArmKinematics(robot, arm, model_->robot_base_pose()),
        .has_gripper = arm.gripper.has_value(),
        .first = names_.size()};
    if (arm.gripper) {
      const double speed = robot::OpeningRangeOf(robot, *arm.gripper).max_speed;
      controlled.opening_speed = speed > 0 ? speed : kOpeningSpeed;
    }
    for (const std::string& number : NumbersOf(controlled)) names_.push_back(name + "." + number);
    controlled.gripper = names_.size();
    if (arm.gripper) names_.push_back(name + ".gripper");
    arms_.push_back(std::move(controlled));
  }
}

std::vector<int> Control::arms() const {
  std::vector<int> indices;
  for (const ControlledArm& arm : arms_) indices.push_back(arm.index);
  return indices;
}

std::vector<std::string> Control::NumbersOf(const ControlledArm& arm) const {
  switch (options_.kind) {
    case ControlKind::kEndEffector:
      return {"x", "y", "z", "rotation_x", "rotation_y", "rotation_z"};
    case ControlKind::kWaypoints:
      return {"x", "y", "z", "yaw"};
    case ControlKind::kJointVelocities:
    case ControlKind::kJointPositions:
      break;
  }
  return arm.kinematics.joint_names();
}

std::optional<std::string> Control::Perform(std::span<const double> action,
                                            sim::Simulation* simulation) const {
  if (action.size() != names_.size()) {
    throw std::invalid_argument("action has " + std::to_string(action.size()) +
                                " numbers, expected " + std::to_string(names_.size()));
  }
  std::vector<double> numbers(action.begin(), action.end());
  for (double& number : numbers) {
    if (!std::isfinite(number)) {
      throw std::invalid_argument("action has a number that is not finite, expected -1 to 1");
    }
    number = std::clamp(number, -1.0, 1.0);
  }
  if (options_.kind == ControlKind::kWaypoints) return MoveToWaypoints(numbers, simulation);

  std::vector<RigidTransform> starts;
  for (const ControlledArm& arm : arms_) starts.push_back(simulation->robot()->ToolPose(arm.index));
  for (int tick = 0; tick < options_.ticks; ++tick) {
    sim::JointVelocities command;
    if (tick == 0) command.grippers = GripperRates(numbers, /*keeps_still=*/true);
    for (std::size_t i = 0; i < arms_.size(); ++i) {
      const ControlledArm& arm = arms_[i];
      const auto its = std::span<const double>(numbers).subspan(arm.first, arm.gripper - arm.first);
      command.arms[arm.name] =
          VelocitiesFor(arm, its, *simulation->robot(), starts[i], options_.ticks - tick);
    }
    // Velocities stay in effect until the next command.
    const bool is_constant = options_.kind == ControlKind::kJointVelocities;
    if (tick == 0 || !is_constant) {
      if (auto refusal = simulation->Apply(command)) return refusal;
    }
    simulation->Tick();
  }
  return std::nullopt;
}

sim::ByArm<double> Control::GripperRates(std::span<const double> action, bool keeps_still) const {
  sim::ByArm<double> rates;
  for (const ControlledArm& arm : arms_) {
    if (!arm.has_gripper) continue;
    const double number = action[arm.gripper];
    const bool is_still = std::abs(number) < kGripperRest;
    if (is_still && !keeps_still) continue;
    rates[arm.name] = is_still ? 0 : number * arm.opening_speed;
  }
  return rates;
}

std::vector<double> Control::VelocitiesFor(const ControlledArm& arm,
                                           std::span<const double> numbers,
                                           const world::RobotBody& robot,
                                           const RigidTransform& X_WG_start, int ticks_left) const {
  if (options_.kind == ControlKind::kJointPositions) {
    return TowardsPositions(arm, numbers, robot, ticks_left);
  }
  if (options_.kind == ControlKind::kEndEffector) {
    const Vector3 rotation = options_.rotation * Vector3(numbers[3], numbers[4], numbers[5]);
    const double angle = rotation.norm();
    const Matrix3 R =
        angle > 0 ? Matrix3(Eigen::AngleAxisd(angle, rotation / angle)) : Matrix3::Identity();
    const Vector3 shift = options_.displacement * Vector3(numbers[0], numbers[1], numbers[2]);
    return TowardsPose(arm, {Matrix3(R * X_WG_start.rotation()), X_WG_start.translation() + shift},
                       robot, ticks_left);
  }
  const std::vector<motion::JointLimits>& limits = arm.kinematics.limits();
  std::vector<double> velocities;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    velocities.push_back(numbers[i] * options_.speed * limits[i].max_velocity);
  }
  return velocities;
}

std::vector<double> Control::TowardsPositions(const ControlledArm& arm,
                                              std::span<const double> numbers,
                                              const world::RobotBody& robot, int ticks_left) const {
  const std::vector<motion::JointLimits>& limits = arm.kinematics.limits();
  const std::vector<double> q = robot.ArmAngles(arm.index);
  std::vector<double> velocities;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    // Joints without limits turn once around at most.
    const double low = std::max(limits[i].lower, -std::numbers::pi);
    const double high = std::min(limits[i].upper, std::numbers::pi);
    const double goal = limits[i].slides ? Between(limits[i].lower, limits[i].upper, numbers[i])
                                         : Between(low, high, numbers[i]);
    const double most = options_.speed * limits[i].max_velocity;
    velocities.push_back(std::clamp((goal - q[i]) / (ticks_left * kTickSeconds), -most, most));
  }
  return velocities;
}

std::vector<double> Control::TowardsPose(const ControlledArm& arm, const RigidTransform& X_WG_goal,
                                         const world::RobotBody& robot, int ticks_left) const {
  motion::ArmJacobian J;
  const RigidTransform X_WG = arm.kinematics.ToolPose(robot.ArmAngles(arm.index), &J);
  Eigen::Matrix<double, 6, 1> twist;
  twist << X_WG_goal.translation() - X_WG.translation(),
      RotationVectorBetween(X_WG.quaternion(), X_WG_goal.quaternion());
  // Damped least squares, as for inverse kinematics: see SolveInverseKinematics().
  const Eigen::Matrix<double, 6, 6> damped =
      J * J.transpose() + kDamping * kDamping * Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::VectorXd v =
      J.transpose() * damped.ldlt().solve(twist) / (ticks_left * kTickSeconds);
  std::vector<double> velocities(v.begin(), v.end());
  LimitSpeeds(arm.kinematics.limits(), options_.speed, &velocities);
  return velocities;
}

std::optional<std::string> Control::MoveToWaypoints(std::span<const double> action,
                                                    sim::Simulation* simulation) const {
  std::optional<std::string> refusal;
  for (const ControlledArm& arm : arms_) {
    auto reason =
        StartToWaypoint(arm, action.subspan(arm.first, arm.gripper - arm.first), simulation);
    if (reason && !refusal) refusal = std::move(reason);
  }
  // Out of reach, an action takes as long as others.
  int ticks = 0;
  do {
    simulation->Tick();
    ++ticks;
  } while ((simulation->is_robot_following() && ticks < kMaxWaypointTicks) ||
           ticks < options_.ticks);
  sim::JointVelocities grippers{.grippers = GripperRates(action, /*keeps_still=*/false)};
  if (grippers.grippers.empty()) return refusal;
  if (auto reason = simulation->Apply(grippers); reason && !refusal) refusal = std::move(reason);
  for (int i = 0; i < kGripperTicks; ++i) simulation->Tick();
  return refusal;
}

std::optional<std::string> Control::StartToWaypoint(const ControlledArm& arm,
                                                    std::span<const double> numbers,
                                                    sim::Simulation* simulation) const {
  const std::vector<motion::JointLimits>& limits = arm.kinematics.limits();
  std::vector<double> q = simulation->robot()->ArmAngles(arm.index);
  for (std::size_t i = 0; i < q.size(); ++i) {
    q[i] = std::clamp(q[i], limits[i].lower, limits[i].upper);
  }
  Vector3 place;
  for (int i = 0; i < 3; ++i) {
    place[i] =
        Between(options_.lowest[i], options_.highest[i], numbers[static_cast<std::size_t>(i)]);
  }
  const Matrix3 R = (Eigen::AngleAxisd(numbers[3] * std::numbers::pi, Vector3::UnitZ()) *
                     Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitX()))
                        .toRotationMatrix();
  motion::IkOptions options;
  options.max_iterations = kMaxIterations;
  options.any_rotation = limits.size() < 6;  // such arms cannot take every rotation
  const auto goal = motion::SolveInverseKinematics(arm.kinematics, {R, place}, q, options);
  if (!goal) return "the waypoint is out of reach of the arm " + Quoted(arm.name);
  const std::vector<std::vector<double>> path{q, *goal};
  return simulation->Apply(sim::FollowTrajectory{
      .trajectory = {.joint_names = arm.kinematics.joint_names(),
                     .points = motion::MoveThrough(path, limits, options_.speed)}});
}

}  // namespace smile::python
