#pragma once

#include "camera/internal_mesh_store.h"

namespace smile::camera::internal {

/// Shadow map of the presentation style: the places that its lamp reaches.
class ShadowMap {
 public:
  ShadowMap();

  /// Redraws the map for the pieces that cast shadows, at the resolution that the visible pieces
  /// allow.
  /// @param to_lamp  direction, of unit length.
  void Draw(const std::vector<Piece>& pieces, const std::vector<Piece>& visible,
            const Vector3& to_lamp, MeshStore* meshes);

  /// Returns the transform from world to map: x, y are texture coordinates, z is depth, each in [0,
  /// 1] inside.
  const Eigen::Matrix4f& map_from_world() const { return map_from_world_; }
  /// Returns the size of a texel in the world [m].
  double texel_span() const { return texel_span_; }
  void BindTexture() const { glBindTexture(GL_TEXTURE_2D, texture_.name()); }

 private:
  void FitTo(const std::vector<Piece>& casters, const std::vector<Piece>& receivers,
             const Vector3& to_lamp);

  Program program_;
  GLint clip_from_world_;
  Texture texture_;
  FramebufferName framebuffer_;
  Eigen::Matrix4f map_from_world_ = Eigen::Matrix4f::Identity();
  double texel_span_ = 0;
};

}  // namespace smile::camera::internal
