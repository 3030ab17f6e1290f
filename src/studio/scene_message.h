#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "scene/scene_spec.h"
#include "scene/visual_model.h"
#include "sim/simulation.h"
#include "studio/page_meshes.h"

namespace smile::studio {

/// What is on stage: a simulation's scene, or that of a recording.
struct StageDescription {
  std::uint32_t number = 0;  ///< View::scene
  const scene::SceneSpec* scene = nullptr;
  const scene::VisualModel* model = nullptr;
  const robot::RobotModel* robot = nullptr;  ///< nullptr without one
  std::vector<std::string> cameras;
};

/// Everything about a scene that does not change while it is there, in its units; see
/// docs/studio-protocol.md.
Json SceneMessage(const StageDescription& stage, const PageMeshes& meshes,
                  const std::vector<int>& looks);

/// `[x, y, z, qx, qy, qz, qw]`, in units.
Json PoseInUnits(const RigidTransform& X_AB, double meters_per_unit);
/// `[x, y, z]`, in units.
Json PointInUnits(const Vector3& p, double meters_per_unit);

}  // namespace smile::studio
