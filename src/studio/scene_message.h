#pragma once

#include <cstdint>
#include <vector>

#include "base/json.h"
#include "model/model.h"
#include "studio/page_meshes.h"

namespace smile::studio {

/// Everything about a scene and its robot that does not change while they are there, in the scene's
/// units; see docs/studio-protocol.md.
/// @param number  see View::scene.
Json SceneMessage(std::uint32_t number, const model::Model& model, const PageMeshes& meshes,
                  const std::vector<int>& looks);

/// `[x, y, z, qx, qy, qz, qw]`, in units.
Json PoseInUnits(const RigidTransform& X_AB, double meters_per_unit);
/// `[x, y, z]`, in units.
Json PointInUnits(const Vector3& p, double meters_per_unit);

}  // namespace smile::studio
