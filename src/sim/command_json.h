#pragma once

#include <cstdint>
#include <optional>

#include "base/json.h"
#include "sim/command.h"

namespace smile::sim {

/// No line of a script or log is longer, or has more keys: enough for the longest trajectory.
inline constexpr std::size_t kMaxLineBytes = std::size_t{32} << 20;
inline constexpr int kMaxLineKeys = 40'000;
/// Reads such a line.
/// @throws std::invalid_argument saying what is wrong with it.
Json ParseLineJson(std::string_view line);

/// The written form of a command, used alike by logs, scripts and the studio: one object whose `do`
/// names the kind. Lengths are in the scene's file unit, object angles in degrees, joints in
/// radians.
///
///     {"hand": "left", "do": "grasp", "object": "b3"}
///
/// @param meters_per_unit  of the scene.
Json ToJson(const Command& command, double meters_per_unit);

/// Reads the written form.
/// @throws std::invalid_argument saying what was found and what was expected; unknown keys are
/// errors.
Command ParseCommand(const Json& json, double meters_per_unit);

/// The tick of a line of a script or log; nullopt without one.
/// @throws std::invalid_argument if it is no whole number from 0.
std::optional<std::uint64_t> ParseTick(const Json& json);

/// The nearest command whose written form reads back to the same bits. The simulation applies
/// commands in this form, so that a log replays exactly.
Command OnFileGrid(Command command, double meters_per_unit);

}  // namespace smile::sim
