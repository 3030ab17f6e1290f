#pragma once

#include <optional>
#include <vector>

#include "camera/internal_mesh_store.h"

namespace smile::camera::internal {

/// Shadow map of the presentation style: the places that its lamp reaches.
///
/// Of pictures one after another, most pieces stand still. These are drawn once, and what they hide
/// is copied; a map holds the nearest depth, so it has the same bits in whatever order it is drawn.
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
  void BindTexture() const { map_.BindTexture(); }

 private:
  /// Depth picture from the lamp.
  class Layer {
   public:
    Layer();
    void BindTexture() const { glBindTexture(GL_TEXTURE_2D, texture_.name()); }
    /// Makes it what is drawn into, with no pieces.
    void Begin() const;
    /// Makes it what is drawn into, with the pieces of another layer.
    void BeginWith(const Layer& other) const;

   private:
    Texture texture_;
    FramebufferName framebuffer_;
  };

  void FitTo(const std::vector<Piece>& casters, const std::vector<Piece>& receivers,
             const Vector3& to_lamp);
  /// Returns which casters are as in the last picture; nothing if the map is another one.
  std::vector<bool> StandsStill(const std::vector<Piece>& casters) const;
  void RenewStillLayer(const std::vector<Piece>& casters, const std::vector<bool>& stands_still,
                       const Eigen::Matrix4f& clip_from_world, MeshStore* meshes);
  /// Prepares drawing of casters; returns the matrix for it.
  Eigen::Matrix4f BeginCasters() const;
  /// Draws the casters that are in the layer of what stands still, or the others.
  void DrawCasters(const std::vector<Piece>& casters, bool stand_still,
                   const Eigen::Matrix4f& clip_from_world, MeshStore* meshes) const;

  Program program_;
  GLint clip_from_world_;
  Layer map_;
  std::optional<Layer> still_;       ///< of the casters that stand still; made on first use
  std::vector<bool> is_in_still_;    ///< of each caster; empty: none
  int still_age_ = 0;                ///< number of pictures since it was drawn
  std::vector<Piece> last_casters_;  ///< in the map
  Eigen::Matrix4f last_map_from_world_ = Eigen::Matrix4f::Zero();
  Eigen::Matrix4f map_from_world_ = Eigen::Matrix4f::Identity();
  double texel_span_ = 0;
};

}  // namespace smile::camera::internal
