#include "sim/drag.h"

#include "scene/units.h"
#include "sim/internal_command_fields.h"

// A drag is a question, too: where would this ray move the hand? The answer depends on the plane in
// which the hand moves and becomes a plain `move_to`, so a replay needs neither mouse nor camera.

namespace smile::sim {

bool IsDrag(const Json& json) {
  return json.is_object() && json.contains("do") && json.at("do") == Drag::kName.name;
}

Drag ParseDrag(const Json& json, double meters_per_unit) {
  return ReadFields<Drag>(json, meters_per_unit);
}

std::optional<MoveTo> MoveOf(const Drag& drag, const Simulation& simulation, Refusal* refusal) {
  const auto p_WH = simulation.demonstrator().PointOnPlane(
      drag.hand, {.p_WOrigin = drag.p_WOrigin, .direction_in_world = drag.direction_in_world},
      drag.is_level, refusal);
  if (!p_WH) return std::nullopt;
  // In scenes with tiny units, a log could not express a larger number.
  const double limit = scene::FromFileUnits(kMaxNumber, simulation.scene().meters_per_unit);
  // Written so that NaN is refused.
  if (!(p_WH->cwiseAbs().maxCoeff() <= limit)) {
    *refusal = texts::Say("hands.rayMeetsBeyond");
    return std::nullopt;
  }
  return MoveTo{.hand = drag.hand, .p_WH = *p_WH, .speed = drag.speed};
}

}  // namespace smile::sim
