#pragma once

#include <cstdint>
#include <vector>

#include "base/json.h"
#include "model/model.h"
#include "page/page_meshes.h"

namespace smile::page {

/// Returns the constant facts about a scene and its robot, in the scene's units; see
/// docs/studio-protocol.md.
/// @param number  see DisplayedState::scene.
Json SceneMessage(std::uint32_t number, const model::Model& model, const PageMeshes& meshes,
                  const std::vector<int>& variants);

/// Returns `[x, y, z, qx, qy, qz, qw]`, in units.
Json PoseInUnits(const RigidTransform& X_AB, double meters_per_unit);
/// Returns `[x, y, z]`, in units.
Json PointInUnits(const Vector3& p, double meters_per_unit);

}  // namespace smile::page
