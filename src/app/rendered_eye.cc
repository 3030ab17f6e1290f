#include "app/rendered_eye.h"

namespace smile::app {

const Image& RenderedEye::Draw(const scene::VisualModel& model, const sim::Sight& sight) {
  if (sight == seen_) return image_;
  renderer_.Render(model, sight.state, sight.view,
                   {.look = camera::Look::kRobotEye, .excluded_frames = sight.hidden_frames},
                   &image_);
  seen_ = sight;
  return image_;
}

}  // namespace smile::app
