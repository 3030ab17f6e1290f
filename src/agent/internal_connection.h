#pragma once

#include <optional>
#include <span>
#include <string>

#include "wire/inbox.h"
#include "wire/wire.h"

namespace smile::agent {

/// The socket to the simulator. Waits as long as it takes: time is the simulator's business.
class Connection {
 public:
  /// @throws std::runtime_error naming the address and the reason.
  explicit Connection(const std::string& address);
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  /// @throws std::runtime_error when the simulator has gone.
  void Send(std::span<const std::byte> frame);
  /// The next message; nullopt when the simulator has gone.
  /// @throws std::runtime_error when what arrives is no message.
  std::optional<wire::Message> Receive();

 private:
  int socket_ = -1;
  wire::Inbox inbox_;
};

}  // namespace smile::agent
