#include "app/rendered_eye.h"

namespace smile::app {

const Image& RenderedEye::Look(const sim::Simulation& simulation) {
  scene::FramePoses poses = simulation.frame_poses();
  std::vector<int> hidden = sim::FramesHiddenFromEye(simulation);
  if (poses == seen_poses_ && hidden == seen_hidden_) return image_;
  renderer_.Render(simulation.visual_model(), poses, sim::EyeView(simulation, spec_),
                   {.look = camera::Look::kRobotEye, .excluded_frames = hidden}, &image_);
  seen_poses_ = std::move(poses);
  seen_hidden_ = std::move(hidden);
  return image_;
}

}  // namespace smile::app
