#pragma once

#include <vector>

#include "texts/user_message.h"

namespace smile::texts {

/// Returns a list such as `'b01', 'b02' and the robot`; an empty message for an empty list.
UserMessage AllOf(const std::vector<UserMessage>& names);
/// Returns the beginning of a longer list, such as `'b01', 'b02'`.
UserMessage EachOf(const std::vector<UserMessage>& names);

}  // namespace smile::texts
