#include "catalog/placed_robot.h"

#include <utility>

#include "catalog/robot_catalog.h"
#include "robot/urdf_reader.h"

namespace smile::catalog {

PlacedRobot PlaceRobot(const std::string& name_or_path, const PlacingOptions& options) {
  const RobotSource source = FindRobot(name_or_path);
  robot::RobotReading reading = robot::LoadRobot(
      source.urdf, {.side_file = options.side_file.empty() ? source.side_file : options.side_file,
                    .start_pose = options.start_pose,
                    .package_roots = options.package_roots,
                    .gripper = options.gripper});
  PlacedRobot placed{.placement = {.model = std::move(reading.model),
                                   .gripper = std::move(reading.gripper),
                                   .files = std::move(reading.files),
                                   .body = options.body},
                     .urdf = source.urdf,
                     .has_side_file = reading.has_side_file};
  model::RobotPlacement& placement = placed.placement;
  placement.gap = reading.gap.value_or(placement.gap);
  placement.height = reading.height.value_or(placement.height);
  return placed;
}

}  // namespace smile::catalog
