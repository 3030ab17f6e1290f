#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "motion/joint_trajectory.h"
#include "robot/robot_model.h"

namespace smile::motion {

inline constexpr int kMaxArmJoints = 16;

/// 6 x number of joints, without memory of its own: rows 0..2 linear [m/s per unit of rate], rows
/// 3..5 angular, both along the axes of the world.
using ArmJacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, kMaxArmJoints>;

/// Where the joints of one arm bring its tool G: the same as robot::FramePose() says, up to
/// rounding, in a hundredth of the time, because only what carries the tool is looked at.
class ArmKinematics {
 public:
  /// @param X_WBase   where the robot stands.
  /// @param q_others  one value per joint of the robot; where those stand that are no part of the
  ///                  arm but carry it.
  /// @throws std::invalid_argument if the arm has no joints, more than kMaxArmJoints, or one that
  ///         does not carry its tool; or if `q_others` has the wrong size.
  ArmKinematics(const robot::RobotModel& model, const robot::Arm& arm,
                const RigidTransform& X_WBase, std::span<const double> q_others);
  /// With all other joints where the model starts.
  ArmKinematics(const robot::RobotModel& model, const robot::Arm& arm,
                const RigidTransform& X_WBase = {})
      : ArmKinematics(model, arm, X_WBase, model.q_start) {}

  int num_joints() const { return static_cast<int>(limits_.size()); }
  const std::vector<JointLimits>& limits() const { return limits_; }
  const std::vector<std::string>& joint_names() const { return joint_names_; }

  /// X_WG.
  /// @param q  one value per joint of the arm [rad or m]; limits are not asked for.
  /// @throws std::invalid_argument if `q` has the wrong size, as do the others.
  RigidTransform ToolPose(std::span<const double> q) const;

  /// X_WG and how the tool moves with each joint.
  RigidTransform ToolPose(std::span<const double> q, ArmJacobian* J) const;

 private:
  /// A joint of the arm. It moves about or along the z axis of its own frame.
  struct Step {
    RigidTransform X_BeforeJoint;  ///< in the frame that the step before moves
    int column = 0;                ///< which value of q moves it
    bool turns = true;
  };

  void CheckSize(std::span<const double> q) const;

  std::vector<Step> steps_;    ///< from the base to the tool
  RigidTransform X_LastTool_;  ///< in the frame that the last step moves
  std::vector<JointLimits> limits_;
  std::vector<std::string> joint_names_;
};

}  // namespace smile::motion
