#include "catalog/internal_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "motion/articulation_probe.h"
#include "motion/inverse_kinematics.h"
#include "robot/kinematics.h"

namespace smile::catalog::internal {

double Fraction(std::mt19937_64* random) {
  return static_cast<double>((*random)() >> 11) * 0x1.0p-53;
}

std::vector<double> RandomConfiguration(const robot::RobotModel& model, std::mt19937_64* random) {
  std::vector<double> q;
  for (const scene::LinkSpec& link : model.links) {
    const double lower = std::max(link.lower, -std::numbers::pi);
    const double upper = std::min(link.upper, std::numbers::pi);
    q.push_back(lower < upper ? std::lerp(lower, upper, Fraction(random)) : link.lower);
  }
  scene::FollowLeaders(model.links, q);
  return q;
}

std::map<std::pair<int, int>, double> OverlapFractions(const robot::RobotModel& model,
                                                       const LinkPairs& without,
                                                       const Progress& progress) {
  scene::ArticulationSpec spec = robot::MakeArticulationSpec(model, {});
  spec.never_collide.assign(without.begin(), without.end());
  motion::ArticulationProbe probe(spec);
  std::map<std::pair<int, int>, double> fractions;
  std::mt19937_64 random(1);
  for (int i = 0; i < kSamples; ++i) {
    if (progress && !progress(i, kSamples)) throw std::runtime_error("interrupted");
    for (const auto& pair : probe.AllOverlaps(RandomConfiguration(model, &random))) {
      fractions[pair] += 1.0 / kSamples;
    }
  }
  return fractions;
}

double ReachOf(const robot::RobotModel& model, const robot::Arm& arm, std::span<const double> q) {
  const std::vector<RigidTransform> X_BaseL = robot::LinkPoses(model, {}, q);
  double reach = 0;
  Vector3 before = X_BaseL[arm.joints.front()].translation();
  for (int joint : arm.joints) {
    reach += (X_BaseL[joint].translation() - before).norm();
    before = X_BaseL[joint].translation();
  }
  return reach + (robot::FramePose(model, {}, q, arm.tool).translation() - before).norm();
}

std::optional<std::vector<double>> ReachDown(const robot::RobotModel& model, const robot::Arm& arm,
                                             const RigidTransform& X_WBase, const Vector3& p_WG,
                                             std::span<const double> q) {
  const motion::ArmKinematics kinematics(model, arm, X_WBase, q);
  Matrix3 R_WG;  // x back to the robot, y to its left, z down
  R_WG << 0, -1, 0, -1, 0, 0, 0, 0, -1;
  std::vector<double> start;
  for (int joint : arm.joints) start.push_back(q[joint]);
  return motion::SolveInverseKinematics(kinematics, RigidTransform(R_WG, p_WG), start,
                                        {.position_tolerance = 1e-4,
                                         .angle_tolerance = 1e-3,
                                         .any_turn = true,
                                         .max_iterations = 300});
}

}  // namespace smile::catalog::internal
