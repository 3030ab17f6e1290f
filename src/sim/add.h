#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/json.h"
#include "sim/command.h"
#include "sim/command_field.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Ready-made objects, at a free place that the seed chooses or at a given one; see
/// layout/presets.h. Written like a command, but not one: the result depends on the present
/// objects, so it is turned into a Spawn, as a Drag into a MoveTo.
struct Add {
  static constexpr CommandName kName{"add", "adds ready-made objects; is logged as `spawn`"};
  std::string preset;
  std::uint64_t seed = 0;
  std::optional<Vector3> p_WQ;  ///< under their middle [m]; unset: at a free place

  static void VisitFields(auto& add, auto&& visit) {
    visit(add.preset, CommandField{"preset", ValueKind::kText,
                                   "big_block, stack_3, stack_5, stack_8, box, ball, prism, ring "
                                   "or dominoes"});
    visit(
        add.seed,
        CommandField{"seed", ValueKind::kSeed,
                     "seed of the place and colors; the same seed and objects give the same result",
                     ValueUnit::kNone, Presence::kDefaulted});
    visit(add.p_WQ, CommandField{"place", ValueKind::kPoint,
                                 "point under the middle of the objects (default: a free place)",
                                 ValueUnit::kUnits, Presence::kOptional});
  }
  bool operator==(const Add&) const = default;
};

/// Returns true for the written form of an Add.
bool IsAdd(const Json& json);
/// Reads the written form.
/// @throws std::invalid_argument with what was found and expected.
Add ParseAdd(const Json& json, double meters_per_unit);

/// Returns the command that adds the objects.
/// @returns nullopt if that is not possible, with the reason in `refusal`.
std::optional<Spawn> SpawnOf(const Add& add, const Simulation& simulation, Refusal* refusal);

}  // namespace smile::sim
