#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "math/camera_projection.h"
#include "mesh/primitives.h"
#include "scene/visual_model.h"

namespace smile::camera::internal {

/// Data of one visual on the graphics card, in the layout of the shaders.
struct Instance {
  float rows[3][4] = {};  ///< world from unit mesh: the upper three rows
  float color[3] = {};    ///< red, green, blue as shown on a screen
  std::uint32_t object_id = 0;
  std::uint32_t glows = 0;  ///< 1: shows its color whatever light there is

  bool operator==(const Instance&) const = default;
};
static_assert(sizeof(Instance) == 68);

/// Visual with its pose.
struct Piece {
  mesh::UnitMesh unit_mesh;
  Instance instance;
  Vector3 p_WV = Vector3::Zero();
  double bounding_radius = 0;  ///< about p_WV [m]
  bool casts_shadow = true;
};

/// Returns all visuals of the model that are present in this state, with their poses, apart from
/// those of excluded frames.
/// @throws std::invalid_argument unless there is one pose for each frame, one variant for each
/// choice,
///         and every frame and choice that a visual or the exclusion names exists.
std::vector<Piece> PlacePieces(const scene::VisualModel& model, const scene::VisualState& state,
                               const std::vector<int>& excluded_frames);

/// Returns the pieces that the camera may see. Spheres get as many facets as the picture needs.
std::vector<Piece> VisiblePieces(const std::vector<Piece>& pieces, const CameraView& view);

/// Returns the matrix from world to OpenGL's clip space, such that row 0 of the picture is the
/// first row in memory: +y in clip space is down in the picture.
Eigen::Matrix4f ClipFromWorld(const CameraView& view);

/// Returns false if an instance of a unit mesh lies beside the picture as a whole. Closer than the
/// bounding spheres of VisiblePieces(), which are about the origin of a link and include what is
/// far from its mesh.
/// @param box  around the unit mesh.
bool MayShow(const Eigen::AlignedBox3f& box, const Instance& instance,
             const Eigen::Matrix4f& clip_from_world);

/// Checks the parameters of a camera.
/// @throws std::invalid_argument unless sizes are 1 to 8192, focal lengths are above 0, all numbers
///         are finite and 0 < near < far.
void CheckIntrinsics(const CameraIntrinsics& intrinsics);

}  // namespace smile::camera::internal
