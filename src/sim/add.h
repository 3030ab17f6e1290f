#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/json.h"
#include "sim/command.h"
#include "sim/command_field.h"
#include "sim/simulation.h"

namespace smile::sim {

/// Some of the objects that are offered ready-made, at a free place that the seed chooses; see
/// layout/presets.h. Written like a command, but no command: which objects go where depends on what
/// is there, so the answer is a Spawn, as that of a Drag is a MoveTo.
struct Add {
  static constexpr CommandName kName{"add",
                                     "adds ready-made objects at a free place; becomes a spawn"};
  std::string preset;
  std::uint64_t seed = 0;

  static void VisitFields(auto& add, auto&& visit) {
    visit(add.preset, CommandField{"preset", ValueKind::kText,
                                   "big_block, stack_3, stack_5, stack_8, box, ball, prism, ring "
                                   "or dominoes"});
    visit(add.seed, CommandField{"seed", ValueKind::kSeed,
                                 "same objects there and same seed: same place and colors",
                                 ValueUnit::kNone, Presence::kDefaulted});
  }
  bool operator==(const Add&) const = default;
};

bool IsAdd(const Json& json);
/// @throws std::invalid_argument saying what was found and what was expected.
Add ParseAdd(const Json& json);

/// What to command so that the objects are there.
/// @returns nullopt where that cannot be; `refusal` then says why.
std::optional<Spawn> SpawnOf(const Add& add, const Simulation& simulation, Refusal* refusal);

}  // namespace smile::sim
