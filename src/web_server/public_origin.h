#pragma once

#include <string>

namespace smile::web_server {

/// Returns the origin of a URL that has no path: scheme, name and perhaps port, in lower case and
/// without `/` at the end.
/// @throws std::invalid_argument unless it is `http` or `https` with the name of a machine.
std::string OriginOf(const std::string& url);

}  // namespace smile::web_server
