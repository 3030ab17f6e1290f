#pragma once

#include <string>
#include <string_view>

namespace smile::fuzz {

/// What is wrong with how we take this text as JSON, in words; empty when all is well.
///
/// Invalid JSON is refused with a reason. A value comes back from its own text, on one line or
/// on many, the same.
std::string FaultWithJson(std::string_view text);

}  // namespace smile::fuzz
