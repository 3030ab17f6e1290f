#pragma once

#include <string>

namespace smile::world {

/// Why something was not done; an ordinary answer, in words for people.
using Refusal = std::string;

}  // namespace smile::world
