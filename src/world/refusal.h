#pragma once

#include <string>
#include <string_view>

namespace smile::world {

/// Why something was not done; an ordinary answer, in words for people.
using Refusal = std::string;

/// An id as refusals write it: 'b03'.
inline std::string Named(std::string_view id) { return "'" + std::string(id) + "'"; }

}  // namespace smile::world
