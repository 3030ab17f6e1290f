#pragma once

#include <list>
#include <optional>
#include <vector>

#include "camera/internal_framebuffer.h"
#include "camera/internal_mesh_store.h"
#include "camera/internal_pieces.h"
#include "math/camera_projection.h"
#include "math/color.h"
#include "scene/lighting.h"

namespace smile::camera::internal {

/// Rectangle of pixels, from `left`, `top` up to but not including `right`, `bottom`.
struct PixelRectangle {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool is_empty() const { return left >= right || top >= bottom; }
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/// What a picture depends on, apart from where its pieces are.
struct PictureKey {
  CameraView view;
  scene::Lighting lighting;
  std::optional<Color> background;
  std::vector<FramebufferLayout> layouts;  ///< of its framebuffers
  bool color = true, depth = false, ids = false;
  Eigen::Matrix4f map_from_world = Eigen::Matrix4f::Identity();  ///< of shadows

  bool operator==(const PictureKey&) const = default;
};

/// Picture that was drawn before, and is still in its framebuffers.
struct KeptPicture {
  PictureKey key;
  std::optional<std::vector<Piece>> pieces;  ///< all of the scene; nullopt: nothing was drawn
  std::list<Framebuffer> framebuffers;
};

/// The last pictures of a few cameras that stand still: the next picture of such a camera needs to
/// be drawn only where something has moved. Each pixel is computed as in a whole picture.
class KeptPictures {
 public:
  /// Pictures with more pixels are not kept, as they need much memory.
  static constexpr int kMaxPixels = 640 * 480;

  static bool MayKeep(const CameraIntrinsics& intrinsics) {
    return intrinsics.width_px * intrinsics.height_px <= kMaxPixels;
  }
  /// Returns the picture with this key, or takes the one not used for the longest time for it,
  /// which then has no pieces. It stays valid until the next call.
  KeptPicture& Get(const PictureKey& key);

 private:
  static constexpr std::size_t kMostKept = 4;
  std::list<KeptPicture> pictures_;  // the last used in front
};

/// Shadows of pieces.
struct ShadowSweep {
  Vector3 to_lamp;
  double lowest = 0;  ///< of what is seen, along `to_lamp` [m]
  double margin = 0;  ///< around a piece, for soft edges [m]
};

/// Returns where a picture differs from a kept one: where each piece that moved was and is, and
/// where its shadow falls. The whole picture if that cannot be told.
/// @param sweep  nullptr: there are no shadows.
PixelRectangle ChangedRegion(const KeptPicture& kept, const std::vector<Piece>& now,
                             const ShadowSweep* sweep, MeshStore* meshes);

/// Returns a matrix to a clip space that has only this region, of a picture of this size.
Eigen::Matrix4f ClipOfRegion(const Eigen::Matrix4f& clip_from_world, const PixelRectangle& region,
                             const CameraIntrinsics& intrinsics);

/// Restricts drawing and clearing to a region, as long as it exists.
class ScissorScope {
 public:
  explicit ScissorScope(const PixelRectangle& region) {
    glEnable(GL_SCISSOR_TEST);
    // Row 0 of a framebuffer is the top of the picture.
    glScissor(region.left, region.top, region.width(), region.height());
  }
  ~ScissorScope() { glDisable(GL_SCISSOR_TEST); }
  ScissorScope(const ScissorScope&) = delete;
  ScissorScope& operator=(const ScissorScope&) = delete;
};

}  // namespace smile::camera::internal
