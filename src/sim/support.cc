#include "sim/support.h"

#include <algorithm>

#include "scene/bounds.h"

namespace smile::sim {
namespace {

/// So deep may one be in the other and still lie on it [m].
constexpr double kDepth = 0.005;

bool IsBeneath(const scene::Bounds& piece, const scene::Bounds& object) {
  const bool is_over_it = piece.low.x() < object.high.x() && object.low.x() < piece.high.x() &&
                          piece.low.y() < object.high.y() && object.low.y() < piece.high.y();
  return is_over_it && piece.high.z() <= object.low.z() + kDepth;
}

bool IsBeneath(const scene::TableSpec& table, const scene::Bounds& object) {
  const Vector3 half(table.x_span / 2, table.y_span / 2, 0);
  return IsBeneath(scene::Bounds{.low = -half, .high = half}, object);
}

}  // namespace

std::optional<Support> SupportOf(const scene::SceneSpec& scene,
                                 const std::vector<std::optional<RigidTransform>>& X_WBs,
                                 std::size_t object) {
  if (object >= X_WBs.size() || !X_WBs[object]) return std::nullopt;
  const scene::Bounds whole =
      scene::BoundsOf(scene::SolidsOf(scene.objects[object].whole), *X_WBs[object]);
  std::optional<Support> best;
  const auto consider = [&](const scene::Bounds& piece, Support support) {
    support.height = std::max(0.0, whole.low.z() - piece.high.z());
    if (!best || support.height < best->height) best = std::move(support);
  };
  if (IsBeneath(scene.table, whole)) {
    consider({.low = Vector3::Zero(), .high = Vector3::Zero()}, Support());
  }
  for (std::size_t i = 0; i < X_WBs.size(); ++i) {
    if (i == object || !X_WBs[i]) continue;
    const scene::Part& other = scene.objects[i].whole;
    for (const scene::Solid& solid : scene::SolidsOf(other)) {
      const scene::Bounds piece = scene::BoundsOf(solid.shape, *X_WBs[i] * solid.X_BS);
      if (!IsBeneath(piece, whole)) continue;
      consider(piece, {.object = other.id, .is_container = solid.part_id.ends_with("(floor)")});
    }
  }
  return best;
}

}  // namespace smile::sim
