#include <gtest/gtest.h>

#include "base/files.h"
#include "robot/kinematics.h"
#include "robot/urdf_reader.h"

namespace smile::robot {
namespace {

TEST(Tern, IsAnArmOfSixJointsWithTwoFingersReadyOverTheTable) {
  const RobotModel tern = ReadRobot(DataFile("robots/tern.urdf"));
  ASSERT_EQ(tern.arms.size(), 1u);
  EXPECT_EQ(tern.arms[0].joints.size(), 6u);
  const OpeningRange range = OpeningRangeOf(tern, *tern.arms[0].gripper);
  EXPECT_EQ(range.closed, 0);
  EXPECT_EQ(range.open, 0.13);
  // Ready: 0.2 m over the table, fingers down.
  const RigidTransform X_BaseG = FramePose(tern, {}, tern.q_start, tern.arms[0].tool);
  EXPECT_NEAR(X_BaseG.translation().z(), 0.2, 0.002);
  EXPECT_LT((X_BaseG.rotation().col(2) + Vector3::UnitZ()).norm(), 1e-3);
}

}  // namespace
}  // namespace smile::robot
