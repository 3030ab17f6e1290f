#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "report/markup.h"
#include "scene/scene_spec.h"

namespace smile::report {

/// Desired and reached pose of an object of the goal.
struct Placement {
  std::string object;  ///< id in the robot's scene
  RigidTransform X_WWanted;
  std::optional<RigidTransform> X_WReached;  ///< nullopt if the object is gone
  std::optional<double> error_mm;
  std::optional<double> error_degrees;  ///< nullopt if the result lacks it

  bool IsWithin(double tolerance_mm) const { return error_mm && *error_mm <= tolerance_mm; }
};

/// Returns the placements of a `result.json`, in the order of the goal.
std::vector<Placement> PlacementsOf(const Json& result, double meters_per_unit);

/// Returns bars of the position errors, with a line at the tolerance.
Markup ErrorBars(const std::vector<Placement>& placements, double tolerance_mm);

enum class ViewDirection { kTop, kFront };
/// Returns a drawing of all final poses, filled, and of the goal poses, dashed. From above, or from
/// the front (seen along +y).
Markup DrawPlacements(const scene::SceneSpec& scene, const Json& result,
                      const std::vector<Placement>& placements, ViewDirection direction);

}  // namespace smile::report
