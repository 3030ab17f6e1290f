#pragma once

#include <array>
#include <string>

#include "base/json.h"
#include "base/json_shape.h"
#include "sim/command_field.h"

namespace smile::sim {

/// Values of a gripper's `arm`, in the order of MoveGripper::Which.
inline constexpr std::array<const char*, 3> kArmNames{"left", "right", "both"};

/// Returns the allowed values of a kind.
const JsonShape& ShapeOf(ValueKind kind);

/// The same in words: `a number above 0, at most 1`.
std::string WordsOf(ValueKind kind);

/// Checks a value.
/// @throws std::invalid_argument with what was found and expected.
void CheckValue(const CommandField& field, const Json& value);

/// Throws std::invalid_argument: `"KEY" is FOUND, expected EXPECTED`.
[[noreturn]] void ThrowExpected(const std::string& key, const Json& found,
                                const std::string& expected);

}  // namespace smile::sim
