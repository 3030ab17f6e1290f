#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "wire/inbox.h"
#include "wire/wire.h"

namespace smile::brain_client {

/// The simulator closed the connection without a goodbye.
struct SimulatorGone : std::runtime_error {
  SimulatorGone() : std::runtime_error("the simulator has closed the connection") {}
};

/// Received bytes are not a message.
struct ProtocolError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a brain reports about itself in its first message.
struct Introduction {
  std::string_view client;    ///< the language, for people
  std::string_view language;  ///< its version; may be empty
  bool has_guard = false;     ///< SIGUSR2 ends a slow callback, and ERROR has its line
  bool takes_rows = false;    ///< pictures may come in row-major order
};

/// A brain's end of the socket to the simulator: docs/brain-protocol.md.
///
/// Shared core of the clients for C++, Python, and Octave or Matlab: it therefore handles bytes
/// only. It waits without a limit, since the simulator enforces timeouts.
class SimulatorConnection {
 public:
  struct Options {
    wire::Inbox::MakeRoom make_room = {};  ///< for each large body
    /// Called when a signal arrives during a wait; an exception from it ends the wait.
    std::function<void()> on_signal = {};
  };

  /// @throws std::system_error naming the address and the reason.
  explicit SimulatorConnection(const std::string& address) : SimulatorConnection(address, {}) {}
  SimulatorConnection(const std::string& address, Options options);
  /// Takes a connected stream socket of any kind, which it closes: one that a server accepted.
  SimulatorConnection(int connected_socket, Options options);
  SimulatorConnection(const SimulatorConnection&) = delete;
  SimulatorConnection& operator=(const SimulatorConnection&) = delete;
  ~SimulatorConnection();

  /// @throws SimulatorGone
  void Greet(const Introduction& introduction);
  /// @throws SimulatorGone
  void Send(std::span<const std::byte> frame);

  /// Returns true if a message or the end of the connection can be received. Waits up to
  /// `milliseconds`, or until a signal arrives.
  bool HasArrivals(int milliseconds) const;
  /// Returns the next message, valid until the next call; nullopt if the connection is closed.
  /// @throws ProtocolError
  std::optional<wire::MessageView> Receive();

 private:
  Options options_;
  int socket_ = -1;
  wire::Inbox inbox_;
};

}  // namespace smile::brain_client
