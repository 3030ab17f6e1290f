#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "brain/internal_message_channel.h"
#include "process/wait_limit.h"

namespace smile::brain {

/// Address at which another program serves a brain.
struct ServerAddress {
  std::string text;        ///< as written
  std::string host, port;  ///< of `tcp://HOST:PORT`; empty for a Unix socket
  std::string path;        ///< of `unix:PATH`; else empty
};

/// Reads the address that a brain's name is; nullopt if it is a path.
/// @throws InputError if it begins like an address and is not one.
std::optional<ServerAddress> ParseServerAddress(const std::string& brain);

/// Connects to a server. A name of a host is looked up by the system, with the system's own
/// timeout.
/// @returns the channel; or kClosed with the reason, kTimedOut or kCancelled.
std::variant<MessageChannel, ChannelFault> ConnectTo(const ServerAddress& address,
                                                     const process::WaitLimit& limit);

}  // namespace smile::brain
