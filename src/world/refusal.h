#pragma once

#include <string>
#include <string_view>

#include "texts/user_message.h"

namespace smile::world {

/// Reason why a command was not carried out; an ordinary result.
using Refusal = texts::UserMessage;

/// Returns an id as refusals write it: 'b03'.
inline std::string Named(std::string_view id) { return "'" + std::string(id) + "'"; }

}  // namespace smile::world
