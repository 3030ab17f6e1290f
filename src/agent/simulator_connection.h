#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "wire/inbox.h"
#include "wire/wire.h"

namespace smile::agent {

/// The simulator has gone in the middle of a conversation.
struct SimulatorGone : std::runtime_error {
  SimulatorGone() : std::runtime_error("the simulator has gone") {}
};

/// What arrives is no message.
struct ProtocolError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A robot program as it introduces itself.
struct Introduction {
  std::string_view client;    ///< the language, for people
  std::string_view language;  ///< its version; may be empty
  bool has_guard = false;     ///< SIGUSR2 ends what takes too long, and ERROR tells its line
  bool takes_rows = false;    ///< pictures may come in row-major order
};

/// A robot program's end of the socket to the simulator: docs/brain-protocol.md.
///
/// The one core under the clients for C++, Python, and Octave or Matlab: hence it knows nothing but
/// bytes. Waits as long as it takes: time is the simulator's business.
class SimulatorConnection {
 public:
  struct Options {
    wire::Inbox::MakeRoom make_room = {};  ///< for each large body
    /// Called when a signal has come while it waits; what it throws ends the waiting.
    std::function<void()> on_signal = {};
  };

  /// @throws std::system_error naming the address and the reason.
  explicit SimulatorConnection(const std::string& address) : SimulatorConnection(address, {}) {}
  SimulatorConnection(const std::string& address, Options options);
  SimulatorConnection(const SimulatorConnection&) = delete;
  SimulatorConnection& operator=(const SimulatorConnection&) = delete;
  ~SimulatorConnection();

  /// @throws SimulatorGone
  void Greet(const Introduction& introduction);
  /// @throws SimulatorGone
  void Send(std::span<const std::byte> frame);

  /// Whether there is something to receive, be it the end; waits for so many milliseconds at most,
  /// and no longer than until a signal comes.
  bool HasArrivals(int milliseconds) const;
  /// The next message, which is gone with the next call; nullopt when the simulator has gone.
  /// @throws ProtocolError
  std::optional<wire::MessageView> Receive();

 private:
  Options options_;
  int socket_ = -1;
  wire::Inbox inbox_;
};

}  // namespace smile::agent
