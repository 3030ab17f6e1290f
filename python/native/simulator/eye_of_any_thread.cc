#include "eye_of_any_thread.h"

namespace smile::python {

camera::Renderer& RendererOfThread() {
  thread_local camera::Renderer renderer;
  return renderer;
}

const Image& EyeOfAnyThread::Draw(const scene::VisualModel& model,
                                  const model::ViewSample& sample) {
  if (model_seen_ == &model && seen_ == sample) return image_;
  seen_.reset();
  RendererOfThread().Render(model, sample.state, sample.view,
                            {.color = sample.channels.rgb,
                             .depth = sample.channels.depth,
                             .ids = sample.channels.id,
                             .style = camera::RenderStyle::kRobotEye,
                             .excluded_frames = sample.hidden_frames},
                            &image_);
  seen_ = sample;
  model_seen_ = &model;
  return image_;
}

}  // namespace smile::python
