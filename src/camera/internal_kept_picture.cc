#include "camera/internal_kept_picture.h"

#include <algorithm>
#include <cmath>

namespace smile::camera::internal {
namespace {

bool AreSame(const Piece& a, const Piece& b) {
  return a.instance == b.instance && a.casts_shadow == b.casts_shadow && a.unit_mesh == b.unit_mesh;
}

PixelRectangle Whole(const CameraIntrinsics& intrinsics) {
  return {0, 0, intrinsics.width_px, intrinsics.height_px};
}

/// Bounds of points in a picture.
class Bounds {
 public:
  Bounds(const CameraView& view, const ShadowSweep* sweep)
      : view_(view), X_CW_(view.X_WC.inverse()), sweep_(sweep) {}

  /// Adds what a piece covers, and its shadow.
  /// @returns false if that cannot be told.
  bool Add(const Piece& piece, const Eigen::AlignedBox3f& unit_box) {
    Eigen::AlignedBox3d box = unit_box.cast<double>();
    if (piece.unit_mesh.kind == mesh::UnitMesh::Kind::kSphere) {
      // Its number of facets depends on the picture.
      box = Eigen::AlignedBox3d(Vector3::Constant(-0.5), Vector3::Constant(0.5));
    }
    bool is_before = false, is_behind = false;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
      Vector3 p_WQ;
      for (int row = 0; row < 3; ++row) {
        const float* entries = piece.instance.rows[row];
        p_WQ[row] = entries[0] * p.x() + entries[1] * p.y() + entries[2] * p.z() + entries[3];
      }
      if (!p_WQ.allFinite()) return false;
      AddPoint(p_WQ, &is_before, &is_behind);
      if (sweep_ != nullptr && piece.casts_shadow) {
        const double fall = std::max(0.0, p_WQ.dot(sweep_->to_lamp) - sweep_->lowest);
        AddPoint(p_WQ - fall * sweep_->to_lamp, &is_before, &is_behind);
      }
    }
    // What is partly behind the camera may be anywhere in the picture.
    return !(is_before && is_behind);
  }

  PixelRectangle region() const {
    if (pixels_.isEmpty()) return {};
    // Rounding, and samples beside the middle of a pixel.
    constexpr int kMargin = 2;
    const auto limited = [](double value, int limit) {
      return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
    };
    const CameraIntrinsics& c = view_.intrinsics;
    return {limited(std::floor(pixels_.min().x()) - kMargin, c.width_px),
            limited(std::floor(pixels_.min().y()) - kMargin, c.height_px),
            limited(std::ceil(pixels_.max().x()) + kMargin, c.width_px),
            limited(std::ceil(pixels_.max().y()) + kMargin, c.height_px)};
  }

 private:
  /// Adds a point and what is within the margin around it.
  void AddPoint(const Vector3& p_WQ, bool* is_before, bool* is_behind) {
    const CameraIntrinsics& c = view_.intrinsics;
    const double margin = sweep_ != nullptr ? sweep_->margin : 0;
    for (int side = 0; side < (margin > 0 ? 8 : 1); ++side) {
      const Vector3 offset((side & 1) != 0 ? margin : -margin, (side & 2) != 0 ? margin : -margin,
                           (side & 4) != 0 ? margin : -margin);
      const Vector3 p_C = X_CW_ * Vector3(p_WQ + offset);
      const bool is_seen = p_C.z() >= c.near;
      *(is_seen ? is_before : is_behind) = true;
      if (!is_seen) continue;
      pixels_.extend(
          Eigen::Vector2d(c.cx + c.fx * p_C.x() / p_C.z(), c.cy + c.fy * p_C.y() / p_C.z()));
    }
  }

  const CameraView& view_;
  RigidTransform X_CW_;
  const ShadowSweep* sweep_;
  Eigen::AlignedBox2d pixels_;
};

}  // namespace

KeptPicture& KeptPictures::Get(const PictureKey& key) {
  auto found = std::ranges::find(pictures_, key, &KeptPicture::key);
  if (found == pictures_.end() && pictures_.size() < kMostKept) {
    pictures_.emplace_front();
    found = pictures_.begin();
  } else if (found == pictures_.end()) {
    found = std::prev(pictures_.end());
  }
  if (found->key != key || found->framebuffers.empty()) {
    found->pieces.reset();
    if (found->key.layouts != key.layouts || found->framebuffers.empty()) {
      found->key = {};
      found->framebuffers.clear();
      for (const FramebufferLayout& layout : key.layouts) found->framebuffers.emplace_back(layout);
    }
    found->key = key;
  }
  pictures_.splice(pictures_.begin(), pictures_, found);
  return pictures_.front();
}

PixelRectangle ChangedRegion(const KeptPicture& kept, const std::vector<Piece>& now,
                             const ShadowSweep* sweep, MeshStore* meshes) {
  const CameraView& view = kept.key.view;
  if (!kept.pieces || kept.pieces->size() != now.size()) return Whole(view.intrinsics);
  const std::vector<Piece>& before = *kept.pieces;
  const Eigen::Matrix4f clip_from_world = ClipFromWorld(view);
  Bounds bounds(view, sweep);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (AreSame(before[i], now[i])) continue;
    for (const Piece* piece : {&before[i], &now[i]}) {
      const Eigen::AlignedBox3f& box = meshes->BoxOf(piece->unit_mesh);
      // Without shadows, what lies beside the picture changes nothing in it.
      if (sweep == nullptr && !MayShow(box, piece->instance, clip_from_world)) continue;
      if (!bounds.Add(*piece, box)) return Whole(view.intrinsics);
    }
  }
  return bounds.region();
}

Eigen::Matrix4f ClipOfRegion(const Eigen::Matrix4f& clip_from_world, const PixelRectangle& region,
                             const CameraIntrinsics& intrinsics) {
  Eigen::Matrix4f clip = clip_from_world;
  const auto crop = [&clip](int axis, int begin, int end, int size) {
    const double low = 2.0 * begin / size - 1, high = 2.0 * end / size - 1;
    const auto scale = static_cast<float>(2 / (high - low));
    const auto shift = static_cast<float>(-(high + low) / (high - low));
    clip.row(axis) = (scale * clip.row(axis) + shift * clip.row(3)).eval();
  };
  crop(0, region.left, region.right, intrinsics.width_px);
  crop(1, region.top, region.bottom, intrinsics.height_px);
  return clip;
}

}  // namespace smile::camera::internal
