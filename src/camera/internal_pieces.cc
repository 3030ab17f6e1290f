// From a model and its state to what the graphics card draws: poses in single precision, culling by
// bounding spheres, and the projection. Everything that depends on doubles happens here, before the
// rounding.

#include "camera/internal_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace smile::camera::internal {
namespace {

void CheckFrame(int frame, const scene::VisualModel& model, const char* whose) {
  if (frame >= 0 && frame < model.num_frames) return;
  throw std::invalid_argument(std::string(whose) + " frame is " + std::to_string(frame) +
                              ", expected 0 to " + std::to_string(model.num_frames - 1));
}

/// Returns a visual with its transform: rotation times scale of the unit mesh, in single precision.
Piece Place(const scene::Visual& visual, const RigidTransform& X_WF) {
  const RigidTransform X_WV = X_WF * visual.X_FV;
  const Vector3 scale = mesh::ScaleOf(visual.shape);
  const Vector3 color(visual.color.red, visual.color.green, visual.color.blue);
  Piece piece{.unit_mesh = mesh::UnitMeshOf(visual.shape),
              .instance = {.object_id = visual.object_id, .glows = visual.glows ? 1u : 0u},
              .p_WV = X_WV.translation(),
              .bounding_radius = mesh::BoundingRadiusOf(visual.shape),
              .casts_shadow = visual.casts_shadow};
  // Rows of a 3x4 matrix: the fourth row of a homogeneous matrix is constant and not sent.
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      piece.instance.rows[row][column] =
          static_cast<float>(X_WV.rotation()(row, column) * scale[column]);
    }
    piece.instance.color[row] = static_cast<float>(color[row]);
    piece.instance.rows[row][3] = static_cast<float>(X_WV.translation()[row]);
  }
  return piece;
}

/// View frustum of a camera, bounded by six planes.
class Frustum {
 public:
  explicit Frustum(const CameraView& view)
      : intrinsics_(view.intrinsics), X_CW_(view.X_WC.inverse()) {
    const CameraIntrinsics& c = intrinsics_;
    const double left = -c.cx / c.fx, right = (c.width_px - c.cx) / c.fx;
    const double top = -c.cy / c.fy, bottom = (c.height_px - c.cy) / c.fy;
    // A point at (x, y, z) is inside a side plane if x / z is beyond that edge of the image plane;
    // its normal follows.
    side_normals_C_ = {Vector3(1, 0, -left).normalized(), Vector3(-1, 0, right).normalized(),
                       Vector3(0, 1, -top).normalized(), Vector3(0, -1, bottom).normalized()};
  }

  /// True unless the bounding sphere lies completely outside one plane (conservative near the
  /// corners).
  bool MayShow(const Piece& piece) const {
    const Vector3 p_CV = X_CW_ * piece.p_WV;
    const double radius = piece.bounding_radius;
    if (p_CV.z() + radius < intrinsics_.near || p_CV.z() - radius > intrinsics_.far) return false;
    return std::ranges::none_of(
        side_normals_C_, [&](const Vector3& normal_C) { return normal_C.dot(p_CV) < -radius; });
  }

  /// Returns the approximate radius of the bounding sphere in the picture [px].
  double RadiusInPixels(const Piece& piece) const {
    // A sphere around the camera would have a negative distance; the nearest one gives the most
    // facets.
    const double distance = std::max((X_CW_ * piece.p_WV).z(), intrinsics_.near);
    return std::max(intrinsics_.fx, intrinsics_.fy) * piece.bounding_radius / distance;
  }

 private:
  CameraIntrinsics intrinsics_;
  RigidTransform X_CW_;
  std::array<Vector3, 4> side_normals_C_;  // inwards; the four planes meet in the camera
};

/// Returns the number of facets for which the outline is exact within a quarter of a pixel: the
/// middle of a facet lies radius * (1 - cos(pi / facets)) within the sphere. A few levels only, so
/// that meshes are shared.
int SphereFacetsFor(double radius_px) {
  // radius (1 - cos x) is about radius x^2 / 2, with x = pi / facets; a quarter of a pixel gives
  // this.
  const double facets = std::numbers::pi * std::sqrt(2 * radius_px);
  for (const int level : {16, 32, 64}) {
    if (facets <= level) return level;
  }
  return 128;
}

}  // namespace

std::vector<Piece> PlacePieces(const scene::VisualModel& model, const scene::VisualState& state,
                               const std::vector<int>& excluded_frames) {
  const scene::FramePoses& poses = state.poses;
  if (poses.size() != static_cast<std::size_t>(model.num_frames)) {
    throw std::invalid_argument("a model of " + std::to_string(model.num_frames) +
                                " frames is drawn with " + std::to_string(poses.size()) +
                                " poses, expected one for each");
  }
  if (state.variants.size() != static_cast<std::size_t>(model.num_choices)) {
    throw std::invalid_argument("a model of " + std::to_string(model.num_choices) +
                                " choices is drawn with " + std::to_string(state.variants.size()) +
                                " variants, expected one for each");
  }
  std::vector<bool> is_excluded(poses.size());
  for (const int frame : excluded_frames) {
    CheckFrame(frame, model, "an excluded");
    is_excluded[frame] = true;
  }
  std::vector<Piece> pieces;
  pieces.reserve(model.visuals.size());
  for (const scene::Visual& visual : model.visuals) {
    CheckFrame(visual.frame, model, "a visual's");
    if (visual.choice >= model.num_choices) {
      throw std::invalid_argument("a visual's choice is " + std::to_string(visual.choice) +
                                  ", expected less than " + std::to_string(model.num_choices));
    }
    // A visual with a choice is drawn only in its variant: the states of a control, the face,
    // presence.
    if (visual.choice >= 0 && state.variants[visual.choice] != visual.variant) continue;
    if (!is_excluded[visual.frame]) pieces.push_back(Place(visual, poses[visual.frame]));
  }
  return pieces;
}

std::vector<Piece> VisiblePieces(const std::vector<Piece>& pieces, const CameraView& view) {
  const Frustum frustum(view);
  std::vector<Piece> visible;
  visible.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    if (!frustum.MayShow(piece)) continue;
    visible.push_back(piece);
    mesh::UnitMesh& unit_mesh = visible.back().unit_mesh;
    if (unit_mesh.kind == mesh::UnitMesh::Kind::kSphere) {
      unit_mesh.facets = SphereFacetsFor(frustum.RadiusInPixels(piece));
    }
  }
  return visible;
}

Eigen::Matrix4f ClipFromWorld(const CameraView& view) {
  const CameraIntrinsics& c = view.intrinsics;
  // Pinhole projection in homogeneous coordinates: u = cx + fx x / z in [0, width] maps to OpenGL's
  // x / w in [-1, 1]; v likewise.
  Eigen::Matrix4d clip_from_camera;
  clip_from_camera << 2 * c.fx / c.width_px, 0, 2 * c.cx / c.width_px - 1, 0,             //
      0, 2 * c.fy / c.height_px, 2 * c.cy / c.height_px - 1, 0,                           //
      0, 0, (c.far + c.near) / (c.far - c.near), -2 * c.far * c.near / (c.far - c.near),  //
      0, 0, 1, 0;
  const RigidTransform X_CW = view.X_WC.inverse();
  Eigen::Matrix4d camera_from_world = Eigen::Matrix4d::Identity();
  camera_from_world.topLeftCorner<3, 3>() = X_CW.rotation();
  camera_from_world.topRightCorner<3, 1>() = X_CW.translation();
  return (clip_from_camera * camera_from_world).cast<float>();
}

bool MayShow(const Eigen::AlignedBox3f& box, const Instance& instance,
             const Eigen::Matrix4f& clip_from_world) {
  // Of the sums below, a multiple of what rounding may change.
  constexpr float kRounding = 1e-5f;
  Eigen::Matrix4f world_from_mesh = Eigen::Matrix4f::Identity();
  for (int row = 0; row < 3; ++row) {
    world_from_mesh.row(row) = Eigen::Map<const Eigen::RowVector4f>(instance.rows[row]);
  }
  const Eigen::Matrix4f clip_from_mesh = clip_from_world * world_from_mesh;
  const Eigen::Vector4f center = box.center().homogeneous();
  const Eigen::Vector3f half_span = box.sizes() / 2;
  // A point is in the picture if -w <= x <= w and -w <= y <= w. Of each of these four sums, the
  // largest in the box is that in the center and what half of each edge adds.
  for (const int axis : {0, 1}) {
    for (const float sign : {-1.0f, 1.0f}) {
      const Eigen::Vector4f plane =
          (clip_from_mesh.row(3) + sign * clip_from_mesh.row(axis)).transpose();
      const float reach = plane.head<3>().cwiseAbs().dot(half_span);
      const float magnitude = plane.cwiseAbs().dot(center.cwiseAbs()) + reach;
      if (plane.dot(center) + reach < -kRounding * magnitude) return false;
    }
  }
  return true;
}

void CheckIntrinsics(const CameraIntrinsics& c) {
  constexpr int kMaxSize = 8192;
  if (c.width_px < 1 || c.width_px > kMaxSize || c.height_px < 1 || c.height_px > kMaxSize) {
    throw std::invalid_argument("image size is " + std::to_string(c.width_px) + "x" +
                                std::to_string(c.height_px) + ", expected 1 to " +
                                std::to_string(kMaxSize) + " pixels each");
  }
  if (!(c.fx > 0 && c.fy > 0 && std::isfinite(c.fx) && std::isfinite(c.fy) && std::isfinite(c.cx) &&
        std::isfinite(c.cy))) {
    throw std::invalid_argument("focal lengths are " + std::to_string(c.fx) + " and " +
                                std::to_string(c.fy) + " px, principal point (" +
                                std::to_string(c.cx) + ", " + std::to_string(c.cy) +
                                "), expected finite numbers, lengths above 0");
  }
  if (!(c.near > 0 && c.near < c.far && std::isfinite(c.far))) {
    throw std::invalid_argument("near and far are " + std::to_string(c.near) + " and " +
                                std::to_string(c.far) + " m, expected 0 < near < far");
  }
}

}  // namespace smile::camera::internal
