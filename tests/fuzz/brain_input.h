#pragma once

#include <string>
#include <string_view>

namespace smile::fuzz {

/// What is wrong with how we take these bytes as a message from a brain, in words; empty
/// when all is well.
///
/// Invalid bytes are refused with a reason. A message comes back from its own bytes the same, and
/// every number that is taken from it for the robot is finite.
std::string FaultWithBrainMessage(std::string_view bytes);

/// Why these bytes are no message; empty when they are one.
std::string ReasonAgainstBrainMessage(std::string_view bytes);

}  // namespace smile::fuzz
