#pragma once

#include <string>

#include "base/json.h"
#include "base/json_shape.h"
#include "sim/command_field.h"

namespace smile::sim {

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
