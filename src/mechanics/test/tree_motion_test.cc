#include "mechanics/tree_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace smile::mechanics {
namespace {

/// A random tree whose joints can be moved.
class Tree {
 public:
  explicit Tree(int count) : joint_frames_(count), q_(count), links_(count) {
    for (int i = 0; i < count; ++i) {
      TreeLink& link = links_[i];
      link.parent = i == 4 ? 1 : i - 1;  // it branches once
      link.axis = Random().normalized();
      link.is_revolute = i % 3 != 2;
      link.mass = 1 + std::abs(Random().x());
      link.inertia = Vector3(0.02, 0.03, 0.04) + 0.01 * Random().cwiseAbs();
      link.p_JL = 0.3 * Random();
      joint_frames_[i] = RigidTransform(
          Eigen::AngleAxisd(Random().x() * 3, Random().normalized()).toRotationMatrix(),
          0.4 * Random());
    }
  }

  /// The tree with the joints at these positions and velocities.
  TreeMotion At(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
    TreeMotion motion;
    std::vector<TreeLink>& links = motion.links = links_;
    for (const double one : v) motion.goals.push_back({.v = one, .allowed = {-9, 9}});
    for (std::size_t i = 0; i < links.size(); ++i) {
      const RigidTransform X_PL = PoseInParent(i, q[i]);
      links[i].R_LP = X_PL.rotation().transpose();
      links[i].p_PL = links[i].R_LP * X_PL.translation();
    }
    return motion;
  }
  /// Kinetic energy from poses alone [J].
  double Energy(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
    constexpr double kH = 1e-5;
    const std::vector<RigidTransform> before = Poses(q - kH * v), now = Poses(q),
                                      after = Poses(q + kH * v);
    double energy = 0;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Vector3 linear = (after[i].translation() - before[i].translation()) / (2 * kH);
      const Matrix3 skew =
          now[i].rotation().transpose() * (after[i].rotation() - before[i].rotation()) / (2 * kH);
      const Vector3 angular(skew(2, 1), skew(0, 2), skew(1, 0));
      energy += links_[i].mass * linear.squaredNorm() / 2 +
                angular.dot(links_[i].inertia.cwiseProduct(angular)) / 2;
    }
    return energy;
  }
  Eigen::VectorXd RandomVector() {
    Eigen::VectorXd vector(links_.size());
    for (double& one : vector) one = Random().x();
    return vector;
  }

 private:
  Vector3 Random() {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double x = uniform(random_), y = uniform(random_), z = uniform(random_);
    return {x, y, z};
  }
  RigidTransform PoseInParent(std::size_t i, double q) const {
    const TreeLink& link = links_[i];
    const RigidTransform X_JL =
        link.is_revolute
            ? RigidTransform(Eigen::AngleAxisd(q, link.axis).toRotationMatrix(), Vector3::Zero())
            : RigidTransform(Vector3(q * link.axis));
    return joint_frames_[i] * X_JL * RigidTransform(link.p_JL);
  }
  std::vector<RigidTransform> Poses(const Eigen::VectorXd& q) const {
    std::vector<RigidTransform> poses;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const RigidTransform X_PL = PoseInParent(i, q[i]);
      poses.push_back(links_[i].parent < 0 ? X_PL : poses[links_[i].parent] * X_PL);
    }
    return poses;
  }

  std::mt19937 random_{7};
  std::vector<RigidTransform> joint_frames_;
  Eigen::VectorXd q_;
  std::vector<TreeLink> links_;
};

// Lagrange's equations, with the energy from the poses of the links: d/dt dT/dv - dT/dq = efforts.
TEST(TreeMotionTest, EffortsAreThoseThatLagrangesEquationsDemand) {
  constexpr int kCount = 6;
  constexpr double kH = 1e-3;
  Tree tree(kCount);
  for (int k = 0; k < 5; ++k) {
    const Eigen::VectorXd q = tree.RandomVector(), v = tree.RandomVector(), a = tree.RandomVector();
    TreeMotion motion = tree.At(q, v);
    const std::span<const double> efforts = motion.EffortsFor({a.data(), kCount});
    for (int i = 0; i < kCount; ++i) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(kCount, i);
      const auto momentum = [&](double t) {
        const Eigen::VectorXd q_t = q + t * v + t * t / 2 * a, v_t = v + t * a;
        return (tree.Energy(q_t, v_t + kH * unit) - tree.Energy(q_t, v_t - kH * unit)) / (2 * kH);
      };
      const double momentum_rate = (momentum(kH) - momentum(-kH)) / (2 * kH);
      const double along_q =
          (tree.Energy(q + kH * unit, v) - tree.Energy(q - kH * unit, v)) / (2 * kH);
      EXPECT_NEAR(efforts[i], momentum_rate - along_q, 2e-4 * (1 + std::abs(efforts[i])))
          << k << ", joint " << i;
    }
  }
}

TEST(TreeMotionTest, JointsDoWhatIsWantedOrNothingIsSaid) {
  constexpr double kStep = 0.002;
  Tree tree(3);
  TreeMotion motion = tree.At(tree.RandomVector(), tree.RandomVector());
  for (JointGoal& goal : motion.goals) goal.max_impulse = 5;
  motion.goals[0].wanted = 0.5;
  motion.goals[2] = {.v = 0.3, .wanted = 0.01, .leader = 0, .ratio = -2};
  ASSERT_TRUE(motion.Solve(kStep));
  EXPECT_EQ(motion.velocities()[0], 0.5);
  EXPECT_EQ(motion.velocities()[2], -0.99);

  // The leader's motor bears its own load and that of its follower.
  std::vector<double> accelerations;
  for (int i = 0; i < 3; ++i) {
    accelerations.push_back((motion.velocities()[i] - motion.goals[i].v) / kStep);
  }
  const std::span<const double> efforts = motion.EffortsFor(accelerations);
  const double impulse = std::abs(efforts[0] - 2 * efforts[2]) * kStep;
  motion.goals[0].max_impulse = 1.001 * impulse;
  EXPECT_TRUE(motion.Solve(kStep));
  motion.goals[0].max_impulse = 0.999 * impulse;
  EXPECT_FALSE(motion.Solve(kStep)) << "the motor is too weak";

  motion.goals[0].max_impulse = 5;
  motion.goals[0].allowed.most = 0.49;
  EXPECT_FALSE(motion.Solve(kStep)) << "a limit is in the way";
}

}  // namespace
}  // namespace smile::mechanics
