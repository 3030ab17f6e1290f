#pragma once

#include "camera/internal_framebuffer.h"
#include "image/image.h"

namespace smile::camera::internal {

/// Copies pictures from the graphics card to memory. Keeps its buffers for the next picture.
class ReadBack {
 public:
  /// Reads red, green and blue of attachment 0 into image->color.
  void ReadColor(const Framebuffer& picture, Image* image);
  /// Reads ids of attachment 1 into image->ids.
  void ReadIds(const Framebuffer& picture, Image* image);
  /// Reads ids of the alpha of attachment 0 into image->ids, and its color if requested.
  void ReadColorAndIds(const Framebuffer& picture, bool color, Image* image);
  /// Reads depth [m] into image->depth; near and far are the camera's planes [m].
  void ReadDepth(const Framebuffer& picture, double near, double far, Image* image);

 private:
  void ReadRgba(const Framebuffer& picture);

  std::vector<std::uint8_t> rgba_;
};

}  // namespace smile::camera::internal
