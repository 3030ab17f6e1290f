#pragma once

#include <random>
#include <vector>

#include "base/files.h"
#include "robot/kinematics.h"
#include "robot/urdf_reader.h"

namespace smile::robot {

/// Returns the shipped robot, read once.
inline const RobotModel& Baxter() {
  static const RobotModel model = ReadRobot(DataFile("robots/baxter.urdf"));
  return model;
}

/// Returns a configuration with all joints at 0 except those of one arm.
inline std::vector<double> WithArmAt(const Arm& arm, const std::vector<double>& angles) {
  std::vector<double> q(Baxter().links.size(), 0.0);
  for (std::size_t i = 0; i < angles.size(); ++i) q[arm.joints[i]] = angles[i];
  return q;
}

/// Returns random positions within limits.
inline std::vector<double> RandomConfiguration(const RobotModel& model, std::mt19937* random) {
  std::vector<double> q;
  for (const scene::LinkSpec& link : model.links) {
    q.push_back(std::uniform_real_distribution<double>(link.lower, link.upper)(*random));
  }
  return q;
}

}  // namespace smile::robot
