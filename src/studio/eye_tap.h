#pragma once

#include <optional>
#include <utility>

#include "sim/eye.h"

namespace smile::studio {

/// The robot's eye, whose pictures are kept: what a recorder takes is what people see.
class EyeTap : public sim::Eye {
 public:
  explicit EyeTap(sim::Eye* eye) : eye_(eye) {}
  /// From now on through this one, with the same spec.
  void SetEye(sim::Eye* eye) { eye_ = eye; }

  const Image& Draw(const scene::VisualModel& model, const sim::Sight& sight) override {
    const Image& image = eye_->Draw(model, sight);
    taken_ = image;
    return image;
  }
  const sim::EyeSpec& spec() const override { return eye_->spec(); }

  /// The last picture since this was last asked.
  std::optional<Image> Take() { return std::exchange(taken_, std::nullopt); }

 private:
  sim::Eye* eye_;
  std::optional<Image> taken_;
};

}  // namespace smile::studio
