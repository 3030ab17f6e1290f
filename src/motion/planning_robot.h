#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "motion/arm_moves.h"
#include "motion/held_box.h"
#include "motion/inverse_kinematics.h"
#include "motion/path_check.h"

namespace smile::motion {

class ProbeStore;

/// A robot for planning programs in any language: it stands in the world of a scene, and all
/// lengths are in the scene's unit. The C++, Python and Octave interfaces all use this class, so
/// the same question has the same answer, to the last bit.
///
/// Arms are given by name. Where `both` is allowed, it means all arms, however many the robot has;
/// their joints follow one another, in the order of the model. Poses are homogeneous 4 x 4 matrices
/// X_WG [units]; a rotation that is exact to 1e-3 is normalized. All functions throw
/// std::invalid_argument, naming what was found and expected, if an arm is unknown or a value has
/// the wrong size or is not finite.
class PlanningRobot {
 public:
  /// @param base_pose        4 x 4, pose of the base in the world [units].
  /// @param meters_per_unit  > 0.
  PlanningRobot(robot::RobotModel model, const Eigen::Matrix4d& base_pose, double meters_per_unit);

  const robot::RobotModel& model() const { return model_; }
  double meters_per_unit() const { return meters_per_unit_; }

  /// Returns the names of the arms.
  std::vector<std::string> ArmNames() const;
  /// Return names and limits of an arm's joints, or of all arms' (`both`).
  std::vector<std::string> JointNames(std::string_view arm) const;
  std::vector<JointLimits> Limits(std::string_view arm) const;
  /// Returns the number of rows of a configuration as people write it: 1 for an arm; for `both` one
  /// per arm, if all have as many joints, otherwise 1.
  int NumRows(std::string_view arm) const;
  /// Returns a named pose of the robot; nullopt if it has no such pose.
  std::optional<std::vector<double>> NamedPose(std::string_view arm, std::string_view name) const;

  /// Returns the place of the middle between both sides of the gripper at an opening, along y of
  /// the tool [units]: 0 for fingers that slide apart, but not where one jaw is fixed.
  /// @throws std::invalid_argument  also if the arm has no gripper.
  double GripperMiddle(std::string_view arm, double opening) const;

  /// Returns the box around what moves when the gripper opens, such as its two fingers, at an
  /// opening: the least and the greatest x y z in the frame of the tool [units], rows of 2 x 3.
  /// @throws std::invalid_argument  also if the arm has no gripper, or one of which nothing moves.
  Eigen::Matrix<double, 2, 3> FingerBounds(std::string_view arm, double opening) const;

  /// Returns the pose of the tool.
  Eigen::Matrix4d Forward(std::string_view arm, std::span<const double> q) const;
  /// Returns the Jacobian, 6 x joints: rows 0..2 [units/s per rad/s], rows 3..5 angular; along the
  /// world's axes.
  Eigen::MatrixXd Jacobian(std::string_view arm, std::span<const double> q) const;

  /// See SolveInverseKinematics().
  /// @param options  its position_tolerance in units.
  std::optional<std::vector<double>> Inverse(std::string_view arm, const Eigen::Matrix4d& goal,
                                             std::span<const double> q_start,
                                             IkOptions options = {}) const;

  /// Returns why Inverse() finds nothing, for people; see motion::WhyUnreachable().
  std::string WhyUnreachable(std::string_view arm, const Eigen::Matrix4d& goal,
                             std::span<const double> q_start, IkOptions options = {}) const;

  /// See MoveThrough(); `arm` may be `both`.
  JointTrajectory MoveJoints(std::string_view arm, std::span<const std::vector<double>> waypoints,
                             double speed = 1) const;
  /// See MoveAlongLine().
  /// @param options  its tool_speed in units/s.
  std::variant<JointTrajectory, LineFault> MoveLine(std::string_view arm,
                                                    std::span<const double> q_from,
                                                    const Eigen::Matrix4d& goal,
                                                    LineOptions options = {}) const;

  /// See motion::FirstInvalid().
  /// @param q_both  positions of the arms that do not move: one value per joint of both; empty: the
  ///                robot's start positions.
  /// @param table   width along x and depth along y of a table around the origin, its top at z = 0
  ///                [units]; nullopt for no table.
  /// @param held    what the arm that moves holds: it counts as part of the link that carries the
  ///                tool, and may touch the sides of the gripper.
  /// @throws std::invalid_argument  also if something is held and not just one arm moves.
  std::optional<InvalidMoment> FirstInvalid(const JointTrajectory& trajectory,
                                            std::span<const double> q_both,
                                            std::optional<std::pair<double, double>> table,
                                            const std::optional<HeldBox>& held = {}) const;

  /// Returns a pose in meters as 4 x 4 in units.
  Eigen::Matrix4d InUnits(const RigidTransform& X_WF) const;

 private:
  const ArmKinematics& Find(std::string_view arm) const;
  /// Returns the gripper of an arm, for a question about it at an opening.
  const robot::Gripper& FindGripper(std::string_view arm, double opening) const;
  RigidTransform FromUnits(const Eigen::Matrix4d& pose, const char* what) const;
  /// Returns the index of the arm all of whose joints a trajectory moves, and no others.
  std::size_t ArmOf(const JointTrajectory& trajectory) const;
  /// Returns the robot for a check of contacts, with a box in one hand.
  scene::ArticulationSpec Holding(const HeldBox& held, const robot::Arm& arm) const;

  robot::RobotModel model_;
  double meters_per_unit_ = 1;
  RigidTransform X_WBase_;
  std::vector<ArmKinematics> arms_;  ///< as in the model
  std::shared_ptr<ProbeStore> probes_;
};

/// Reads a robot's description from a URDF file or from the files that a brain receives.
///
/// @param gripper  name of one of the robot's grippers; empty: the default one.
///
/// See robot::ReadRobot() for errors.
PlanningRobot ReadPlanningRobot(const std::filesystem::path& urdf,
                                const Eigen::Matrix4d& base_pose = Eigen::Matrix4d::Identity(),
                                double meters_per_unit = 1, const std::string& gripper = "");

}  // namespace smile::motion
