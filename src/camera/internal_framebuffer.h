#pragma once

#include <list>
#include <vector>

#include "camera/internal_gl.h"

namespace smile::camera::internal {

/// Layout of a framebuffer.
struct FramebufferLayout {
  int width_px = 0;
  int height_px = 0;
  std::vector<GLenum> color_formats;  ///< of attachments 0, 1, …
  bool has_depth = true;              ///< 32-bit float
  int samples = 0;                    ///< for each pixel; 0 = one, at its center

  bool operator==(const FramebufferLayout&) const = default;
};

/// Framebuffer in the memory of the graphics card.
class Framebuffer {
 public:
  /// @throws std::runtime_error if the card refuses, for example because memory is exhausted.
  explicit Framebuffer(const FramebufferLayout& layout);

  const FramebufferLayout& layout() const { return layout_; }
  GLuint name() const { return framebuffer_.name(); }
  /// Makes the whole framebuffer the target of drawing.
  void BindForDrawing() const;

 private:
  void Attach(GLenum attachment, GLenum format);

  FramebufferLayout layout_;
  FramebufferName framebuffer_;
  std::vector<Renderbuffer> attachments_;
};

/// Cache of the framebuffers used last, since the same cameras draw again and again.
class FramebufferPool {
 public:
  static constexpr std::size_t kMostKept = 6;

  /// Returns a framebuffer of this layout; it stays valid until kMostKept others have been
  /// requested.
  const Framebuffer& Get(const FramebufferLayout& layout);

 private:
  std::list<Framebuffer> framebuffers_;  // the last used in front
};

}  // namespace smile::camera::internal
