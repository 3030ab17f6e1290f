// Converts between the units, names and matrices of programs and the meters, indices and transforms
// of the room; the algorithms are in the other files.

#include "motion/planning_robot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/wording.h"
#include "motion/internal_probe_store.h"
#include "robot/urdf_reader.h"
#include "scene/bounds.h"
#include "scene/units.h"

namespace smile::motion {
namespace {

constexpr std::string_view kBoth = "both";

/// Thickness of the table: the maximum for tables of scenes [m].
constexpr double kTableThickness = 0.4;
/// Tolerance of rotation matrices: enough for numbers written with three digits.
constexpr double kLooseRotation = 1e-3;

/// Returns a valid unit.
/// @throws std::invalid_argument unless it is positive and finite.
double CheckedUnit(double meters_per_unit) {
  if (meters_per_unit > 0 && std::isfinite(meters_per_unit)) return meters_per_unit;
  throw std::invalid_argument("unit is " + NumberText(meters_per_unit) +
                              ", expected metres per unit, above 0");
}

/// Returns a table in meters, its top at z = 0.
scene::Solid TableOf(double width, double depth, double meters_per_unit) {
  const auto is_size = [](double x) { return x > 0 && std::isfinite(x); };
  if (!is_size(width) || !is_size(depth)) {
    throw std::invalid_argument("table is " + NumberText(width) + " x " + NumberText(depth) +
                                ", expected width and depth above 0");
  }
  return {.shape = scene::Block{{scene::FromFileUnits(width, meters_per_unit),
                                 scene::FromFileUnits(depth, meters_per_unit), kTableThickness}},
          .X_BS = RigidTransform(Vector3(0, 0, -kTableThickness / 2))};
}

}  // namespace

PlanningRobot::PlanningRobot(robot::RobotModel model, const Eigen::Matrix4d& base_pose,
                             double meters_per_unit)
    : model_(std::move(model)),
      meters_per_unit_(CheckedUnit(meters_per_unit)),
      probes_(std::make_shared<ProbeStore>()) {
  X_WBase_ = FromUnits(base_pose, "base");
  for (const robot::Arm& arm : model_.arms) arms_.emplace_back(model_, arm, X_WBase_);
}

const ArmKinematics& PlanningRobot::Find(std::string_view arm) const {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < model_.arms.size(); ++i) {
    if (model_.arms[i].name == arm) return arms_[i];
    names.push_back(model_.arms[i].name);
  }
  throw std::invalid_argument("arm is " + Quoted(arm) + ", expected " +
                              (names.empty() ? "none: the robot has no arms" : OneOf(names)));
}

RigidTransform PlanningRobot::FromUnits(const Eigen::Matrix4d& pose, const char* what) const {
  // An exact comparison for the last row: it is typed as integers, never computed.
  const Matrix3 R = pose.topLeftCorner<3, 3>();
  const bool is_pose =
      pose.allFinite() && pose.row(3) == Eigen::RowVector4d(0, 0, 0, 1) &&
      (R * R.transpose() - Matrix3::Identity()).cwiseAbs().maxCoeff() < kLooseRotation &&
      R.determinant() > 0;
  if (!is_pose) {
    throw std::invalid_argument(
        std::string(what) +
        " is not a pose, expected 4x4 with a rotation, a position and a last row 0 0 0 1");
  }
  // A conversion to a quaternion and back gives the exact rotation near the caller's rounded
  // matrix.
  return {Quaternion(R).normalized(),
          scene::FromFileUnits(Vector3(pose.topRightCorner<3, 1>()), meters_per_unit_)};
}

Eigen::Matrix4d PlanningRobot::InUnits(const RigidTransform& X_WF) const {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  pose.topLeftCorner<3, 3>() = X_WF.rotation();
  pose.topRightCorner<3, 1>() = scene::ToFileUnits(X_WF.translation(), meters_per_unit_);
  return pose;
}

std::vector<std::string> PlanningRobot::ArmNames() const {
  std::vector<std::string> names;
  for (const robot::Arm& arm : model_.arms) names.push_back(arm.name);
  return names;
}

std::vector<std::string> PlanningRobot::JointNames(std::string_view arm) const {
  if (arm != kBoth) return Find(arm).joint_names();
  std::vector<std::string> names;
  for (const ArmKinematics& each : arms_) {
    names.insert(names.end(), each.joint_names().begin(), each.joint_names().end());
  }
  return names;
}

std::vector<JointLimits> PlanningRobot::Limits(std::string_view arm) const {
  if (arm != kBoth) return Find(arm).limits();
  std::vector<JointLimits> limits;
  for (const ArmKinematics& each : arms_) {
    limits.insert(limits.end(), each.limits().begin(), each.limits().end());
  }
  return limits;
}

int PlanningRobot::NumRows(std::string_view arm) const {
  if (arm != kBoth) return 1;
  // Rows of a matrix must have equal lengths.
  const bool are_alike = std::ranges::all_of(
      arms_, [&](const ArmKinematics& each) { return each.num_joints() == arms_[0].num_joints(); });
  return are_alike && !arms_.empty() ? static_cast<int>(arms_.size()) : 1;
}

std::optional<std::vector<double>> PlanningRobot::NamedPose(std::string_view arm,
                                                            std::string_view name) const {
  const robot::NamedPose* pose = robot::FindPose(model_, name);
  if (!pose) return std::nullopt;
  std::vector<double> q;
  // A named pose covers all joints of the robot; here are those of the arm, in the order of q.
  for (const std::string& joint : JointNames(arm)) {
    q.push_back(pose->q[robot::FindJoint(model_, joint).value()]);
  }
  return q;
}

const robot::Gripper& PlanningRobot::FindGripper(std::string_view arm, double opening) const {
  Find(arm);
  if (!std::isfinite(opening)) throw std::invalid_argument("opening is not finite");
  const auto& gripper = robot::FindArm(model_, arm)->gripper;
  if (!gripper) throw std::invalid_argument("the arm " + Quoted(arm) + " has no gripper");
  return *gripper;
}

double PlanningRobot::GripperMiddle(std::string_view arm, double opening) const {
  const robot::Gripper& gripper = FindGripper(arm, opening);
  return scene::ToFileUnits(
      robot::MiddleAt(model_, gripper, scene::FromFileUnits(opening, meters_per_unit_)),
      meters_per_unit_);
}

Eigen::Matrix<double, 2, 3> PlanningRobot::FingerBounds(std::string_view arm,
                                                        double opening) const {
  const robot::Gripper& gripper = FindGripper(arm, opening);
  std::vector<double> q = model_.q_start;
  robot::SetOpening(model_, gripper, scene::FromFileUnits(opening, meters_per_unit_), q);
  const std::vector<RigidTransform> X_BaseL = scene::LinkPoses(model_.links, RigidTransform(), q);
  const robot::Frame& tool = model_.frames[robot::FindArm(model_, arm)->tool];
  const RigidTransform X_BaseG = tool.link < 0 ? tool.X_LF : X_BaseL[tool.link] * tool.X_LF;
  scene::Bounds bounds;
  for (const int joint : robot::JointsOf(model_, gripper)) {
    bounds.Add(scene::BoundsOf(model_.links[joint].solids, X_BaseG.inverse() * X_BaseL[joint]));
  }
  if (bounds.is_empty()) {
    throw std::invalid_argument("the gripper of the arm " + Quoted(arm) + " has no fingers");
  }
  Eigen::Matrix<double, 2, 3> box;
  box << scene::ToFileUnits(bounds.low, meters_per_unit_).transpose(),
      scene::ToFileUnits(bounds.high, meters_per_unit_).transpose();
  return box;
}

Eigen::Matrix4d PlanningRobot::Forward(std::string_view arm, std::span<const double> q) const {
  const ArmKinematics& kinematics = Find(arm);
  if (!std::ranges::all_of(q, [](double x) { return std::isfinite(x); })) {
    throw std::invalid_argument("q is not finite");
  }
  return InUnits(kinematics.ToolPose(q));
}

Eigen::MatrixXd PlanningRobot::Jacobian(std::string_view arm, std::span<const double> q) const {
  ArmJacobian J;
  Find(arm).ToolPose(q, &J);
  // Linear rows are in meters per second; angular rows have no length.
  J.topRows<3>() /= meters_per_unit_;
  if (!J.allFinite()) throw std::invalid_argument("q is not finite");
  return J;
}

std::optional<std::vector<double>> PlanningRobot::Inverse(std::string_view arm,
                                                          const Eigen::Matrix4d& goal,
                                                          std::span<const double> q_start,
                                                          IkOptions options) const {
  options.position_tolerance *= meters_per_unit_;
  return SolveInverseKinematics(Find(arm), FromUnits(goal, "goal"), q_start, options);
}

std::string PlanningRobot::WhyUnreachable(std::string_view arm, const Eigen::Matrix4d& goal,
                                          std::span<const double> q_start,
                                          IkOptions options) const {
  options.position_tolerance *= meters_per_unit_;
  return motion::WhyUnreachable(Find(arm), FromUnits(goal, "goal"), q_start, options);
}

JointTrajectory PlanningRobot::MoveJoints(std::string_view arm,
                                          std::span<const std::vector<double>> waypoints,
                                          double speed) const {
  return {JointNames(arm), MoveThrough(waypoints, Limits(arm), speed)};
}

std::variant<JointTrajectory, LineFault> PlanningRobot::MoveLine(std::string_view arm,
                                                                 std::span<const double> q_from,
                                                                 const Eigen::Matrix4d& goal,
                                                                 LineOptions options) const {
  options.tool_speed *= meters_per_unit_;
  return MoveAlongLine(Find(arm), q_from, FromUnits(goal, "goal"), options);
}

std::size_t PlanningRobot::ArmOf(const JointTrajectory& trajectory) const {
  for (std::size_t i = 0; i < arms_.size(); ++i) {
    if (arms_[i].joint_names() == trajectory.joint_names) return i;
  }
  throw std::invalid_argument("the trajectory moves " +
                              std::to_string(trajectory.joint_names.size()) +
                              " joints, expected those of the arm that holds something");
}

scene::ArticulationSpec PlanningRobot::Holding(const HeldBox& held, const robot::Arm& arm) const {
  const Vector3 size = held.upper - held.lower;
  if (!size.allFinite() || !held.lower.allFinite() || !(size.array() > 0).all()) {
    throw std::invalid_argument("the size of what is held is " + NumberText(size.x()) + " x " +
                                NumberText(size.y()) + " x " + NumberText(size.z()) +
                                ", expected three lengths above 0");
  }
  const robot::Frame& tool = model_.frames[arm.tool];
  const Vector3 p_GB = (held.lower + held.upper) / 2 * meters_per_unit_;
  scene::ArticulationSpec spec = robot::MakeArticulationSpec(model_, X_WBase_);
  std::vector<scene::Solid>& solids =
      tool.link < 0 ? spec.base_solids : spec.links[tool.link].solids;
  solids.push_back(
      {.shape = scene::Block{size * meters_per_unit_}, .X_BS = tool.X_LF * RigidTransform(p_GB)});
  // It is between the sides of the gripper, which the hand does not touch by itself.
  if (arm.gripper) {
    for (const int joint : robot::JointsOf(model_, *arm.gripper)) {
      if (joint != tool.link) spec.never_collide.push_back(std::minmax(tool.link, joint));
    }
  }
  return spec;
}

std::optional<InvalidMoment> PlanningRobot::FirstInvalid(
    const JointTrajectory& trajectory, std::span<const double> q_both,
    std::optional<std::pair<double, double>> table, const std::optional<HeldBox>& held) const {
  // Joints outside the arms, such as the head and the fingers, stay at the start.
  std::vector<double> q = model_.q_start;
  if (!q_both.empty()) {
    const std::vector<std::string> names = JointNames(kBoth);
    if (q_both.size() != names.size()) {
      throw std::invalid_argument("q_both has " + std::to_string(q_both.size()) +
                                  " values, expected " + std::to_string(names.size()));
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      q[robot::FindJoint(model_, names[i]).value()] = q_both[i];
    }
  }
  const ProbeStore::Setting setting{table, held, held ? ArmOf(trajectory) : 0};
  std::unique_ptr<ArticulationProbe> probe = probes_->Take(setting);
  if (!probe) {
    std::vector<scene::Solid> environment;
    if (table) environment.push_back(TableOf(table->first, table->second, meters_per_unit_));
    probe =
        std::make_unique<ArticulationProbe>(held ? Holding(*held, model_.arms[setting.arm])
                                                 : robot::MakeArticulationSpec(model_, X_WBase_),
                                            environment);
  }
  auto moment = motion::FirstInvalid(model_, trajectory, q, probe.get());
  probes_->GiveBack(setting, std::move(probe));
  return moment;
}

PlanningRobot ReadPlanningRobot(const std::filesystem::path& urdf, const Eigen::Matrix4d& base_pose,
                                double meters_per_unit, const std::string& gripper) {
  return {robot::ReadRobot(urdf, {.gripper = gripper, .has_appearance = false}), base_pose,
          meters_per_unit};
}

}  // namespace smile::motion
