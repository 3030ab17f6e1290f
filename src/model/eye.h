#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/camera_projection.h"
#include "model/model.h"

namespace smile::model {

/// Camera of the 2015 program, raised above the robot's head; also present without a robot.
inline constexpr const char* kEyeCamera = "eye";
/// Camera in the robot's screen.
inline constexpr const char* kHeadCamera = "head";

/// Selects a camera and the size of its pictures. The field of view is the camera's own: 60 degrees
/// vertically for `eye`, 80 horizontally for the robot's others, as specified for the scene's.
/// Pixels are square.
struct EyeSpec {
  int width_px = 640;
  int height_px = 480;
  std::string camera = kEyeCamera;  ///< one of CameraNames()

  bool operator==(const EyeSpec&) const = default;
};

/// Returns the names of all cameras: `eye`, then the robot's `head` and one in each hand
/// (`left_hand`), then those of the scene.
std::vector<std::string> CameraNames(const Model& model);

/// Returns true for a camera of the scene: not `eye`, and none of the robot's.
bool IsSceneCamera(const Model& model, std::string_view camera);

/// Returns the view of a camera with the robot's joints at `q` [rad or m; empty without a robot].
/// Without a robot the eye is where Baxter's would be, so that a demonstration on an empty table
/// has the same view.
/// @throws std::invalid_argument listing all cameras, if there is no such camera.
CameraView EyeView(const Model& model, std::span<const double> q, const EyeSpec& spec);

/// Returns the frames of the visual model that a camera must not see: the link it is fixed to; all
/// frames of a hidden robot.
std::vector<int> FramesHiddenFromEye(const Model& model, bool is_robot_shown,
                                     std::string_view camera);

/// Requested channels of a picture.
struct Channels {
  bool rgb = true, depth = false, id = false;

  bool operator==(const Channels&) const = default;
};

/// Sample of a visual model for a camera: the state and the view to render.
struct ViewSample {
  scene::VisualState state;
  CameraView view;
  std::vector<int> hidden_frames;
  Channels channels;

  bool operator==(const ViewSample&) const = default;
};

/// Takes pictures with the robot's cameras. Implemented where there are graphics, so that recorders
/// and brains need none.
class Eye {
 public:
  virtual ~Eye() = default;
  /// Returns the picture of a sample, with the channels that it requests or more. It is valid until
  /// the next call.
  virtual const Image& Draw(const scene::VisualModel& model, const ViewSample& sample) = 0;
  /// Returns the camera that is the robot's eye.
  virtual const EyeSpec& spec() const = 0;
};

}  // namespace smile::model
