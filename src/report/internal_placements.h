#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "report/markup.h"
#include "scene/scene_spec.h"

namespace smile::report {

/// Where an object of the goal was wanted, and where it is.
struct Placement {
  std::string object;  ///< its id in the robot's scene
  RigidTransform X_WWanted;
  std::optional<RigidTransform> X_WReached;  ///< nullopt of what is not there any more
  std::optional<double> error_mm;
  std::optional<double> error_degrees;  ///< nullopt where the result does not tell

  bool IsWithin(double tolerance_mm) const { return error_mm && *error_mm <= tolerance_mm; }
};

/// As `result.json` has them, in the order of the goal.
std::vector<Placement> PlacementsOf(const Json& result, double meters_per_unit);

/// How far off each one is, with the line up to which it counts as rebuilt.
Markup ErrorBars(const std::vector<Placement>& placements, double tolerance_mm);

enum class Side { kTop, kFront };
/// Everything on the table as it lies in the end, filled; dashed, where the goal would have it.
/// From the top, or as somebody sees it who stands where y begins.
Markup DrawPlacements(const scene::SceneSpec& scene, const Json& result,
                      const std::vector<Placement>& placements, Side side);

}  // namespace smile::report
