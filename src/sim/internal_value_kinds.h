#pragma once

#include <array>
#include <string>

#include "base/json.h"
#include "base/json_shape.h"
#include "sim/command_field.h"

namespace smile::sim {

/// What `arm` of a gripper may be, in the order of MoveGripper::Which.
inline constexpr std::array<const char*, 3> kArmNames{"left", "right", "both"};

/// What values of a kind may be.
const JsonShape& ShapeOf(ValueKind kind);

/// The same in words: `a number above 0, at most 1`.
std::string WordsOf(ValueKind kind);

/// @throws std::invalid_argument saying what was found and what was expected.
void CheckValue(const CommandField& field, const Json& value);

/// `"KEY" is FOUND, expected EXPECTED`.
[[noreturn]] void ThrowExpected(const std::string& key, const Json& found,
                                const std::string& expected);

}  // namespace smile::sim
