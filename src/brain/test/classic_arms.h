#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "brain/brain_values.h"

namespace smile::brain {

/// Values of the classic robot, as the 2x7 matrices that its scripts see.
using LimbJoints = Eigen::Matrix<double, kLimbCount, kJointCount>;

/// Returns two arms of seven joints.
inline std::vector<ArmDescription> ClassicArms() {
  std::vector<ArmDescription> arms;
  for (const std::string name : {"left", "right"}) {
    ArmDescription& arm = arms.emplace_back(ArmDescription{.name = name});
    for (const char* joint : {"s0", "s1", "e0", "e1", "w0", "w1", "w2"}) {
      arm.joint_names.push_back(name + "_" + joint);
    }
    arm.min_joints = arm.max_joints = arm.max_velocities = std::vector<double>(kJointCount);
    arm.gripper = {0, 2};
  }
  return arms;
}

/// Returns values with classic arms, unless they have arms.
inline Aux Classic(Aux aux) {
  if (aux.arms.empty()) aux.arms = ClassicArms();
  return aux;
}
inline Sensor Classic(Sensor sensor) {
  const std::vector<double> zeros(kJointCount);
  if (sensor.arms.empty()) {
    sensor.arms.assign(kLimbCount, {.joints = zeros, .velocities = zeros, .gripper = 0});
  }
  return sensor;
}

/// Returns arms of one and three joints; the second one has no gripper.
inline std::vector<ArmDescription> RailAndArm() {
  ArmDescription rail{.name = "rail",
                      .joint_names = {"slide"},
                      .min_joints = {-1},
                      .max_joints = {1},
                      .max_velocities = {0.5},
                      .gripper = Eigen::Vector2d(0, 2)};
  ArmDescription arm{.name = "arm",
                     .joint_names = {"a", "b", "c"},
                     .min_joints = {-1, -2, -3},
                     .max_joints = {1, 2, 3},
                     .max_velocities = {4, 5, 6}};
  arm.X_LG(2, 3) = 0.7;
  return {rail, arm};
}
inline std::vector<ArmSensor> RailAndArmSensed() {
  std::vector<ArmSensor> sensed = {
      {.joints = {1}, .velocities = {0.1}, .gripper = 0.5, .held_object = "cube"},
      {.joints = {2, 3, 4}, .velocities = {0, 0, 0}}};
  sensed[1].X_WG(0, 3) = 9;
  return sensed;
}

inline LimbJoints LimbsOf(const std::vector<double>& left, const std::vector<double>& right) {
  LimbJoints limbs;
  limbs << Eigen::Map<const Eigen::RowVectorXd>(left.data(), kJointCount),
      Eigen::Map<const Eigen::RowVectorXd>(right.data(), kJointCount);
  return limbs;
}
inline LimbJoints JointsOf(const Sensor& sensor) {
  return LimbsOf(sensor.arms.at(0).joints, sensor.arms.at(1).joints);
}
inline LimbJoints VelocitiesOf(const Sensor& sensor) {
  return LimbsOf(sensor.arms.at(0).velocities, sensor.arms.at(1).velocities);
}
inline LimbJoints VelocitiesOf(const Motor& motor) {
  return LimbsOf(motor.arms.at(0).velocities, motor.arms.at(1).velocities);
}
inline LimbJoints JointsOf(const Motor& motor) {
  return LimbsOf(motor.arms.at(0).joints.value(), motor.arms.at(1).joints.value());
}
inline LimbJoints JointsOf(const InitReply& reply) {
  return LimbsOf(reply.init_joints.at(0).value(), reply.init_joints.at(1).value());
}
inline Eigen::Vector2d GrippersOf(const Motor& motor) {
  return {motor.arms.at(0).gripper_velocity, motor.arms.at(1).gripper_velocity};
}

/// Returns a command for both arms.
inline Motor MotorOf(const LimbJoints& velocities, const Eigen::Vector2d& grippers = {0, 0}) {
  Motor motor;
  for (int arm = 0; arm < kLimbCount; ++arm) {
    ArmMotor& one = motor.arms.emplace_back();
    for (int i = 0; i < kJointCount; ++i) one.velocities.push_back(velocities(arm, i));
    one.gripper_velocity = grippers[arm];
  }
  return motor;
}

}  // namespace smile::brain
