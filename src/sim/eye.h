#pragma once

#include <span>
#include <vector>

#include "math/camera_projection.h"
#include "math/image.h"
#include "sim/simulation.h"

namespace smile::sim {

/// What the robot's eye is like: the original's camera has 60 degrees from top to bottom.
struct EyeSpec {
  int width_px = 640;
  int height_px = 480;
  double vertical_field_of_view = 1.0471975511965976;  ///< [rad]

  bool operator==(const EyeSpec&) const = default;
};

/// Where the eye is now. Without a robot it stays where Baxter's would be, so that a demonstration
/// on an empty table is seen from the same place.
CameraView EyeView(const Simulation& simulation, const EyeSpec& spec);
/// Where it is when the robot's joints are at `q` [rad or m], for recorded moments; `q` is empty
/// without a robot.
CameraView EyeView(const Simulation& simulation, std::span<const double> q, const EyeSpec& spec);

/// Frames of the visual model the eye must not see: the head it sits in; all of a hidden robot.
std::vector<int> FramesHiddenFromEye(const Simulation& simulation, bool is_robot_shown);

/// One moment of a simulation's visual model, as its eye sees it.
struct Sight {
  scene::VisualState state;
  CameraView view;
  std::vector<int> hidden_frames;

  bool operator==(const Sight&) const = default;
};
/// The present moment.
Sight SightOf(const Simulation& simulation, const EyeSpec& spec);

/// Takes pictures with the robot's eye. Fulfilled by whoever can draw, so that recorders and brains
/// need no graphics.
class Eye {
 public:
  virtual ~Eye() = default;
  /// The picture of a moment; color only. It lasts until the next one is drawn.
  virtual const Image& Draw(const scene::VisualModel& model, const Sight& sight) = 0;
  virtual const EyeSpec& spec() const = 0;

  /// The picture of the present state.
  const Image& Look(const Simulation& simulation) {
    return Draw(simulation.visual_model(), SightOf(simulation, spec()));
  }
};

}  // namespace smile::sim
