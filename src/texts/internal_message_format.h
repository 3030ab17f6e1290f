#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "texts/user_message.h"

namespace smile::texts {

/// Renders a message in English: the part of ICU's syntax that docs/translating.md lists.
/// @throws std::logic_error if an argument is missing or the syntax is wrong.
std::string Render(std::string_view format, const std::vector<MessageArgument>& arguments);

}  // namespace smile::texts
