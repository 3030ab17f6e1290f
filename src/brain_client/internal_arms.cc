// Messages have the values of all arms one after the other, in a few arrays; brains have a list of
// arms.

#include "brain_client/internal_arms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace smile::brain_client {
namespace {

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Returns an array of all joints as one vector per arm.
std::vector<Eigen::VectorXd> ByArm(const Eigen::VectorXd& all,
                                   const std::vector<Eigen::Index>& counts) {
  std::vector<Eigen::VectorXd> by_arm;
  Eigen::Index first = 0;
  for (const Eigen::Index count : counts) {
    by_arm.emplace_back(all.segment(first, count));
    first += count;
  }
  return by_arm;
}

std::vector<Eigen::VectorXd> ByArm(const Fields& message, const char* name,
                                   const std::vector<Eigen::Index>& counts) {
  const Eigen::MatrixXd all = message.Matrix(name);
  Eigen::Index size = 0;
  for (const Eigen::Index count : counts) size += count;
  if (all.size() != size) throw std::invalid_argument(std::string(name) + " has the wrong size");
  return ByArm(all.reshaped(), counts);
}

std::vector<Eigen::Index> CountsOf(const std::vector<Arm>& arms) {
  std::vector<Eigen::Index> counts;
  for (const Arm& arm : arms) counts.push_back(static_cast<Eigen::Index>(arm.joints.size()));
  return counts;
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
  std::vector<Eigen::Index> counts;
  const Eigen::MatrixXd joint_counts = init.Matrix("armJointCounts");
  for (Eigen::Index k = 0; k < joint_counts.size(); ++k) {
    counts.push_back(static_cast<Eigen::Index>(joint_counts(k)));
  }
  const std::vector<std::string> names = LinesOf(init.Text("armNames"));
  const std::vector<std::string> joints = LinesOf(init.Text("armJointNames"));
  const auto lower = ByArm(init, "armMinJoints", counts);
  const auto upper = ByArm(init, "armMaxJoints", counts);
  const auto velocities = ByArm(init, "armMaxVelocities", counts);
  const Eigen::MatrixXd grippers = init.Matrix("armGrippers");
  const std::vector<Eigen::Matrix4d> tools = init.Poses("armToolPoses");
  std::size_t first = 0;
  for (std::size_t k = 0; k < names.size(); ++k) {
    Arm& arm = arms.emplace_back(Arm{.name = names[k],
                                     .joints = {},
                                     .min_joints = lower.at(k),
                                     .max_joints = upper.at(k),
                                     .max_velocities = velocities.at(k),
                                     .gripper = {},
                                     .tool_pose = tools.at(k),
                                     .init_joints = {}});
    for (Eigen::Index i = 0; i < counts[k]; ++i) arm.joints.push_back(joints.at(first++));
    const Eigen::Vector2d openings = grippers.col(static_cast<Eigen::Index>(k));
    if (openings.allFinite()) arm.gripper = openings;
  }
  return arms;
}

std::vector<ArmSensor> SensedArms(const Fields& step, const std::vector<Arm>& arms) {
  std::vector<ArmSensor> sensed;
  if (!step.Has("armJoints")) return sensed;
  const std::vector<Eigen::Index> counts = CountsOf(arms);
  const auto joints = ByArm(step, "armJoints", counts);
  const auto velocities = ByArm(step, "armVelocities", counts);
  const Eigen::MatrixXd grippers = step.Matrix("armGrippers");
  const std::vector<Eigen::Matrix4d> poses = step.Poses("armEndEffectors");
  std::vector<std::string> held = LinesOf(step.Text("armHeldObjects"));
  held.resize(arms.size());  // empty lines at the end
  for (std::size_t k = 0; k < arms.size(); ++k) {
    sensed.push_back({.joints = joints[k],
                      .velocities = velocities[k],
                      .gripper = {},
                      .end_effector = poses.at(k),
                      .held_object = held[k]});
    const double opening = grippers(static_cast<Eigen::Index>(k));
    if (std::isfinite(opening)) sensed.back().gripper = opening;
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
