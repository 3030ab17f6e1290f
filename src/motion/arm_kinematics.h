#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "motion/joint_trajectory.h"
#include "robot/robot_model.h"

namespace smile::motion {

/// Geometric Jacobian, 6 x number of joints, in fixed storage: rows 0..2 linear [m/s per unit of
/// rate], rows 3..5 angular, both along the axes of the world.
using ArmJacobian =
    Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, robot::kMaxArmJoints>;

/// Forward kinematics of one arm and its tool G: equal to robot::FramePose() up to rounding, in a
/// hundredth of the time, since only links that carry the tool are computed.
class ArmKinematics {
 public:
  /// @param X_WBase   pose of the robot's base.
  /// @param q_others  one value per joint of the robot; used for joints that carry the arm but are
  /// not
  ///                  part of it [rad or m].
  /// @throws std::invalid_argument if the arm has no joints, more than robot::kMaxArmJoints, or one
  /// that
  ///         does not carry its tool; or if `q_others` has the wrong size.
  ArmKinematics(const robot::RobotModel& model, const robot::Arm& arm,
                const RigidTransform& X_WBase, std::span<const double> q_others);
  /// With all other joints at their start positions.
  ArmKinematics(const robot::RobotModel& model, const robot::Arm& arm,
                const RigidTransform& X_WBase = {})
      : ArmKinematics(model, arm, X_WBase, model.q_start) {}

  int num_joints() const { return static_cast<int>(limits_.size()); }
  const std::vector<JointLimits>& limits() const { return limits_; }
  const std::vector<std::string>& joint_names() const { return joint_names_; }

  /// Returns the pose of the tool, X_WG.
  /// @param q  one value per joint of the arm [rad or m]; limits are not checked.
  /// @throws std::invalid_argument if `q` has the wrong size, as do the others.
  RigidTransform ToolPose(std::span<const double> q) const;

  /// Returns X_WG and stores the Jacobian of the tool in `J`.
  RigidTransform ToolPose(std::span<const double> q, ArmJacobian* J) const;

 private:
  /// A joint of the arm. It moves about or along the z axis of its own frame.
  struct Step {
    RigidTransform X_BeforeJoint;  ///< joint frame in the frame that the previous step moves
    int column = 0;                ///< index of its value in q
    bool turns = true;
  };

  void CheckSize(std::span<const double> q) const;

  std::vector<Step> steps_;    ///< from the base to the tool
  RigidTransform X_LastTool_;  ///< tool in the frame that the last step moves
  std::vector<JointLimits> limits_;
  std::vector<std::string> joint_names_;
};

}  // namespace smile::motion
