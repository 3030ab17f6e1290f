#pragma once

#include <array>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <string>

#include "web_server/internal_connection.h"
#include "web_server/internal_http.h"
#include "web_server/internal_rate_limit.h"
#include "web_server/internal_stream.h"

namespace smile::web_server {

/// WebSocket: reads messages piece by piece, within limits, and sends the messages of its handler.
class WebSocket : public ClientConnection, public std::enable_shared_from_this<WebSocket> {
 public:
  /// Requires that the handler has opened `id`.
  WebSocket(Stream stream, WebSocketId id, Services* services);

  /// Accepts the upgrade that `request` requests.
  void Start(const BeastRequest& request);
  void Abort() override;
  void Resume() override;

 private:
  void Read();
  void HandleRead(error_code error, std::size_t count);
  void TakeMessage();
  /// Counts bytes that are not payload: frame heads and control frames.
  void CountOverhead();
  void ExceedLimit();
  void Write(OutgoingMessage message);
  void Close(const OutgoingMessage& message);
  /// Waits for the other end to close the connection.
  void Linger();
  void NotifyHandlerOfEnd();
  void End() override;

  WebSocketId id_;
  Services* services_;
  boost::beast::websocket::stream<Stream, false> socket_;
  Deadline deadline_;

  std::array<char, 16384> piece_{};
  std::string message_;  ///< the part that has arrived
  std::uint64_t first_byte_, payload_bytes_ = 0, overhead_bytes_ = 0;
  std::uint64_t bytes_at_limit_ = 0;  ///< bytes read when a limit was exceeded
  RateLimit messages_, overhead_;
  OutgoingMessage outgoing_;  ///< being written
  bool is_open_ = false, is_reading_ = false, is_writing_ = false, is_closing_ = false;
  bool is_limit_exceeded_ = false, is_lingering_ = false;
  bool is_handler_notified_ = false;
};

}  // namespace smile::web_server
