#include "robot/kinematics.h"

#include <stdexcept>
#include <string>

// Forward kinematics and Jacobians on the tree of links. Poses are in the world W or in the robot's
// base; each link L turns or slides relative to its joint frame J, which is fixed in its parent.

namespace smile::robot {
namespace {

using scene::JointType;
using scene::LinkSpec;

void CheckSize(const RobotModel& model, std::span<const double> q) {
  if (q.size() == model.links.size()) return;
  throw std::invalid_argument("q has " + std::to_string(q.size()) +
                              " values, expected one for each of the " +
                              std::to_string(model.links.size()) + " joints of " + model.name);
}

const Frame& CheckedFrame(const RobotModel& model, int frame) {
  if (frame < 0 || frame >= static_cast<int>(model.frames.size())) {
    throw std::invalid_argument("frame is " + std::to_string(frame) + ", expected 0 to " +
                                std::to_string(static_cast<int>(model.frames.size()) - 1));
  }
  return model.frames[frame];
}

void CheckJoints(const RobotModel& model, std::span<const int> joints) {
  for (int joint : joints) {
    if (joint >= 0 && joint < model.num_joints()) continue;
    throw std::invalid_argument("joint is " + std::to_string(joint) + ", expected 0 to " +
                                std::to_string(model.num_joints() - 1));
  }
}

/// Returns X_WF for links at `X_WL`.
RigidTransform PoseOf(const Frame& F, const RigidTransform& X_WBase,
                      const std::vector<RigidTransform>& X_WL) {
  return (F.link < 0 ? X_WBase : X_WL[F.link]) * F.X_LF;
}

}  // namespace

std::vector<RigidTransform> LinkPoses(const RobotModel& model, const RigidTransform& X_WBase,
                                      std::span<const double> q) {
  CheckSize(model, q);
  return scene::LinkPoses(model.links, X_WBase, q);
}

RigidTransform FramePose(const RobotModel& model, const RigidTransform& X_WBase,
                         std::span<const double> q, int frame) {
  return PoseOf(CheckedFrame(model, frame), X_WBase, LinkPoses(model, X_WBase, q));
}

Eigen::MatrixXd GeometricJacobian(const RobotModel& model, std::span<const double> q, int frame,
                                  std::span<const int> joints) {
  CheckJoints(model, joints);
  const Frame& F = CheckedFrame(model, frame);
  const std::vector<RigidTransform> X_BaseL = LinkPoses(model, {}, q);
  const Vector3 p_BaseF = PoseOf(F, {}, X_BaseL).translation();

  // Rows: velocity of the frame's origin, then angular velocity, both in base coordinates. Joints
  // that do not carry the frame have zero columns.
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(6, static_cast<Eigen::Index>(joints.size()));
  // From the frame's link down to the base: only these joints carry it.
  for (int carrier = F.link; carrier >= 0; carrier = model.links[carrier].parent) {
    const LinkSpec& link = model.links[carrier];
    // A joint's motion does not move its own axis, so it can be taken from L instead of J.
    const Vector3 axis_Base = X_BaseL[carrier].rotation() * link.axis;
    Eigen::Matrix<double, 6, 1> column;
    if (link.joint_type == JointType::kRevolute) {
      // A turning joint moves the point by omega x r.
      column << axis_Base.cross(p_BaseF - X_BaseL[carrier].translation()), axis_Base;
    } else {
      column << axis_Base, Vector3::Zero();
    }
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (joints[j] == carrier) J.col(static_cast<Eigen::Index>(j)) = column;
    }
  }
  return J;
}

}  // namespace smile::robot
