#pragma once

#include <optional>

#include "camera/renderer.h"
#include "model/eye.h"

namespace smile::picture {

/// Eye of the robot that renders. If nothing has changed since the last picture, it returns that
/// one.
class RenderedEye : public model::Eye {
 public:
  explicit RenderedEye(const model::EyeSpec& spec) : spec_(spec) {}

  const Image& Draw(const scene::VisualModel& model, const model::ViewSample& sample) override;
  const model::EyeSpec& spec() const override { return spec_; }

 private:
  model::EyeSpec spec_;
  camera::Renderer renderer_;
  Image image_;
  std::optional<model::ViewSample> seen_;
  const scene::VisualModel* model_seen_ = nullptr;  ///< only compared, never dereferenced
};

}  // namespace smile::picture
