#pragma once

#include <optional>

#include "camera/renderer.h"
#include "sim/eye.h"

namespace smile::picture {

/// The robot's eye, drawn. When nothing moved since the last look, it hands out the last picture.
class RenderedEye : public sim::Eye {
 public:
  explicit RenderedEye(const sim::EyeSpec& spec) : spec_(spec) {}

  const Image& Draw(const scene::VisualModel& model, const sim::Sight& sight) override;
  const sim::EyeSpec& spec() const override { return spec_; }

 private:
  sim::EyeSpec spec_;
  camera::Renderer renderer_;
  Image image_;
  std::optional<sim::Sight> seen_;
};

}  // namespace smile::picture
