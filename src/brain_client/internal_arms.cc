// Messages have the values of all arms one after the other, in a few arrays; brains have a list of
// arms.

#include "brain_client/internal_arms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "brain_client/internal_lines.h"

namespace smile::brain_client {
namespace {

std::size_t NumJoints(const std::vector<Arm>& arms) {
  std::size_t count = 0;
  for (const Arm& arm : arms) count += arm.joints.size();
  return count;
}

/// Returns `count` of the numbers, from `first` on.
Eigen::VectorXd Part(const std::vector<double>& numbers, std::size_t first, std::size_t count) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data() + first,
                                           static_cast<Eigen::Index>(count));
}

/// Returns the k-th of several 4x4 matrices.
Eigen::Matrix4d PoseAt(const std::vector<double>& numbers, std::size_t k) {
  return Eigen::Map<const Eigen::Matrix4d>(numbers.data() + 16 * k);
}

std::string NameOf(const char* variable, std::size_t arm, const char* field) {
  return std::string(variable) + ".arms[" + std::to_string(arm) + "]." + field;
}

[[noreturn]] void RefuseShape(const std::string& name, const Eigen::MatrixXd& found,
                              const std::string& expected) {
  throw std::invalid_argument(name + " is " + std::to_string(found.rows()) + "x" +
                              std::to_string(found.cols()) + ", expected " + expected);
}

/// Adds the joints of the arms that have some; nothing if none has.
/// @param joints  of each arm, or nullopt.
void AddPosture(wire::MessageWriter& writer, const char* variable, const char* field,
                const std::vector<Arm>& arms,
                const std::vector<const std::optional<Eigen::VectorXd>*>& joints) {
  std::vector<double> all, are_set;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const std::size_t count = arms[k].joints.size();
    are_set.push_back(joints[k]->has_value() ? 1 : 0);
    if (!*joints[k]) {
      all.insert(all.end(), count, 0.0);
      continue;
    }
    const Eigen::VectorXd& values = **joints[k];
    if (static_cast<std::size_t>(values.size()) != count) {
      RefuseShape(NameOf(variable, k, field), values, std::to_string(count) + "x1");
    }
    all.insert(all.end(), values.begin(), values.end());
  }
  if (std::ranges::find(are_set, 1.0) == are_set.end()) return;
  writer.AddDoubles("armJoints", std::array{static_cast<std::uint32_t>(all.size()), 1u}, all);
  writer.AddDoubles("armsAtJoints", std::array{static_cast<std::uint32_t>(are_set.size()), 1u},
                    are_set);
}

void AddMatrix(wire::MessageWriter& writer, const char* name, const Eigen::MatrixXd& matrix) {
  const std::array dims{static_cast<std::uint32_t>(matrix.rows()),
                        static_cast<std::uint32_t>(matrix.cols())};
  writer.AddDoubles(name, dims, {matrix.data(), static_cast<std::size_t>(matrix.size())});
}

/// Stacks values of arms; in those with fewer ticks, the last one remains in effect.
Eigen::MatrixXd Stacked(const std::vector<Eigen::MatrixXd>& parts) {
  Eigen::Index rows = 0, ticks = 1;
  for (const Eigen::MatrixXd& part : parts) {
    rows += part.rows();
    ticks = std::max(ticks, part.cols());
  }
  Eigen::MatrixXd all(rows, ticks);
  Eigen::Index row = 0;
  for (const Eigen::MatrixXd& part : parts) {
    for (Eigen::Index tick = 0; tick < ticks; ++tick) {
      all.block(row, tick, part.rows(), 1) = part.col(std::min(tick, part.cols() - 1));
    }
    row += part.rows();
  }
  return all;
}

}  // namespace

std::vector<Arm> ArmsOf(const Fields& init) {
  std::vector<Arm> arms;
  if (!init.Has("armNames")) return arms;
  const std::vector<std::string> names = LinesOf(init.Text("armNames"));
  const std::vector<std::string> joints = LinesOf(init.Text("armJointNames"));
  const std::vector<double> counts = init.Doubles("armJointCounts", names.size());
  const std::vector<double> lower = init.Doubles("armMinJoints", joints.size());
  const std::vector<double> upper = init.Doubles("armMaxJoints", joints.size());
  const std::vector<double> velocities = init.Doubles("armMaxVelocities", joints.size());
  const std::vector<double> grippers = init.Doubles("armGrippers", 2 * names.size());
  const std::vector<double> tools = init.Doubles("armToolPoses", 16 * names.size());
  std::size_t first = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto count = static_cast<std::size_t>(counts[k]);
    if (count > joints.size() - first) throw std::invalid_argument("armJointCounts is too large");
    Arm& arm = arms.emplace_back(Arm{.name = names[k],
                                     .joints = {},
                                     .min_joints = Part(lower, first, count),
                                     .max_joints = Part(upper, first, count),
                                     .max_velocities = Part(velocities, first, count),
                                     .gripper = {},
                                     .tool_pose = PoseAt(tools, k),
                                     .init_joints = {}});
    for (std::size_t i = 0; i < count; ++i) arm.joints.push_back(joints[first + i]);
    if (std::isfinite(grippers[2 * k])) arm.gripper = {grippers[2 * k], grippers[2 * k + 1]};
    first += count;
  }
  return arms;
}

std::vector<ArmSensor> SensedArms(const Fields& step, const std::vector<Arm>& arms) {
  std::vector<ArmSensor> sensed;
  if (!step.Has("armJoints")) return sensed;
  const std::size_t num_joints = NumJoints(arms);
  const std::vector<double> joints = step.Doubles("armJoints", num_joints);
  const std::vector<double> velocities = step.Doubles("armVelocities", num_joints);
  const std::vector<double> grippers = step.Doubles("armGrippers", arms.size());
  const std::vector<double> poses = step.Doubles("armEndEffectors", 16 * arms.size());
  std::vector<std::string> held = LinesOf(step.Text("armHeldObjects"));
  held.resize(arms.size());
  sensed.reserve(arms.size());
  std::size_t first = 0;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const std::size_t count = arms[k].joints.size();
    sensed.push_back({.joints = Part(joints, first, count),
                      .velocities = Part(velocities, first, count),
                      .gripper = {},
                      .end_effector = PoseAt(poses, k),
                      .held_object = std::move(held[k])});
    if (std::isfinite(grippers[k])) sensed.back().gripper = grippers[k];
    first += count;
  }
  return sensed;
}

std::vector<ArmMotor> StillArms(const std::vector<Arm>& arms) {
  std::vector<ArmMotor> motor;
  for (const Arm& arm : arms) {
    const auto count = static_cast<Eigen::Index>(arm.joints.size());
    motor.push_back({.velocities = Eigen::MatrixXd::Zero(count, 1),
                     .gripper_velocity = Eigen::VectorXd::Zero(1),
                     .joints = {}});
  }
  return motor;
}

bool AreSet(const std::vector<ArmMotor>& motor) {
  return std::ranges::any_of(motor, [](const ArmMotor& arm) {
    return arm.joints || arm.velocities.cols() != 1 || !arm.velocities.isZero(0) ||
           arm.gripper_velocity.size() != 1 || !arm.gripper_velocity.isZero(0);
  });
}

void AddInitJoints(wire::MessageWriter& writer, const std::vector<Arm>& arms, const Aux& aux) {
  if (aux.arms.size() != arms.size()) throw std::invalid_argument("aux.arms has another size");
  std::vector<const std::optional<Eigen::VectorXd>*> joints;
  for (const Arm& arm : aux.arms) joints.push_back(&arm.init_joints);
  AddPosture(writer, "aux", "init_joints", arms, joints);
}

void AddArms(wire::MessageWriter& writer, const std::vector<Arm>& arms,
             const std::vector<ArmMotor>& motor) {
  if (motor.size() != arms.size()) {
    throw std::invalid_argument("motor.arms has " + std::to_string(motor.size()) +
                                " elements, expected " + std::to_string(arms.size()));
  }
  std::vector<Eigen::MatrixXd> velocities, grippers;
  std::vector<const std::optional<Eigen::VectorXd>*> joints;
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const ArmMotor& arm = motor[k];
    const auto count = static_cast<Eigen::Index>(arms[k].joints.size());
    if (arm.velocities.rows() != count || arm.velocities.cols() < 1) {
      const std::string rows = std::to_string(count);
      RefuseShape(NameOf("motor", k, "velocities"), arm.velocities,
                  rows + "x1, or " + rows + "xN for N ticks");
    }
    if (arm.gripper_velocity.size() < 1) {
      RefuseShape(NameOf("motor", k, "gripper_velocity"), arm.gripper_velocity, "1x1");
    }
    velocities.push_back(arm.velocities);
    grippers.emplace_back(arm.gripper_velocity.transpose());
    joints.push_back(&arm.joints);
  }
  AddMatrix(writer, "armVelocities", Stacked(velocities));
  AddMatrix(writer, "armGripperVelocities", Stacked(grippers));
  AddPosture(writer, "motor", "joints", arms, joints);
}

}  // namespace smile::brain_client
