#pragma once

#include <list>
#include <vector>

#include "camera/internal_gl.h"

namespace smile::camera::internal {

/// What a picture in memory is made of.
struct FramebufferLayout {
  int width_px = 0;
  int height_px = 0;
  std::vector<GLenum> color_formats;  ///< of attachments 0, 1, …
  bool has_depth = true;              ///< 32-bit float
  int samples = 0;                    ///< for each pixel; 0 = one, at its center

  bool operator==(const FramebufferLayout&) const = default;
};

/// A picture in the graphics card's memory.
class Framebuffer {
 public:
  /// @throws std::runtime_error when the card refuses, for example for want of memory.
  explicit Framebuffer(const FramebufferLayout& layout);

  const FramebufferLayout& layout() const { return layout_; }
  GLuint name() const { return framebuffer_.name(); }
  /// From now on drawing goes to the whole of this picture.
  void BindForDrawing() const;

 private:
  void Attach(GLenum attachment, GLenum format);

  FramebufferLayout layout_;
  FramebufferName framebuffer_;
  std::vector<Renderbuffer> attachments_;
};

/// Keeps the pictures used last, since the same cameras draw again and again.
class FramebufferPool {
 public:
  static constexpr std::size_t kMostKept = 6;

  /// Stays valid until kMostKept others have been asked for.
  const Framebuffer& Get(const FramebufferLayout& layout);

 private:
  std::list<Framebuffer> framebuffers_;  // the last used in front
};

}  // namespace smile::camera::internal
