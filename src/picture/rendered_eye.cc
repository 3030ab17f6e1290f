#include "picture/rendered_eye.h"

#include <memory>
#include <utility>

namespace smile::picture {
namespace {

/// True if a sample is equal to the other, or has fewer channels.
bool IsPartOf(const model::ViewSample& sample, const model::ViewSample& other) {
  const auto [rgb, depth, id] = sample.channels;
  const model::Channels& there = other.channels;
  return rgb <= there.rgb && depth <= there.depth && id <= there.id && sample.view == other.view &&
         sample.hidden_frames == other.hidden_frames && sample.state == other.state;
}

}  // namespace

RenderedEye::RenderedEye(const model::EyeSpec& spec)
    : RenderedEye(
          spec, [own = std::make_shared<camera::Renderer>()]() -> auto& { return *own; }) {}

RenderedEye::RenderedEye(const model::EyeSpec& spec, RendererSource renderer)
    : spec_(spec), renderer_(std::move(renderer)) {}

const Image& RenderedEye::Draw(const scene::VisualModel& model, const model::ViewSample& sample) {
  // The last picture is kept: recorder, brain and preview often ask for the same moment. Rendering
  // is a function of the sample, so the bytes are the same.
  if (seen_ && &model == model_seen_ && IsPartOf(sample, *seen_)) return image_;
  renderer_().Render(model, sample.state, sample.view,
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

}  // namespace smile::picture
