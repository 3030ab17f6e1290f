#pragma once

#include <cstdint>

#include "sim/eye.h"

namespace smile::recorder {

/// An eye that paints the number of pictures so far, so that they are distinguishable.
class PaintedEye : public sim::Eye {
 public:
  const Image& Draw(const scene::VisualModel&, const sim::ViewSample&) override {
    ++num_pictures_;
    image_.color.assign(static_cast<std::size_t>(spec_.width_px) * spec_.height_px * 3,
                        static_cast<std::uint8_t>(num_pictures_));
    return image_;
  }
  const sim::EyeSpec& spec() const override { return spec_; }
  int num_pictures() const { return num_pictures_; }

 private:
  sim::EyeSpec spec_{.width_px = 8, .height_px = 6};
  Image image_{.width_px = 8, .height_px = 6};
  int num_pictures_ = 0;
};

}  // namespace smile::recorder
