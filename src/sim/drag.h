#pragma once

#include <optional>

#include "base/json.h"
#include "demonstrator/hand.h"
#include "sim/command.h"
#include "sim/simulation.h"

namespace smile::sim {

/// A drag with the mouse: the held object goes to the point where the mouse ray meets the hand's
/// motion plane, or a level one. Not a command but a query of the studio and of scripts, which is
/// turned into a MoveTo.
struct Drag {
  static constexpr CommandName kName{
      "drag",
      "moves the held object to the intersection of a ray and the hand's plane; for scripts and "
      "pages only; is logged as `move_to`"};
  HandName hand = HandName::kAny;
  Vector3 p_WOrigin = Vector3::Zero();           ///< origin of the ray [m]
  Vector3 direction_in_world = Vector3::Zero();  ///< of any length except 0
  bool is_level = false;        ///< true for the level plane through the hand's goal
  std::optional<double> speed;  ///< greatest speed [m/s]

  static void VisitFields(auto& drag, auto&& visit) {
    visit(drag.hand, kHandField);
    visit(drag.p_WOrigin,
          CommandField{"origin", ValueKind::kPoint, "origin of the ray", ValueUnit::kUnits});
    visit(drag.direction_in_world, CommandField{"direction", ValueKind::kDirection,
                                                "direction of the ray, of any length but 0"});
    visit(drag.is_level,
          CommandField{"level", ValueKind::kFlag, "use a horizontal plane instead (default: false)",
                       ValueUnit::kNone, Presence::kOptional});
    visit(drag.speed, CommandField{"speed", ValueKind::kSpeed, kSpeedMeaning,
                                   ValueUnit::kUnitsPerSecond, Presence::kOptional});
  }
  bool operator==(const Drag&) const = default;
};

/// Returns true for the written form of a Drag.
bool IsDrag(const Json& json);
/// Reads the written form, which is like that of a command.
/// @throws std::invalid_argument with what was found and expected.
Drag ParseDrag(const Json& json, double meters_per_unit);

/// Returns the present meaning of a drag.
/// @returns nullopt if it leads nowhere, with the reason in `refusal`.
std::optional<MoveTo> MoveOf(const Drag& drag, const Simulation& simulation, Refusal* refusal);

}  // namespace smile::sim
