#pragma once

#include <string>
#include <string_view>

namespace smile::study {

/// Returns the SHA-256 of bytes as 64 hexadecimal digits, as `sha256sum` prints it. Source: NIST,
/// "Secure Hash Standard", FIPS 180-4 (2015), section 6.2.
std::string Sha256(std::string_view bytes);

}  // namespace smile::study
