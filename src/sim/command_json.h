#pragma once

#include <cstdint>
#include <optional>

#include "base/json.h"
#include "sim/command.h"

namespace smile::sim {

/// Upper bounds of a line of a script or log: enough for the longest trajectory.
inline constexpr std::size_t kMaxLineBytes = std::size_t{32} << 20;
inline constexpr int kMaxLineKeys = 40'000;
/// Parses a line.
/// @throws std::invalid_argument with the fault.
Json ParseLineJson(std::string_view line);

/// Returns the written form of a command, used by logs, scripts and the studio: one object whose
/// `do` names the kind. Lengths are in the scene's file unit, object angles in degrees, joints in
/// radians.
///
///     {"hand": "left", "do": "grasp", "object": "b3"}
///
/// @param meters_per_unit  of the scene.
Json ToJson(const Command& command, double meters_per_unit);

/// Reads the written form.
/// @throws std::invalid_argument with what was found and expected; unknown keys are errors.
Command ParseCommand(const Json& json, double meters_per_unit);

/// Returns the tick of a line of a script or log; nullopt without one.
/// @throws std::invalid_argument unless it is an integer from 0.
std::optional<std::uint64_t> ParseTick(const Json& json);

/// Returns the nearest command whose written form reads back to the same bits. The simulation
/// applies commands in this form, so that a log replays exactly.
Command OnFileGrid(Command command, double meters_per_unit);

}  // namespace smile::sim
