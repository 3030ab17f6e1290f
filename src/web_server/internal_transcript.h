#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smile::web_server {

/// Effect of a client's bytes on a WebSocket.
struct Transcript {
  std::vector<std::string> messages;  ///< that were delivered
  int close_code = 0;                 ///< sent to the client; 0 if none was

  bool operator==(const Transcript&) const = default;
};

/// Runs a WebSocket whose client sends `bytes`, at most `piece_bytes` at a time, and then ends. For
/// tests and fuzzers: there is no network, and no limit but the size of messages.
Transcript ReadWebSocket(std::string_view bytes, std::size_t piece_bytes,
                         std::size_t max_message_bytes);

}  // namespace smile::web_server
