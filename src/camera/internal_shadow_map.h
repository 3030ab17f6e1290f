#pragma once

#include "camera/internal_mesh_store.h"

namespace smile::camera::internal {

/// Which places the light of the presentation look reaches, as seen from the light.
class ShadowMap {
 public:
  ShadowMap();

  /// Redraws the map for those that cast shadows, as finely as what a picture shows allows.
  void Draw(const std::vector<Piece>& pieces, const std::vector<Piece>& visible, MeshStore* meshes);

  /// From world to the map: x, y its texture coordinates, z its depth, each in [0, 1] inside.
  const Eigen::Matrix4f& map_from_world() const { return map_from_world_; }
  /// One step from texel to texel in the world [m].
  double texel_span() const { return texel_span_; }
  void BindTexture() const { glBindTexture(GL_TEXTURE_2D, texture_.name()); }

 private:
  void FitTo(const std::vector<Piece>& casters, const std::vector<Piece>& receivers);

  Program program_;
  GLint clip_from_world_;
  Texture texture_;
  FramebufferName framebuffer_;
  Eigen::Matrix4f map_from_world_ = Eigen::Matrix4f::Identity();
  double texel_span_ = 0;
};

/// From anywhere towards the lamp of the presentation look; unit length.
Vector3 DirectionToLamp();

}  // namespace smile::camera::internal
