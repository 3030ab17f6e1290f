#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "motion/trajectory_shape.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Random commands of a robot, some of which are refused.
class RandomRobot {
 public:
  explicit RandomRobot(unsigned seed) : random_(seed) {}

  Command Next(const Simulation& simulation) {
    const std::vector<std::string> poses{"ready", "neutral", "zero", "bent", "nowhere"};
    const std::vector<std::string> grippers{"left", "right", "both", "all", "rear"};
    const std::vector<robot::Arm>& arms = simulation.robot()->model().arms;
    const robot::Arm& arm = arms[random_() % arms.size()];
    switch (random_() % 8) {
      case 0:
        return JointVelocities{
            .arms = {{arm.name, std::vector<double>(arm.joints.size(), Uniform(0.5))}},
            .grippers = {{"left", Uniform(0.1)}, {"right", Uniform(0.1)}}};
      case 1:
        return JointVelocities{.head = Uniform(1)};
      case 2:
        return JointAngles{
            .arms = {{arm.name, std::vector<double>(arm.joints.size(), 0.5 + Uniform(0.5))}}};
      case 3:
        return TurnJoint{.joint = random_() % 2 == 0 ? NameOfLastJoint(simulation) : "right_e9",
                         .velocity = Uniform(2)};
      case 4:
        return MoveGripper{.arm = grippers[random_() % grippers.size()], .velocity = Uniform(0.2)};
      case 5:
        return TakePose{.name = poses[random_() % poses.size()], .speed = 0.2 + Uniform(0.1)};
      default:
        return FollowTrajectory{Wave(simulation)};
    }
  }

 private:
  static std::string NameOfLastJoint(const Simulation& simulation) {
    const robot::RobotModel& model = simulation.robot()->model();
    return model.links[model.arms[0].joints.back()].joint_name;
  }
  /// From where the robot is, or from somewhere else.
  motion::JointTrajectory Wave(const Simulation& simulation) {
    const robot::RobotModel& model = simulation.robot()->model();
    const std::vector<double> q = simulation.robot()->positions();
    motion::JointTrajectory wave;
    motion::TrajectoryPoint point{.seconds = random_() % 2 == 0 ? 0.0 : 0.2};
    for (const motion::TrajectoryChannel& channel : motion::ChannelsOf(model)) {
      if (random_() % 3 == 0) continue;
      wave.joint_names.push_back(channel.name);
      point.positions.push_back(PositionOf(channel, model, q));
    }
    for (int i = 0; i < 5; ++i) {
      wave.points.push_back(point);
      point.seconds += 0.1;
      for (double& position : point.positions) position += Uniform(0.03);
    }
    motion::SetVelocitiesFromPositions(&wave);
    return wave;
  }

  double Uniform(double limit) { return std::uniform_real_distribution(-limit, limit)(random_); }

  std::mt19937 random_;
};

}  // namespace smile::sim
