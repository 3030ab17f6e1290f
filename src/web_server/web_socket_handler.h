#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace smile::web_server {

/// Number of a WebSocket, from 1 up, in the order of connection.
using WebSocketId = int;

/// Reason for closing a WebSocket (RFC 6455, section 7.4.1).
enum class CloseCode : std::uint16_t {
  kNormal = 1000,
  kGoingAway = 1001,
  kUnsupported = 1003,
  kPolicyViolation = 1008,
};

/// Message to a client, or the end of its WebSocket.
struct OutgoingMessage {
  enum class Kind { kText, kBinary, kClose };
  Kind kind = Kind::kText;
  std::string head;                         ///< sent before the body
  std::shared_ptr<const std::string> body;  ///< may be shared by several clients
  CloseCode code = CloseCode::kNormal;      ///< of kClose; the body is its reason
};

/// Handler of all WebSockets in the program. A server calls one function at a time, all from the
/// same thread; none may wait. Calls for one WebSocket come in this order: Open, any others, Close.
/// After Receive and Close, all WebSockets are asked for their next messages.
class WebSocketHandler {
 public:
  virtual ~WebSocketHandler() = default;

  /// Called when a client requests a WebSocket. Returns false to refuse it (503).
  virtual bool Open(WebSocketId id) = 0;
  /// Called when a message has arrived; text is valid UTF-8.
  virtual void Receive(WebSocketId id, bool is_text, std::string_view message) = 0;
  /// Returns false while no more messages are to be read; see WebServer::Resume().
  virtual bool CanReceive(WebSocketId id) = 0;
  /// Called when the client has exceeded the limit that `reason` names. The handler is expected to
  /// close.
  virtual void LimitExceeded(WebSocketId id, const std::string& reason) = 0;
  /// Returns the next message to be sent; nullopt if nothing is to be sent. Called once the message
  /// before has been sent; not called again after a message of kClose.
  virtual std::optional<OutgoingMessage> NextMessage(WebSocketId id) = 0;
  /// Called when the WebSocket has ended, by either side.
  virtual void Close(WebSocketId id) = 0;
};

}  // namespace smile::web_server
