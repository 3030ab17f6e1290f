#include "sim/eye.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "base/wording.h"
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

/// Of the 2015 program, from top to bottom.
constexpr double kEyeAngle = DegreesToRadians(60.0);
/// Of Baxter's three cameras, from left to right: what its makers' own simulator had.
constexpr double kRobotCameraAngle = DegreesToRadians(80.0);

/// The frame of a robot that is a camera; nullopt if it has none of this name.
std::optional<int> FrameOf(const robot::RobotModel& model, std::string_view camera) {
  if (camera == kEyeCamera) return model.head ? std::optional(model.head->camera) : std::nullopt;
  if (camera == kHeadCamera) return FindFrame(model, "head_camera");
  for (const robot::Arm& arm : model.arms) {
    if (camera == arm.name + "_hand") return FindFrame(model, arm.name + "_hand_camera");
  }
  return std::nullopt;
}

const scene::CameraSpec* FindSceneCamera(const Simulation& simulation, std::string_view camera) {
  const auto& cameras = simulation.scene().cameras;
  const auto found = std::ranges::find(cameras, camera, &scene::CameraSpec::id);
  return found == cameras.end() ? nullptr : &*found;
}

CameraView ViewOf(const scene::CameraSpec& camera, const EyeSpec& spec) {
  CameraView view{.intrinsics = CameraIntrinsics::FromVerticalFieldOfView(
                      spec.width_px, spec.height_px, camera.vertical_field_of_view),
                  .X_WC = LookAt(camera.p_WC, camera.p_WQ, camera.up_in_world)};
  // What it looks at shall be seen from any distance.
  view.intrinsics.far = std::max(view.intrinsics.far, 2 * (camera.p_WQ - camera.p_WC).norm());
  return view;
}

/// Where Baxter's eye would be.
RigidTransform EyeWithoutRobot(const Simulation& simulation) {
  const RobotPlacement usual;
  return RobotBasePose(simulation.scene().table, usual.gap, usual.height) * EyeInBase();
}

[[noreturn]] void RefuseCamera(const Simulation& simulation, const std::string& camera) {
  const std::vector<std::string> names = CameraNames(simulation);
  const std::vector<std::string_view> words(names.begin(), names.end());
  throw std::invalid_argument("camera is " + Quoted(camera) + ", expected " + OneOf(words) +
                              DidYouMean(camera, words));
}

}  // namespace

std::vector<std::string> CameraNames(const Simulation& simulation) {
  std::vector<std::string> names{kEyeCamera};
  if (const robot::RobotBody* robot = simulation.robot()) {
    std::vector<std::string> mounted{kHeadCamera};
    for (const robot::Arm& arm : robot->model().arms) mounted.push_back(arm.name + "_hand");
    for (const std::string& name : mounted) {
      if (FrameOf(robot->model(), name)) names.push_back(name);
    }
  }
  for (const scene::CameraSpec& camera : simulation.scene().cameras) {
    // A robot may have an arm whose camera has the name of one of the scene's: EyeView() takes it.
    if (std::ranges::find(names, camera.id) == names.end()) names.push_back(camera.id);
  }
  return names;
}

CameraView EyeView(const Simulation& simulation, const EyeSpec& spec) {
  std::vector<double> q;
  if (simulation.robot() != nullptr) q = simulation.robot()->positions();
  return EyeView(simulation, q, spec);
}

CameraView EyeView(const Simulation& simulation, std::span<const double> q, const EyeSpec& spec) {
  const robot::RobotBody* robot = simulation.robot();
  const auto frame = robot != nullptr ? FrameOf(robot->model(), spec.camera) : std::nullopt;
  const bool is_eye = spec.camera == kEyeCamera;
  if (!frame && !is_eye) {
    const scene::CameraSpec* camera = FindSceneCamera(simulation, spec.camera);
    if (camera == nullptr) RefuseCamera(simulation, spec.camera);
    return ViewOf(*camera, spec);
  }
  return {.intrinsics = is_eye ? CameraIntrinsics::FromVerticalFieldOfView(
                                     spec.width_px, spec.height_px, kEyeAngle)
                               : CameraIntrinsics::FromHorizontalFieldOfView(
                                     spec.width_px, spec.height_px, kRobotCameraAngle),
          .X_WC = frame ? robot::FramePose(robot->model(), robot->base_pose(), q, *frame)
                        : EyeWithoutRobot(simulation)};
}

std::vector<int> FramesHiddenFromEye(const Simulation& simulation, bool is_robot_shown,
                                     std::string_view camera) {
  const robot::RobotBody* robot = simulation.robot();
  if (robot == nullptr) return {};
  const int base = simulation.first_robot_frame();
  if (is_robot_shown) {
    // The head's cameras sit within it; those of the hands look through a lens that is drawn.
    const auto frame = FrameOf(robot->model(), camera);
    if (!frame) return {};
    return {base + 1 + robot->model().frames[*frame].link};
  }
  std::vector<int> frames(1 + robot->model().num_joints());
  std::iota(frames.begin(), frames.end(), base);
  return frames;
}

Sight SightOf(const Simulation& simulation, const EyeSpec& spec) {
  return {
      .state = simulation.visual_state(),
      .view = EyeView(simulation, spec),
      .hidden_frames = FramesHiddenFromEye(simulation, simulation.is_robot_shown(), spec.camera)};
}

}  // namespace smile::sim
