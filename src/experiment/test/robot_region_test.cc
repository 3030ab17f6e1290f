#include "experiment/robot_region.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "motion/inverse_kinematics.h"
#include "robot/test/generated_robot.h"

namespace smile::experiment {
namespace {

TEST(RobotRegion, OfBaxterIsTheMeasuredOne) {
  const model::RobotPlacement baxter{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))};
  EXPECT_EQ(RegionOf(baxter).reach_map, nullptr);
}

TEST(RobotRegion, ComputedForBaxterIsTheMeasuredOne) {
  model::RobotPlacement robot{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))};
  robot.model.name = "twin";
  const layout::LayoutRegion computed = RegionOf(robot), measured;
  const scene::TableSpec table;
  int num_different = 0, num_reached = 0;
  const layout::ReachMap& map = *computed.reach_map;
  for (int row = 0; row < map.num_rows(); ++row) {
    for (int column = 0; column < map.num_columns(); ++column) {
      const layout::Vector2 place = map.MiddleOf(column, row);
      const bool is_measured = measured.Reaches(table, {place.x(), place.y() - table.y_span / 2});
      num_reached += is_measured ? 1 : 0;
      num_different += is_measured && !map.Contains(place) ? 1 : 0;
    }
  }
  EXPECT_GT(num_reached, 300);
  EXPECT_LT(num_different, num_reached / 50);
}

TEST(RobotRegion, IsWhatAnArmReachesFromAbove) {
  for (const int num_joints : {4, 5, 6}) {
    const model::RobotPlacement robot{.model =
                                          robot::GeneratedRobot({{"arm", num_joints}}).Model()};
    const layout::LayoutRegion region = RegionOf(robot);
    ASSERT_NE(region.reach_map, nullptr);
    EXPECT_TRUE(region.has_standard_eye);
    const scene::TableSpec table;
    const double edge = -table.y_span / 2;
    EXPECT_TRUE(region.Reaches(table, {0, edge + 0.2})) << num_joints;
    EXPECT_TRUE(region.Reaches(table, {0.2, edge + 0.15})) << num_joints;
    EXPECT_FALSE(region.Reaches(table, {0, edge + 0.9})) << num_joints;
    EXPECT_EQ(*RegionOf(robot).reach_map, *region.reach_map);
  }
}

}  // namespace
}  // namespace smile::experiment
