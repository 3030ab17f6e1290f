#pragma once

#include <optional>
#include <utility>

#include "sim/eye.h"

namespace smile::studio {

/// Capturing eye: keeps the last picture that another eye draws, so that people see what is
/// recorded.
class CapturingEye : public sim::Eye {
 public:
  explicit CapturingEye(sim::Eye* eye) : eye_(eye) {}
  /// Replaces the wrapped eye; the new one must have the same camera and size.
  void SetEye(sim::Eye* eye) { eye_ = eye; }

  const Image& Draw(const scene::VisualModel& model, const sim::ViewSample& sample) override {
    const Image& image = eye_->Draw(model, sample);
    captured_ = image;
    return image;
  }
  const sim::EyeSpec& spec() const override { return eye_->spec(); }

  /// Returns the last picture since the last call.
  std::optional<Image> Take() { return std::exchange(captured_, std::nullopt); }

 private:
  sim::Eye* eye_;
  std::optional<Image> captured_;
};

}  // namespace smile::studio
