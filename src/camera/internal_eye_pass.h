#pragma once

#include "camera/internal_framebuffer.h"
#include "camera/internal_kept_picture.h"
#include "camera/internal_mesh_store.h"
#include "camera/renderer.h"

namespace smile::camera::internal {

/// Draws the view of a robot: color, depth and object ids in one pass, with shading per vertex.
class EyePass {
 public:
  EyePass();

  /// Returns a picture with sRGB colors (attachment 0) and depth; what `options` does not request
  /// is undefined. Ids are the alpha of attachment 0 as long as they fit into its 8 bits, otherwise
  /// attachment 1.
  /// @param pieces  all present pieces.
  /// @param visible  pieces that the camera may see.
  const Framebuffer& Draw(const std::vector<Piece>& pieces, const std::vector<Piece>& visible,
                          const CameraView& view, const RenderOptions& options,
                          const scene::Lighting& lighting, MeshStore* meshes,
                          FramebufferPool* pool);
  /// True for a picture whose ids are attachment 1.
  static bool HasIdsOfTheirOwn(const Framebuffer& picture) {
    return picture.layout().color_formats.size() > 1;
  }

 private:
  void SetLight(const scene::Lighting& lighting);
  /// @param cull  matrix by which pieces beside the region to be drawn are left out.
  void DrawInto(const Framebuffer& picture, const std::vector<Piece>& visible,
                const PictureKey& key, const Eigen::Matrix4f& clip_from_world,
                const Eigen::Matrix4f& cull, MeshStore* meshes);

  KeptPictures kept_;
  Program program_;
  GLint clip_from_world_, light_, to_bright_side_;
};

}  // namespace smile::camera::internal
