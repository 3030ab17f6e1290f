#pragma once

#include <optional>
#include <utility>

#include "camera/renderer.h"
#include "model/eye.h"

namespace smile::python {

/// Returns the renderer of this thread: an OpenGL context belongs to the thread that made it.
camera::Renderer& RendererOfThread();

/// Eye of the robot that any thread may use and destroy, one at a time, as simulations in Python
/// are: each draws with its own renderer. The pictures are the same.
class EyeOfAnyThread : public model::Eye {
 public:
  explicit EyeOfAnyThread(model::EyeSpec spec) : spec_(std::move(spec)) {}

  const Image& Draw(const scene::VisualModel& model, const model::ViewSample& sample) override;
  const model::EyeSpec& spec() const override { return spec_; }

 private:
  model::EyeSpec spec_;
  Image image_;
  std::optional<model::ViewSample> seen_;           ///< in `image_`
  const scene::VisualModel* model_seen_ = nullptr;  ///< only compared, never dereferenced
};

}  // namespace smile::python
