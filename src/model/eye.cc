#include "model/eye.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/wording.h"
#include "math/angles.h"
#include "robot/kinematics.h"

namespace smile::model {
namespace {

/// Returns Baxter's eye in its base frame at pan 0: raised 0.2 m above the real camera and tilted
/// down by 56.05 degrees, as in the original, to see the whole table.
RigidTransform EyeInBase() {
  const double tilt = DegreesToRadians(56.05);
  Matrix3 R_BaseC;  // x right, y down, z forward, seen from a base with x forward, y left, z up
  R_BaseC << 0, -std::sin(tilt), std::cos(tilt),  //
      -1, 0, 0,                                   //
      0, -std::cos(tilt), -std::sin(tilt);
  return {R_BaseC, Vector3(0.18832, 0, 0.95921)};
}

/// Vertical field of view of the 2015 program.
constexpr double kEyeAngle = DegreesToRadians(60.0);
/// Horizontal field of view of Baxter's three cameras, as in the manufacturer's simulator.
constexpr double kRobotCameraAngle = DegreesToRadians(80.0);
/// The widest field of view that an offset may give a camera of the scene.
constexpr double kMaxAngle = DegreesToRadians(170.0);

/// Returns the index of a camera's frame on the robot; nullopt if it has no such camera.
std::optional<int> FrameOf(const robot::RobotModel& robot, std::string_view camera) {
  // The robot's description places `eye` on the head, so that it turns with it.
  if (camera == kEyeCamera) return robot.head ? std::optional(robot.head->camera) : std::nullopt;
  if (camera == kHeadCamera) return FindFrame(robot, "head_camera");
  for (const robot::Arm& arm : robot.arms) {
    if (camera == arm.name + "_hand") return FindFrame(robot, arm.name + "_hand_camera");
  }
  return std::nullopt;
}

const scene::CameraSpec* FindSceneCamera(const Model& model, std::string_view camera) {
  const auto& cameras = model.scene().cameras;
  const auto found = std::ranges::find(cameras, camera, &scene::CameraSpec::id);
  return found == cameras.end() ? nullptr : &*found;
}

/// Returns the view of a camera of the scene.
/// @param scale  factor of its field of view.
CameraView ViewOf(const scene::CameraSpec& camera, const EyeSpec& spec, double scale) {
  const double angle = std::min(scale * camera.vertical_field_of_view, kMaxAngle);
  CameraView view{
      .intrinsics = CameraIntrinsics::FromVerticalFieldOfView(spec.width_px, spec.height_px, angle),
      .X_WC = LookAt(camera.p_WC, camera.p_WQ, camera.up_in_world)};
  // The target must be visible from any distance.
  view.intrinsics.far = std::max(view.intrinsics.far, 2 * (camera.p_WQ - camera.p_WC).norm());
  return view;
}

/// Returns the pose of Baxter's eye at the default place.
RigidTransform EyeWithoutRobot(const Model& model) {
  // The defaults of a placement are those of a table with Baxter.
  const RobotPlacement usual;
  return RobotBasePose(model.scene().table, usual.gap, usual.height) * EyeInBase();
}

[[noreturn]] void RefuseCamera(const Model& model, const std::string& camera) {
  const std::vector<std::string> names = CameraNames(model);
  const std::vector<std::string_view> words(names.begin(), names.end());
  throw std::invalid_argument("camera is " + Quoted(camera) + ", expected " + OneOf(words) +
                              DidYouMean(camera, words));
}

/// Returns the view of a camera that nothing displaces.
/// @param scale  factor of its field of view.
CameraView ViewInPlace(const Model& model, std::span<const double> q, const EyeSpec& spec,
                       double scale) {
  if (IsSceneCamera(model, spec.camera)) {
    return ViewOf(*FindSceneCamera(model, spec.camera), spec, scale);
  }
  const robot::RobotModel* robot = model.robot();
  // A robot without a head has no eye of its own: the fixed one is used, as without a robot.
  const auto frame = robot != nullptr ? FrameOf(*robot, spec.camera) : std::nullopt;
  const bool is_eye = spec.camera == kEyeCamera;
  if (!frame && !is_eye) RefuseCamera(model, spec.camera);
  return {.intrinsics = is_eye ? CameraIntrinsics::FromVerticalFieldOfView(
                                     spec.width_px, spec.height_px, scale * kEyeAngle)
                               : CameraIntrinsics::FromHorizontalFieldOfView(
                                     spec.width_px, spec.height_px, scale * kRobotCameraAngle),
          .X_WC = frame ? robot::FramePose(*robot, model.robot_base_pose(), q, *frame)
                        : EyeWithoutRobot(model)};
}

}  // namespace

std::vector<std::string> CameraNames(const Model& model) {
  std::vector<std::string> names{kEyeCamera};
  if (const robot::RobotModel* robot = model.robot()) {
    std::vector<std::string> mounted{kHeadCamera};
    for (const robot::Arm& arm : robot->arms) mounted.push_back(arm.name + "_hand");
    for (const std::string& name : mounted) {
      if (FrameOf(*robot, name)) names.push_back(name);
    }
  }
  for (const scene::CameraSpec& camera : model.scene().cameras) {
    // A camera of the robot takes precedence over one of the scene with the same name, as in
    // EyeView().
    if (std::ranges::find(names, camera.id) == names.end()) names.push_back(camera.id);
  }
  return names;
}

bool IsSceneCamera(const Model& model, std::string_view camera) {
  const robot::RobotModel* robot = model.robot();
  if (camera == kEyeCamera || (robot != nullptr && FrameOf(*robot, camera))) return false;
  return FindSceneCamera(model, camera) != nullptr;
}

CameraView EyeView(const Model& model, std::span<const double> q, const EyeSpec& spec) {
  const auto& offsets = model.scene().camera_offsets;
  const auto offset = std::ranges::find(offsets, spec.camera, &scene::CameraOffset::camera);
  if (offset == offsets.end()) return ViewInPlace(model, q, spec, 1);
  CameraView view = ViewInPlace(model, q, spec, offset->view_angle_scale);
  view.X_WC = view.X_WC * offset->X_CD;
  return view;
}

std::vector<int> FramesHiddenFromEye(const Model& model, bool is_robot_shown,
                                     std::string_view camera) {
  const robot::RobotModel* robot = model.robot();
  if (robot == nullptr) return {};
  if (is_robot_shown) {
    // The head's cameras are inside it; those of the hands look through a drawn lens.
    const auto frame = FrameOf(*robot, camera);
    if (!frame) return {};
    return {static_cast<int>(model.frame_of(robot->frames[static_cast<std::size_t>(*frame)]))};
  }
  std::vector<int> frames;
  for (FrameIndex frame : model.robot_frames()) frames.push_back(static_cast<int>(frame));
  return frames;
}

}  // namespace smile::model
