#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "math/camera_projection.h"
#include "model/model.h"

namespace smile::model {

/// The eye of the 2015 program, raised above the robot's head; present without a robot, too.
inline constexpr const char* kEyeCamera = "eye";
/// The camera in the robot's screen.
inline constexpr const char* kHeadCamera = "head";

/// Which camera takes pictures, and how large. The angle it sees is the camera's own: 60 degrees
/// from top to bottom for `eye`, 80 from left to right for the robot's others, as given for the
/// scene's. Pixels are square.
struct EyeSpec {
  int width_px = 640;
  int height_px = 480;
  std::string camera = kEyeCamera;  ///< one of CameraNames()

  bool operator==(const EyeSpec&) const = default;
};

/// The cameras there are: `eye`, then the robot's `head` and one in each hand (`left_hand`), then
/// those that stand in the scene.
std::vector<std::string> CameraNames(const Model& model);

/// True of a camera that stands in the scene: not `eye`, and none of the robot's.
bool IsSceneCamera(const Model& model, std::string_view camera);

/// Where a camera is when the robot's joints are at `q` [rad or m; empty without a robot]. Without
/// a robot the eye stays where Baxter's would be, so that a demonstration on an empty table is seen
/// from the same place.
/// @throws std::invalid_argument listing the cameras there are, if it is none of them.
CameraView EyeView(const Model& model, std::span<const double> q, const EyeSpec& spec);

/// Frames of the visual model that a camera must not see: the link it is fixed to; all of a hidden
/// robot.
std::vector<int> FramesHiddenFromEye(const Model& model, bool is_robot_shown,
                                     std::string_view camera);

/// The wanted channels of a picture.
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
