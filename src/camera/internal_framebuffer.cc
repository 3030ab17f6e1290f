#include "camera/internal_framebuffer.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace smile::camera::internal {

Framebuffer::Framebuffer(const FramebufferLayout& layout) : layout_(layout) {
  glBindFramebuffer(GL_FRAMEBUFFER, name());
  std::vector<GLenum> draw_buffers;
  for (const GLenum format : layout.color_formats) {
    draw_buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(draw_buffers.size()));
    Attach(draw_buffers.back(), format);
  }
  // Depths of 32-bit floats keep their precision at a distance.
  if (layout.has_depth) Attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F);
  glDrawBuffers(static_cast<GLsizei>(draw_buffers.size()), draw_buffers.data());
  CheckGl("glRenderbufferStorage");
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL: glCheckFramebufferStatus: no picture of " +
                             std::to_string(layout.width_px) + "x" +
                             std::to_string(layout.height_px) + " pixels can be created");
  }
}

void Framebuffer::Attach(GLenum attachment, GLenum format) {
  const GLuint buffer = attachments_.emplace_back().name();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  // With 0 samples this is an ordinary buffer.
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, layout_.samples, format, layout_.width_px,
                                   layout_.height_px);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

void Framebuffer::BindForDrawing() const {
  glBindFramebuffer(GL_FRAMEBUFFER, name());
  glViewport(0, 0, layout_.width_px, layout_.height_px);
}

const Framebuffer& FramebufferPool::Get(const FramebufferLayout& layout) {
  const auto found = std::ranges::find(framebuffers_, layout, &Framebuffer::layout);
  if (found != framebuffers_.end()) {
    // The list is in order of last use; splice() keeps references valid.
    framebuffers_.splice(framebuffers_.begin(), framebuffers_, found);
  } else {
    framebuffers_.emplace_front(layout);
    // Each costs some megabytes of graphics memory.
    if (framebuffers_.size() > kMostKept) framebuffers_.pop_back();
  }
  return framebuffers_.front();
}

}  // namespace smile::camera::internal
