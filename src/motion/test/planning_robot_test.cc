#include "motion/planning_robot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "arm.h"

namespace smile::motion {
namespace {

const PlanningRobot& Robot() {
  static const PlanningRobot robot(Baxter(), Eigen::Matrix4d::Identity(), 0.1);
  return robot;
}

TEST(FingerBounds, AreThoseOfBothFingersInTheFrameOfTheTool) {
  Eigen::Matrix<double, 2, 3> closed, open;
  closed << -0.2, -0.3, -0.75, 0.2, 0.3, 0.75;
  open << -0.2, -0.9, -0.75, 0.2, 0.9, 0.75;
  EXPECT_TRUE(Robot().FingerBounds("left", 0).isApprox(closed, 1e-12));
  EXPECT_TRUE(Robot().FingerBounds("right", 1.2).isApprox(open, 1e-12));
  EXPECT_TRUE(Robot().FingerBounds("left", -5).isApprox(closed, 1e-12)) << "as far as they move";
}

TEST(FingerBounds, NeedFingers) {
  robot::RobotModel model = Baxter();
  model.arms[0].gripper = robot::Gripper{.kind = robot::GripperKind::kSuction};
  model.arms[1].gripper.reset();
  const PlanningRobot robot(model, Eigen::Matrix4d::Identity(), 0.1);
  EXPECT_THROW(robot.FingerBounds("left", 0), std::invalid_argument);
  EXPECT_THROW(robot.FingerBounds("right", 0), std::invalid_argument);
  EXPECT_THROW(Robot().FingerBounds("left", NAN), std::invalid_argument);
}

}  // namespace
}  // namespace smile::motion
