#pragma once

#include "camera/internal_framebuffer.h"
#include "image/image.h"

namespace smile::camera::internal {

/// Copies pictures out of the graphics card. Holds the memory it needs on the way.
class ReadBack {
 public:
  /// Red, green, blue of attachment 0 -> image->color.
  void ReadColor(const Framebuffer& picture, Image* image);
  /// Ids of attachment 1 -> image->ids.
  void ReadIds(const Framebuffer& picture, Image* image);
  /// Depth [m] as seen with these planes -> image->depth.
  void ReadDepth(const Framebuffer& picture, double near, double far, Image* image);

 private:
  std::vector<std::uint8_t> rgba_;
};

}  // namespace smile::camera::internal
