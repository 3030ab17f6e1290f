#include "camera/internal_read_back.h"

#include <cstring>

namespace smile::camera::internal {
namespace {

std::size_t NumPixels(const Framebuffer& picture) {
  return static_cast<std::size_t>(picture.layout().width_px) * picture.layout().height_px;
}

void ReadPixels(const Framebuffer& picture, GLenum format, GLenum type, void* pixels) {
  // Rows follow one another without padding, as in Image.
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, picture.layout().width_px, picture.layout().height_px, format, type, pixels);
}

}  // namespace

void ReadBack::ReadColor(const Framebuffer& picture, Image* image) {
  // Reads four bytes per pixel, which needs no conversion; the driver converts to three slowly.
  const std::size_t num_pixels = NumPixels(picture);
  rgba_.resize(4 * num_pixels);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  ReadPixels(picture, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());

  image->color.resize(3 * num_pixels);
  const std::uint8_t* from = rgba_.data();
  std::uint8_t* to = image->color.data();
  // Copies four bytes per pixel, as one fast store; the next pixel overwrites the surplus byte. The
  // last pixel has no successor.
  for (std::size_t k = 0; k + 1 < num_pixels; ++k, from += 4, to += 3) std::memcpy(to, from, 4);
  std::memcpy(to, from, 3);
}

void ReadBack::ReadIds(const Framebuffer& picture, Image* image) {
  image->ids.resize(NumPixels(picture));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  ReadPixels(picture, GL_RED_INTEGER, GL_UNSIGNED_INT, image->ids.data());
}

void ReadBack::ReadDepth(const Framebuffer& picture, double near, double far, Image* image) {
  image->depth.resize(NumPixels(picture));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  ReadPixels(picture, GL_DEPTH_COMPONENT, GL_FLOAT, image->depth.data());

  // OpenGL stores d = far / (far - near) * (1 - near / z). Solves for z by 1 - d, which is exact
  // for d near 1, that is for nearly all pixels. d = 1 is the background. In single precision: the
  // stored depth has no more digits.
  const auto n = static_cast<float>(near), product = static_cast<float>(near * far),
             span = static_cast<float>(far - near);
  for (float& value : image->depth) {
    const float rest = 1.0f - value;
    const float depth = product / (n + rest * span);
    value = rest > 0.0f ? depth : 0.0f;
  }
}

}  // namespace smile::camera::internal
