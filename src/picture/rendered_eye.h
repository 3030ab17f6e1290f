#pragma once

#include <functional>
#include <optional>

#include "camera/renderer.h"
#include "model/eye.h"

namespace smile::picture {

/// Returns the renderer for the calling thread.
using RendererSource = std::function<camera::Renderer&()>;

/// Eye of the robot that renders. If nothing has changed since the last picture, it returns that
/// one.
class RenderedEye : public model::Eye {
 public:
  /// With a renderer of its own: belongs to the thread that made it.
  explicit RenderedEye(const model::EyeSpec& spec);

  /// Any thread may use and destroy it, one at a time. The pictures are the same.
  RenderedEye(const model::EyeSpec& spec, RendererSource renderer);

  const Image& Draw(const scene::VisualModel& model, const model::ViewSample& sample) override;
  const model::EyeSpec& spec() const override { return spec_; }

 private:
  model::EyeSpec spec_;
  RendererSource renderer_;
  Image image_;
  std::optional<model::ViewSample> seen_;
  const scene::VisualModel* model_seen_ = nullptr;  ///< only compared, never dereferenced
};

}  // namespace smile::picture
