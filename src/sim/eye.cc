#include "sim/eye.h"

#include <cmath>
#include <numeric>

#include "math/angles.h"
#include "robot/kinematics.h"

namespace smile::sim {
namespace {

/// Baxter's eye in its base frame at pan 0: lifted 0.2 m above the real camera and tilted down by
/// 56.05 degrees, as the original's was, to overlook the table.
RigidTransform EyeInBase() {
  const double tilt = DegreesToRadians(56.05);
  Matrix3 R_BaseC;  // x right, y down, z forward, seen from a base with x forward, y left, z up
  R_BaseC << 0, -std::sin(tilt), std::cos(tilt),  //
      -1, 0, 0,                                   //
      0, -std::cos(tilt), -std::sin(tilt);
  return {R_BaseC, Vector3(0.18832, 0, 0.95921)};
}

}  // namespace

CameraView EyeView(const Simulation& simulation, const EyeSpec& spec) {
  std::vector<double> q;
  if (simulation.robot() != nullptr) q = simulation.robot()->positions();
  return EyeView(simulation, q, spec);
}

CameraView EyeView(const Simulation& simulation, std::span<const double> q, const EyeSpec& spec) {
  const robot::RobotBody* robot = simulation.robot();
  const RobotPlacement usual;
  const RigidTransform X_WC =
      robot != nullptr && robot->model().head
          ? robot::FramePose(robot->model(), robot->base_pose(), q, robot->model().head->camera)
          : RobotBasePose(simulation.scene().table, usual.gap, usual.height) * EyeInBase();
  return {.intrinsics = CameraIntrinsics::FromVerticalFieldOfView(spec.width_px, spec.height_px,
                                                                  spec.vertical_field_of_view),
          .X_WC = X_WC};
}

std::vector<int> FramesHiddenFromEye(const Simulation& simulation, bool is_robot_shown) {
  const robot::RobotBody* robot = simulation.robot();
  if (robot == nullptr) return {};
  const int base = simulation.first_robot_frame();
  if (is_robot_shown) {
    if (!robot->model().head) return {};
    return {base + 1 + robot->model().frames[robot->model().head->camera].link};
  }
  std::vector<int> frames(1 + robot->model().num_joints());
  std::iota(frames.begin(), frames.end(), base);
  return frames;
}

Sight SightOf(const Simulation& simulation, const EyeSpec& spec) {
  return {.state = simulation.visual_state(),
          .view = EyeView(simulation, spec),
          .hidden_frames = FramesHiddenFromEye(simulation, simulation.is_robot_shown())};
}

}  // namespace smile::sim
