// The chain from the base to the tool, prepared once for many evaluations: joints that are not part
// of the arm are fixed at their positions and folded into constant transforms, and each axis is
// laid along z. What remains per joint is one constant transform and a rotation of two columns.

#include "motion/arm_kinematics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "math/angles.h"

namespace smile::motion {
namespace {

using scene::JointType;
using scene::LinkSpec;

/// Returns the links that carry a frame, from the base outwards.
std::vector<int> CarriersOf(const robot::RobotModel& model, const robot::Frame& F) {
  std::vector<int> carriers;
  for (int link = F.link; link >= 0; link = model.links[link].parent) carriers.push_back(link);
  std::ranges::reverse(carriers);
  return carriers;
}

/// Returns a frame at the same origin whose z axis is `axis`.
RigidTransform TurnedTowards(const Vector3& axis) {
  return {SmallestRotation(Vector3::UnitZ(), axis), Vector3::Zero()};
}

/// Returns the transform that a joint's motion by q adds.
RigidTransform MotionOf(const LinkSpec& link, double q) {
  if (link.joint_type == JointType::kPrismatic) return RigidTransform(Vector3(link.axis * q));
  return {Eigen::AngleAxisd(q, link.axis).toRotationMatrix(), Vector3::Zero()};
}

void CheckArm(const robot::RobotModel& model, const robot::Arm& arm,
              std::span<const double> q_others) {
  if (arm.joints.empty() || arm.joints.size() > robot::kMaxArmJoints) {
    throw std::invalid_argument("arm " + arm.name + " has " + std::to_string(arm.joints.size()) +
                                " joints, expected 1 to " + std::to_string(robot::kMaxArmJoints));
  }
  if (arm.tool < 0 || arm.tool >= static_cast<int>(model.frames.size())) {
    throw std::invalid_argument("arm " + arm.name + " has no tool");
  }
  if (q_others.size() != model.links.size()) {
    throw std::invalid_argument("q_others has " + std::to_string(q_others.size()) +
                                " values, expected " + std::to_string(model.links.size()));
  }
}

}  // namespace

ArmKinematics::ArmKinematics(const robot::RobotModel& model, const robot::Arm& arm,
                             const RigidTransform& X_WBase, std::span<const double> q_others) {
  CheckArm(model, arm, q_others);
  limits_ = LimitsOf(model, arm.joints);
  for (const int joint : arm.joints) joint_names_.push_back(model.links[joint].joint_name);

  const robot::Frame& tool = model.frames[arm.tool];
  // pose of the next joint or tool in the frame that the last step moves
  RigidTransform X = X_WBase;
  for (const int carrier : CarriersOf(model, tool)) {
    const LinkSpec& link = model.links[carrier];
    const auto joint = std::ranges::find(arm.joints, carrier);
    if (joint == arm.joints.end()) {
      // A fixed joint, or one outside the arm such as that of a torso.
      X = X * link.X_PJ * MotionOf(link, q_others[carrier]);
      continue;
    }
    // Put the joint axis along z, so that ToolPose() only rotates columns x and y or moves along z.
    // Joints that do not move are folded into the transform of the next step.
    const RigidTransform X_JZ = TurnedTowards(link.axis);
    steps_.push_back({X * link.X_PJ * X_JZ, static_cast<int>(joint - arm.joints.begin()),
                      link.joint_type == JointType::kRevolute});
    X = X_JZ.inverse();
  }
  X_LastTool_ = X * tool.X_LF;
  // A joint of the arm that does not carry the tool would have an all-zero column in each Jacobian,
  // and the inverse kinematics would never move it.
  if (steps_.size() != arm.joints.size()) {
    throw std::invalid_argument("arm " + arm.name + " has joints that do not move its tool");
  }
}

void ArmKinematics::CheckSize(std::span<const double> q) const {
  if (q.size() == limits_.size()) return;
  throw std::invalid_argument("q has " + std::to_string(q.size()) + " values, expected " +
                              std::to_string(limits_.size()));
}

RigidTransform ArmKinematics::ToolPose(std::span<const double> q) const {
  return ToolPose(q, nullptr);
}

RigidTransform ArmKinematics::ToolPose(std::span<const double> q, ArmJacobian* J) const {
  CheckSize(q);
  // R and p are the pose of the present frame in the world.
  Matrix3 R = Matrix3::Identity();
  Vector3 p = Vector3::Zero();
  if (J) J->resize(6, num_joints());
  for (const Step& step : steps_) {
    p += R * step.X_BeforeJoint.translation();
    R = Matrix3(R * step.X_BeforeJoint.rotation());
    // Axis and origin of the joint in the world. The column temporarily holds both: six numbers are
    // what the second loop needs.
    const Vector3 axis = R.col(2);
    if (J) J->col(step.column) << p, axis;  // completed below, when the tool's place is known
    if (step.turns) {
      const double c = std::cos(q[step.column]), s = std::sin(q[step.column]);
      const Vector3 x = R.col(0);
      R.col(0) = c * x + s * R.col(1);
      R.col(1) = c * R.col(1) - s * x;
    } else {
      p += q[step.column] * axis;
    }
  }
  p += R * X_LastTool_.translation();
  R = Matrix3(R * X_LastTool_.rotation());
  if (J) {
    for (const Step& step : steps_) {
      // A revolute joint moves the tool by axis x lever, a prismatic one along its axis.
      auto column = J->col(step.column);
      const Vector3 origin = column.head<3>(), axis = column.tail<3>();
      if (step.turns) {
        column.head<3>() = axis.cross(p - origin);
      } else {
        column << axis, Vector3::Zero();
      }
    }
  }
  return {R, p};
}

}  // namespace smile::motion
