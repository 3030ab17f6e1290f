#pragma once

#include <string>
#include <string_view>

namespace smile::studio {

/// What a server answers to the `Sec-WebSocket-Key` of a client, so that it knows a WebSocket was
/// understood (RFC 6455, section 4.2.2): the SHA-1 of the key and a fixed text, in base64.
std::string AcceptKeyOf(std::string_view key);

}  // namespace smile::studio
