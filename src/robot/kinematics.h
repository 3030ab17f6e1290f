#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "robot/robot_model.h"

namespace smile::robot {

/// Returns the poses X_WL of all moving links, in the order of `model.links`, with the base at
/// `X_WBase` and the joints at `q`.
///
/// @param q  one value per joint [rad or m]; limits are not checked.
/// @throws std::invalid_argument if `q` has the wrong size, as do all functions here.
std::vector<RigidTransform> LinkPoses(const RobotModel& model, const RigidTransform& X_WBase,
                                      std::span<const double> q);

/// Returns the pose X_WF of one frame.
///
/// @param frame  index into `model.frames`; see FindFrame().
/// @throws std::invalid_argument if there is no such frame.
RigidTransform FramePose(const RobotModel& model, const RigidTransform& X_WBase,
                         std::span<const double> q, int frame);

/// Returns the geometric Jacobian of a frame F: [v_BaseF; w_BaseF] = J * qdot, along the axes of
/// the base.
///
/// @param joints  joint indices, one per column, for example `arm.joints`.
/// @returns 6 x joints.size(): rows 0..2 linear [m/s per unit of rate], rows 3..5 angular. The
///          column of a joint that does not carry the frame is zero.
/// @throws std::invalid_argument if there is no such frame or joint.
/// Source: B. Siciliano et al., "Robotics: Modelling, Planning and Control" (2009), section 3.1.
Eigen::MatrixXd GeometricJacobian(const RobotModel& model, std::span<const double> q, int frame,
                                  std::span<const int> joints);

}  // namespace smile::robot
