#pragma once

#include "camera/internal_framebuffer.h"
#include "camera/internal_mesh_store.h"
#include "camera/renderer.h"

namespace smile::camera::internal {

/// Draws the view of a robot: color, depth and object ids in one pass, with shading per vertex.
class EyePass {
 public:
  EyePass();

  /// Returns a picture with sRGB colors (attachment 0), ids (attachment 1) and depth; attachments
  /// that `options` does not request are undefined.
  const Framebuffer& Draw(const std::vector<Piece>& visible, const CameraView& view,
                          const RenderOptions& options, MeshStore* meshes, FramebufferPool* pool);

 private:
  Program program_;
  GLint clip_from_world_;
};

}  // namespace smile::camera::internal
