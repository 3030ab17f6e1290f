#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "sim/command.h"
#include "sim/command_field.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Copies of present objects, as they stand to each other. Written like a command, but not one: the
/// result depends on the present poses, so it is turned into a Spawn, as an Add.
struct Duplicate {
  static constexpr CommandName kName{"duplicate",
                                     "adds copies of objects beside them; is logged as `spawn`"};
  std::vector<std::string> objects;
  std::optional<Vector3> by;  ///< from the objects to their copies [m]; unset: to a free place

  static void VisitFields(auto& duplicate, auto&& visit) {
    visit(duplicate.objects, kObjectsField);
    visit(duplicate.by, CommandField{"by", ValueKind::kPoint,
                                     "way from the objects to their copies (default: to a free "
                                     "place beside them)",
                                     ValueUnit::kUnits, Presence::kOptional});
  }
  bool operator==(const Duplicate&) const = default;
};

/// Returns true for the written form of a Duplicate.
bool IsDuplicate(const Json& json);
/// Reads the written form.
/// @throws std::invalid_argument with what was found and expected.
Duplicate ParseDuplicate(const Json& json, double meters_per_unit);

/// Returns the command that adds the copies.
/// @returns nullopt if that is not possible, with the reason in `refusal`.
std::optional<Spawn> SpawnOf(const Duplicate& duplicate, const Simulation& simulation,
                             Refusal* refusal);

}  // namespace smile::sim
