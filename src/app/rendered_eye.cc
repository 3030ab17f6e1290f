#include "app/rendered_eye.h"

namespace smile::app {

const Image& RenderedEye::Look(const sim::Simulation& simulation) {
  scene::VisualState state = simulation.visual_state();
  std::vector<int> hidden = sim::FramesHiddenFromEye(simulation);
  if (state == seen_ && hidden == seen_hidden_) return image_;
  renderer_.Render(simulation.visual_model(), state, sim::EyeView(simulation, spec_),
                   {.look = camera::Look::kRobotEye, .excluded_frames = hidden}, &image_);
  seen_ = std::move(state);
  seen_hidden_ = std::move(hidden);
  return image_;
}

}  // namespace smile::app
