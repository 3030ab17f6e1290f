#pragma once

#include <cstdint>
#include <string>

namespace smile::library {

/// Returns a time such as `2026-01-31T12:00:00Z` (ISO 8601, UTC).
/// @param nanoseconds  since 1970.
std::string UtcText(std::int64_t nanoseconds);

}  // namespace smile::library
