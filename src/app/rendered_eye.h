#pragma once

#include "camera/renderer.h"
#include "sim/eye.h"

namespace smile::app {

/// The robot's eye, drawn. When nothing moved since the last look, it hands out the last picture.
class RenderedEye : public sim::Eye {
 public:
  explicit RenderedEye(const sim::EyeSpec& spec) : spec_(spec) {}

  const Image& Look(const sim::Simulation& simulation) override;
  const sim::EyeSpec& spec() const override { return spec_; }

 private:
  sim::EyeSpec spec_;
  camera::Renderer renderer_;
  Image image_;
  scene::VisualState seen_;
  std::vector<int> seen_hidden_;
};

}  // namespace smile::app
