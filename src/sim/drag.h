#pragma once

#include <optional>

#include "base/json.h"
#include "demonstrator/hand.h"
#include "sim/command.h"
#include "sim/simulation.h"

namespace smile::sim {

/// A mouse that drags: the held object goes to where its ray meets the hand's motion plane, or a
/// level one. No command but a question, which the studio and scripts ask: the answer is a MoveTo.
struct Drag {
  static constexpr CommandName kName{
      "drag",
      "carries the held object to where a ray meets the hand's plane; for scripts and pages only, "
      "it becomes a move_to"};
  HandName hand = HandName::kAny;
  Vector3 p_WOrigin = Vector3::Zero();           ///< of the ray [m]
  Vector3 direction_in_world = Vector3::Zero();  ///< of any length but 0
  bool is_level = false;        ///< in the level plane through where the hand wants to be
  std::optional<double> speed;  ///< at most this fast [m/s]

  static void VisitFields(auto& drag, auto&& visit) {
    visit(drag.hand, kHandField);
    visit(drag.p_WOrigin,
          CommandField{"origin", ValueKind::kPoint, "where the ray begins", ValueUnit::kUnits});
    visit(drag.direction_in_world,
          CommandField{"direction", ValueKind::kDirection, "of the ray, of any length but 0"});
    visit(drag.is_level,
          CommandField{"level", ValueKind::kFlag, "in a level plane instead; false if not given",
                       ValueUnit::kNone, Presence::kOptional});
    visit(drag.speed, CommandField{"speed", ValueKind::kSpeed, kSpeedMeaning,
                                   ValueUnit::kUnitsPerSecond, Presence::kOptional});
  }
  bool operator==(const Drag&) const = default;
};

/// Whether something written says `drag`.
bool IsDrag(const Json& json);
/// Reads the written form, which is that of a command.
/// @throws std::invalid_argument saying what was found and what was expected.
Drag ParseDrag(const Json& json, double meters_per_unit);

/// What a drag means now.
/// @returns nullopt where it leads nowhere; `refusal` then says why.
std::optional<MoveTo> MoveOf(const Drag& drag, const Simulation& simulation, Refusal* refusal);

}  // namespace smile::sim
