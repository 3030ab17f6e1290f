#pragma once

#include <string>
#include <string_view>

namespace smile::web_server {

/// Returns the SHA-256 of bytes as 64 hexadecimal digits, as `sha256sum` prints it.
std::string Sha256(std::string_view bytes);

}  // namespace smile::web_server
