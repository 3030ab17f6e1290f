#pragma once

#include <random>
#include <vector>

#include "base/files.h"
#include "motion/arm_kinematics.h"
#include "robot/urdf_reader.h"

namespace smile::motion {

/// Returns the shipped robot, read once.
inline const robot::RobotModel& Baxter() {
  static const robot::RobotModel model = robot::ReadRobot(DataFile("robots/baxter.urdf"));
  return model;
}

/// Returns one of its arms, in the base frame.
inline ArmKinematics ArmOf(const char* name) {
  return ArmKinematics(Baxter(), *robot::FindArm(Baxter(), name));
}

/// Returns random positions within the middle `share` of all limits.
inline std::vector<double> RandomArm(const ArmKinematics& arm, std::mt19937* random,
                                     double share = 1) {
  std::vector<double> q;
  for (const JointLimits& limit : arm.limits()) {
    const double middle = (limit.lower + limit.upper) / 2, half = (limit.upper - limit.lower) / 2;
    q.push_back(middle +
                std::uniform_real_distribution<double>(-share * half, share * half)(*random));
  }
  return q;
}

/// Returns the angle between two rotations [rad].
inline double AngleBetween(const Matrix3& R_1, const Matrix3& R_2) {
  return Eigen::AngleAxisd(R_1.transpose() * R_2).angle();
}

}  // namespace smile::motion
