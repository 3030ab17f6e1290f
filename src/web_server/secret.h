#pragma once

#include <string>
#include <string_view>

namespace smile::web_server {

/// Number of digits of RandomSecret().
inline constexpr std::size_t kSecretDigits = 32;

/// Returns 128 bits of the system's random source as 32 hexadecimal digits.
/// @throws std::runtime_error if the system has none.
std::string RandomSecret();

/// Returns true if a text is the secret. The time that it takes depends on their lengths only, so
/// it reveals nothing about matching digits.
bool IsSecret(std::string_view text, std::string_view secret);

}  // namespace smile::web_server
