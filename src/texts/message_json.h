#pragma once

#include <string>

#include "base/json.h"
#include "texts/user_message.h"

namespace smile::texts {

/// Returns `{"say":"hands.empty","with":{"hand":"left"}}`, with the arguments if there are any; a
/// string for text as it is.
Json ToJson(const UserMessage& message);

/// Returns the message of such a value.
/// @throws std::invalid_argument if it has another form or an argument is missing.
UserMessage MessageOf(const Json& json);

}  // namespace smile::texts
