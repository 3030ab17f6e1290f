#pragma once

#include <string>
#include <string_view>

namespace smile::fuzz {

/// What is wrong with how the studio takes these bytes from a browser, in words; empty when all is
/// well. After a first letter `H` they are the head of an HTTP request, else frames of a WebSocket.
///
/// Each refusal has a reason. No path leads out of the page, no message is larger than
/// allowed, and frames mean the same in whatever pieces they arrive.
std::string FaultWithPageInput(std::string_view bytes);

/// Why these bytes are refused; empty when they are not.
std::string ReasonAgainstPageInput(std::string_view bytes);

}  // namespace smile::fuzz
