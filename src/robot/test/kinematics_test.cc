#include "robot/kinematics.h"

#include <gtest/gtest.h>

#include <random>

#include "math/angles.h"
#include "robot/test/baxter.h"
#include "robot/test/fk_vectors.h"

namespace smile::robot {
namespace {

/// The vectors are written with nine digits after the point.
constexpr double kVectorTolerance = 1e-9;

int HandOf(const std::string& arm) { return FindFrame(Baxter(), arm + "_hand").value(); }

RigidTransform HandPose(const Arm& arm, const std::vector<double>& angles) {
  return FramePose(Baxter(), {}, WithArmAt(arm, angles), HandOf(arm.name));
}

TEST(Kinematics, PutsHandAndTipWhereIndependentArithmeticDoes) {
  const std::vector<FkVector> rows = ReadFkVectors();
  ASSERT_EQ(rows.size(), 110u);
  for (const FkVector& row : rows) {
    SCOPED_TRACE(row.arm + " " + row.name);
    const RigidTransform X_BaseHand = HandPose(*FindArm(Baxter(), row.arm), row.q);
    const Vector3 p_BaseTip = X_BaseHand * Vector3(0, 0, 0.1577);
    EXPECT_LT((X_BaseHand.translation() - row.p_BaseHand).cwiseAbs().maxCoeff(), kVectorTolerance);
    EXPECT_LT((p_BaseTip - row.p_BaseTip).cwiseAbs().maxCoeff(), kVectorTolerance);
    // q and -q are one rotation.
    Quaternion q_BaseHand = X_BaseHand.quaternion();
    if (q_BaseHand.dot(row.q_BaseHand) < 0) q_BaseHand.coeffs() *= -1;
    EXPECT_LT((q_BaseHand.coeffs() - row.q_BaseHand.coeffs()).cwiseAbs().maxCoeff(),
              kVectorTolerance);
  }
}

TEST(Kinematics, AgreesWithTheGivenJacobians) {
  int num_checked = 0;
  for (const FkVector& row : ReadFkVectors()) {
    if (!row.J) continue;
    SCOPED_TRACE(row.arm + " " + row.name);
    const Arm& arm = *FindArm(Baxter(), row.arm);
    const Eigen::MatrixXd J =
        GeometricJacobian(Baxter(), WithArmAt(arm, row.q), HandOf(row.arm), arm.joints);
    ASSERT_EQ(J.rows(), 6);
    ASSERT_EQ(J.cols(), 7);
    EXPECT_LT((J - *row.J).cwiseAbs().maxCoeff(), 1e-8);
    ++num_checked;
  }
  EXPECT_EQ(num_checked, 10);
}

TEST(Kinematics, JacobianAgreesWithCentralDifferences) {
  constexpr double kStep = 1e-5;
  const RobotModel& model = Baxter();
  std::mt19937 random(7);
  // Grippers too: their fingers slide, and no other arm's joint moves them.
  std::vector<int> all_joints;
  for (int i = 0; i < model.num_joints(); ++i) all_joints.push_back(i);
  for (const char* name : {"left_gripper", "right_gripper_left_finger", "eye", "pedestal"}) {
    const int frame = FindFrame(model, name).value();
    for (int trial = 0; trial < 10; ++trial) {
      const std::vector<double> q = RandomConfiguration(model, &random);
      const Eigen::MatrixXd J = GeometricJacobian(model, q, frame, all_joints);
      for (int joint : all_joints) {
        std::vector<double> q_before = q, q_after = q;
        q_before[joint] -= kStep;
        q_after[joint] += kStep;
        const RigidTransform X_before = FramePose(model, {}, q_before, frame);
        const RigidTransform X_after = FramePose(model, {}, q_after, frame);
        Eigen::Matrix<double, 6, 1> rate;
        rate << X_after.translation() - X_before.translation(),
            RotationVectorBetween(X_before.quaternion(), X_after.quaternion());
        EXPECT_LT((J.col(joint) - rate / (2 * kStep)).cwiseAbs().maxCoeff(), 1e-8)
            << name << ", joint " << model.links[joint].joint_name;
      }
    }
  }
}

TEST(Kinematics, TheRightArmMirrorsTheLeft) {
  const Arm& left = *FindArm(Baxter(), "left");
  const Arm& right = *FindArm(Baxter(), "right");
  const Vector3 mirror(1, -1, 1);
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    const std::vector<double> q = RandomConfiguration(Baxter(), &random);
    std::vector<double> q_left, q_right;
    for (std::size_t i = 0; i < left.joints.size(); ++i) {
      q_left.push_back(q[left.joints[i]]);
      // Rolls (s0, e0, w0, w2) change sign, pitches do not.
      q_right.push_back(i % 2 == 0 ? -q_left[i] : q_left[i]);
    }
    const RigidTransform X_left = HandPose(left, q_left);
    const RigidTransform X_right = HandPose(right, q_right);
    EXPECT_LT((X_right.translation() - mirror.cwiseProduct(X_left.translation())).norm(), 1e-9);
    const Matrix3 R_mirrored = mirror.asDiagonal() * X_left.rotation() * mirror.asDiagonal();
    EXPECT_LT((X_right.rotation() - R_mirrored).norm(), 1e-9);
  }
}

TEST(Kinematics, MovesWithTheBase) {
  const RobotModel& model = Baxter();
  const RigidTransform X_WBase(RotationFromFixedAxes({10, 20, 30}), {1, 2, 3});
  const std::vector<RigidTransform> X_WL = LinkPoses(model, X_WBase, model.q_start);
  const std::vector<RigidTransform> X_BaseL = LinkPoses(model, {}, model.q_start);
  ASSERT_EQ(X_WL.size(), model.links.size());
  for (std::size_t i = 0; i < X_WL.size(); ++i) {
    const RigidTransform expected = X_WBase * X_BaseL[i];
    EXPECT_LT((X_WL[i].translation() - expected.translation()).norm(), 1e-12);
    EXPECT_LT((X_WL[i].rotation() - expected.rotation()).norm(), 1e-12);
  }
}

TEST(Kinematics, RefusesWhatDoesNotFitTheRobot) {
  const RobotModel& model = Baxter();
  const std::vector<double> too_short(3);
  const std::vector<int> wrong_joint{99};
  EXPECT_THROW(LinkPoses(model, {}, too_short), std::invalid_argument);
  EXPECT_THROW(FramePose(model, {}, too_short, 0), std::invalid_argument);
  EXPECT_THROW(FramePose(model, {}, model.q_start, -1), std::invalid_argument);
  EXPECT_THROW(FramePose(model, {}, model.q_start, 1000), std::invalid_argument);
  EXPECT_THROW(GeometricJacobian(model, model.q_start, 0, wrong_joint), std::invalid_argument);
}

}  // namespace
}  // namespace smile::robot
