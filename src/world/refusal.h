#pragma once

#include <string>
#include <string_view>

namespace smile::world {

/// Reason why a command was not carried out; an ordinary result, in words for people.
using Refusal = std::string;

/// Returns an id as refusals write it: 'b03'.
inline std::string Named(std::string_view id) { return "'" + std::string(id) + "'"; }

}  // namespace smile::world
