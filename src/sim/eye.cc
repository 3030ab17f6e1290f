#include "sim/eye.h"

namespace smile::sim {

CameraView EyeView(const Simulation& simulation, const EyeSpec& spec) {
  const world::RobotBody* robot = simulation.robot();
  return model::EyeView(simulation.model(),
                        robot != nullptr ? robot->positions() : std::vector<double>(), spec);
}

ViewSample ViewSampleOf(const Simulation& simulation, const EyeSpec& spec) {
  return {.state = simulation.visual_state(),
          .view = EyeView(simulation, spec),
          .hidden_frames = model::FramesHiddenFromEye(simulation.model(),
                                                      simulation.is_robot_shown(), spec.camera)};
}

}  // namespace smile::sim
