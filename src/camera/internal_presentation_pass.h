#pragma once

#include "camera/internal_framebuffer.h"
#include "camera/internal_kept_picture.h"
#include "camera/internal_mesh_store.h"
#include "camera/internal_shadow_map.h"
#include "camera/renderer.h"

namespace smile::camera::internal {

/// Draws pictures for people, with lighting per pixel.
class PresentationPass {
 public:
  PresentationPass();

  /// Returns a picture with sRGB colors (attachment 0) and nothing else.
  /// @param pieces  all present pieces; those outside the view may cast shadows into it.
  /// @param visible  pieces that the camera may see.
  const Framebuffer& Draw(const std::vector<Piece>& pieces, const std::vector<Piece>& visible,
                          const CameraView& view, const RenderOptions& options,
                          const scene::Lighting& lighting, MeshStore* meshes,
                          FramebufferPool* pool);

 private:
  void DrawBackground(const std::optional<Color>& background);
  /// Returns what a picture depends on beside its pieces, after its shadow map is drawn.
  PictureKey KeyOf(const CameraView& view, const RenderOptions& options,
                   const scene::Lighting& lighting) const;
  /// @param cull  matrix by which pieces beside the region to be drawn are left out.
  void DrawPieces(const std::vector<Piece>& visible, const CameraView& view,
                  const scene::Lighting& lighting, const Eigen::Matrix4f& cull, MeshStore* meshes);
  /// Draws a picture, and averages the samples of each pixel (multisample resolve).
  void DrawInto(const Framebuffer& picture, const Framebuffer& resolved,
                const std::vector<Piece>& visible, const PictureKey& key,
                const Eigen::Matrix4f& cull, MeshStore* meshes);

  KeptPictures kept_;
  ShadowMap shadow_map_;
  Program background_program_;
  Program program_;
  VertexArray no_vertices_;
  int samples_ = 0;
};

}  // namespace smile::camera::internal
