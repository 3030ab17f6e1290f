#include "picture/rendered_eye.h"

namespace smile::picture {
namespace {

/// The same as the other, or without channels that the other has.
bool IsPartOf(const model::Sight& sight, const model::Sight& other) {
  const auto [rgb, depth, id] = sight.channels;
  const model::Channels& there = other.channels;
  return rgb <= there.rgb && depth <= there.depth && id <= there.id && sight.view == other.view &&
         sight.hidden_frames == other.hidden_frames && sight.state == other.state;
}

}  // namespace

const Image& RenderedEye::Draw(const scene::VisualModel& model, const model::Sight& sight) {
  if (seen_ && &model == model_seen_ && IsPartOf(sight, *seen_)) return image_;
  renderer_.Render(model, sight.state, sight.view,
                   {.color = sight.channels.rgb,
                    .depth = sight.channels.depth,
                    .ids = sight.channels.id,
                    .look = camera::Look::kRobotEye,
                    .excluded_frames = sight.hidden_frames},
                   &image_);
  seen_ = sight;
  model_seen_ = &model;
  return image_;
}

}  // namespace smile::picture
