#include "record/sight.h"

#include "robot/robot_visuals.h"

namespace smile::record {

scene::VisualState VisualStateAt(const TraceTick& moment, const sim::Simulation& stage) {
  scene::VisualState state;
  std::vector<bool> is_present;
  for (const TracePose& object : moment.objects) {
    state.poses.push_back(object.pose_in_world());
    is_present.push_back(object.is_present);
  }
  state.looks = stage.tabletop().LooksAt(moment.controls, is_present);
  if (const robot::RobotBody* robot = stage.robot()) {
    const auto robot_poses = robot::FramePosesOf(robot->model(), robot->base_pose(), moment.joints);
    state.poses.insert(state.poses.end(), robot_poses.begin(), robot_poses.end());
    state.looks.push_back(robot::LookOf(moment.mood));
  }
  return state;
}

sim::Sight SightAt(const TraceTick& moment, const sim::Simulation& stage,
                   const sim::EyeSpec& spec) {
  return {.state = VisualStateAt(moment, stage),
          .view = sim::EyeView(stage, moment.joints, spec),
          .hidden_frames = sim::FramesHiddenFromEye(stage, moment.is_robot_shown, spec.camera)};
}

std::optional<sim::EyeSpec> EyeOf(const DemoInfo& info) {
  if (!info.eye) return std::nullopt;
  return sim::EyeSpec{.width_px = info.eye->intrinsics.width_px,
                      .height_px = info.eye->intrinsics.height_px,
                      .camera = info.eye_camera};
}

}  // namespace smile::record
