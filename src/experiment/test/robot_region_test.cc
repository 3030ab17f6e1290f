#include "experiment/robot_region.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/files.h"
#include "motion/inverse_kinematics.h"
#include "robot/test/generated_robot.h"

namespace smile::experiment {
namespace {

constexpr double kHeight = 0.1;  ///< of objects [m]

TEST(RobotRegion, OfBaxterIsTheMeasuredOne) {
  const model::RobotPlacement baxter{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))};
  EXPECT_EQ(RegionOf(baxter, kHeight).reach_map, nullptr);
}

TEST(RobotRegion, NothingStandsInTheRobotAtTheStart) {
  const model::RobotPlacement baxter{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))};
  const layout::LayoutRegion region = RegionOf(baxter, kHeight);
  const scene::TableSpec table;
  // Below a hand there is room for a block, but not for three of them.
  const layout::Footprint tower{.center = {0.164, -0.36}, .half_size = {0.05, 0.05}};
  EXPECT_TRUE(region.Holds(table, tower, 0.1));
  EXPECT_FALSE(region.Holds(table, tower, 0.3));
  EXPECT_TRUE(layout::LayoutRegion().Holds(table, tower, 0.3)) << "the eye sees all of it";
}

TEST(RobotRegion, ComputedForBaxterIsNearlyTheMeasuredOne) {
  model::RobotPlacement robot{.model = robot::ReadRobot(DataFile("robots/baxter.urdf"))};
  robot.model.name = "twin";
  const layout::LayoutRegion computed = RegionOf(robot, kHeight), measured;
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
  EXPECT_LT(num_different, num_reached / 10);
}

TEST(RobotRegion, IsWhatAnArmReachesFromAbove) {
  for (const int num_joints : {4, 5, 6}) {
    const model::RobotPlacement robot{.model =
                                          robot::GeneratedRobot({{"arm", num_joints}}).Model()};
    const layout::LayoutRegion region = RegionOf(robot, kHeight);
    ASSERT_NE(region.reach_map, nullptr);
    const scene::TableSpec table;
    const double edge = -table.y_span / 2;
    EXPECT_TRUE(region.Reaches(table, {0, edge + 0.2})) << num_joints;
    EXPECT_TRUE(region.Reaches(table, {0.2, edge + 0.15})) << num_joints;
    EXPECT_FALSE(region.Reaches(table, {0, edge + 0.9})) << num_joints;
    EXPECT_EQ(*RegionOf(robot, kHeight).reach_map, *region.reach_map);
  }
}

TEST(RobotRegion, IsWhatTheRobotsOwnEyeSees) {
  const model::RobotPlacement tern{
      .model = robot::ReadRobot(DataFile("robots/tern.urdf")), .gap = -0.1, .height = 0};
  const layout::LayoutRegion region = RegionOf(tern, kHeight);
  const scene::TableSpec table;
  const auto is_seen = [&](double depth) {
    const layout::Footprint block{.center = {0.3, depth - table.y_span / 2},
                                  .half_size = {0.05, 0.05}};
    return region.Holds(table, block, kHeight);
  };
  // The arm reaches all three; the picture begins 0.16 m behind the edge of the table.
  EXPECT_TRUE(region.Reaches(table, {0.3, 0.16 - table.y_span / 2}));
  EXPECT_FALSE(is_seen(0.16));
  EXPECT_TRUE(is_seen(0.24));
  EXPECT_TRUE(is_seen(0.5));
}

TEST(RobotRegion, IsLargerForSmallObjects) {
  const model::RobotPlacement robot{.model = robot::GeneratedRobot({{"arm", 5}}).Model()};
  const auto num_reached = [&](double height) {
    return std::ranges::count(RegionOf(robot, height).reach_map->is_reached, true);
  };
  EXPECT_GT(num_reached(0.02), num_reached(0.3) + 20);
}

}  // namespace
}  // namespace smile::experiment
