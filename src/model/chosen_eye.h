#pragma once

#include <string>

#include "model/eye.h"

namespace smile::model {

/// Another eye, with a camera that can be changed between two recordings.
class ChosenEye : public Eye {
 public:
  /// @param eye  draws the pictures; must outlive this.
  explicit ChosenEye(Eye* eye) : eye_(eye), spec_(eye->spec()) {}

  /// @param camera  one of CameraNames() of the models that are drawn.
  void Choose(const std::string& camera) { spec_.camera = camera; }

  const Image& Draw(const scene::VisualModel& model, const ViewSample& sample) override {
    return eye_->Draw(model, sample);
  }
  const EyeSpec& spec() const override { return spec_; }

 private:
  Eye* eye_;
  EyeSpec spec_;
};

}  // namespace smile::model
