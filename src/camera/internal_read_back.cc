#include "camera/internal_read_back.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

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

// Loops over blocks of a fixed size are vectorized by compilers at -O2, others are not.
constexpr std::size_t kBlock = 16;

/// Copies red, green and blue of `count` > 0 pixels.
void CopyColor(const std::uint8_t* rgba, std::size_t count, std::uint8_t* rgb) {
  // Copies four bytes per pixel, as one fast store; the next pixel overwrites the surplus byte. The
  // last pixel has no successor.
  for (; count > 1; --count, rgba += 4, rgb += 3) std::memcpy(rgb, rgba, 4);
  std::memcpy(rgb, rgba, 3);
}

/// Copies the alpha of `count` pixels.
void CopyAlpha(const std::uint8_t* rgba, std::size_t count, std::uint32_t* alphas) {
  std::size_t k = 0;
  if constexpr (std::endian::native == std::endian::little) {
    // Alpha is the highest byte of a pixel.
    for (; k + kBlock <= count; k += kBlock) {
      std::array<std::uint32_t, kBlock> pixels;
      std::memcpy(pixels.data(), rgba + 4 * k, sizeof pixels);
      for (std::uint32_t& pixel : pixels) pixel >>= 24;
      std::memcpy(alphas + k, pixels.data(), sizeof pixels);
    }
  }
  for (; k < count; ++k) alphas[k] = rgba[4 * k + 3];
}

}  // namespace

void ReadBack::ReadRgba(const Framebuffer& picture) {
  // Reads four bytes per pixel, which needs no conversion; the driver converts to three slowly.
  rgba_.resize(4 * NumPixels(picture));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  ReadPixels(picture, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
}

void ReadBack::ReadColor(const Framebuffer& picture, Image* image) {
  ReadRgba(picture);
  image->color.resize(3 * NumPixels(picture));
  CopyColor(rgba_.data(), NumPixels(picture), image->color.data());
}

void ReadBack::ReadIds(const Framebuffer& picture, Image* image) {
  image->ids.resize(NumPixels(picture));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.name());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  ReadPixels(picture, GL_RED_INTEGER, GL_UNSIGNED_INT, image->ids.data());
}

void ReadBack::ReadColorAndIds(const Framebuffer& picture, bool color, Image* image) {
  constexpr std::size_t kPixelsAtOnce = 4096;  // stay in the processor's cache in between
  ReadRgba(picture);
  const std::size_t num_pixels = NumPixels(picture);
  if (color) image->color.resize(3 * num_pixels);
  image->ids.resize(num_pixels);
  for (std::size_t first = 0; first < num_pixels; first += kPixelsAtOnce) {
    const std::size_t count = std::min(kPixelsAtOnce, num_pixels - first);
    const std::uint8_t* rgba = rgba_.data() + 4 * first;
    CopyAlpha(rgba, count, image->ids.data() + first);
    if (color) CopyColor(rgba, count, image->color.data() + 3 * first);
  }
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
  const auto metric = [n, product, span](float stored) {
    return product / (n + (1.0f - stored) * span);
  };
  const std::span<float> depths = image->depth;
  std::size_t k = 0;
  for (; k + kBlock <= depths.size(); k += kBlock) {
    // In two loops, as a compiler may not divide where only the other result counts.
    std::array<float, kBlock> block;
    for (std::size_t i = 0; i < kBlock; ++i) block[i] = metric(depths[k + i]);
    for (std::size_t i = 0; i < kBlock; ++i) {
      depths[k + i] = depths[k + i] < 1.0f ? block[i] : 0.0f;
    }
  }
  for (; k < depths.size(); ++k) depths[k] = depths[k] < 1.0f ? metric(depths[k]) : 0.0f;
}

}  // namespace smile::camera::internal
