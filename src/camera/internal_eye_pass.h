#pragma once

#include "camera/internal_framebuffer.h"
#include "camera/internal_mesh_store.h"
#include "camera/renderer.h"

namespace smile::camera::internal {

/// Draws what a robot sees: color, depth and object ids at once, with light worked out per corner.
class EyePass {
 public:
  EyePass();

  /// The picture holds sRGB colors (attachment 0), ids (attachment 1) and depth; attachments that
  /// `options` does not ask for are left as they were.
  const Framebuffer& Draw(const std::vector<Piece>& visible, const CameraView& view,
                          const RenderOptions& options, MeshStore* meshes, FramebufferPool* pool);

 private:
  Program program_;
  GLint clip_from_world_;
};

}  // namespace smile::camera::internal
