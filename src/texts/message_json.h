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

/// Returns the English text.
Json EnglishOf(const UserMessage& message);

// Files contain messages in English, for people and other programs, and beside them, as `message`,
// what the page renders in its own language.

/// Adds the message to the object of a file that contains its English text; nothing for text as it
/// is.
void AddMessage(const UserMessage& message, Json* object);
/// Returns the message of such an object; its English text as it is if this program does not know
/// the message.
UserMessage MessageBeside(std::string english, const Json& object);

}  // namespace smile::texts
