#include "web_server/internal_web_socket.h"

#include <boost/beast/websocket/rfc6455.hpp>
#include <cmath>
#include <utility>

// At most one read and one write are pending. The ends of a WebSocket are: the client closes or
// violates the protocol (Beast answers, then Linger), the handler closes (Close, then Linger), or
// the network fails (Abort). Linger waits a moment until the other end has read the last message;
// End releases the connection. The handler is notified once, as early as possible.

namespace smile::web_server {
namespace {

namespace websocket = boost::beast::websocket;

/// Longest head of a frame from a client: two bytes, eight of length, four of mask.
constexpr double kMaxFrameHeadBytes = 14;

/// Maximal number of bytes that are read and dropped after a limit was exceeded, so that the client
/// receives the reason.
constexpr std::uint64_t kMaxDroppedBytes = 4 << 20;

std::chrono::steady_clock::time_point Now() { return std::chrono::steady_clock::now(); }

}  // namespace

WebSocket::WebSocket(Stream stream, WebSocketId id, Services* services)
    : id_(id),
      services_(services),
      socket_(std::move(stream)),
      deadline_(services->context),
      first_byte_(socket_.next_layer().bytes_read()),
      messages_(services->options->limits.messages_per_second, Now()),
      overhead_(kMaxFrameHeadBytes * services->options->limits.messages_per_second, Now()) {
  // Each message is one frame: Beast would split large ones into pieces of its buffer.
  socket_.auto_fragment(false);
  socket_.read_message_max(services->options->limits.message_bytes);
  // Beast handles pings, pongs and empty frames inside its own reads and reports none of them. The
  // hook below it is the only place that sees their bytes.
  socket_.next_layer().set_before_read([this] { CountOverhead(); });
}

void WebSocket::Start(const BeastRequest& request) {
  socket_.async_accept(request, [self = shared_from_this()](error_code error) {
    if (error) return self->End();
    self->is_open_ = true;
    self->Resume();
  });
}

void WebSocket::Abort() { socket_.next_layer().link().Close(); }

void WebSocket::Resume() {
  if (!is_open_ || is_closing_ || is_lingering_) return;
  // One write at a time; the handler is asked for the next message when it is complete.
  if (!is_writing_) {
    if (auto message = services_->handler->NextMessage(id_)) Write(std::move(*message));
  }
  // Flow control: while the handler cannot receive, nothing is read, and TCP slows the client down.
  if (!is_closing_ && !is_reading_ && services_->handler->CanReceive(id_)) Read();
}

void WebSocket::Read() {
  is_reading_ = true;
  socket_.async_read_some(net::buffer(piece_),
                          [self = shared_from_this()](error_code error, std::size_t count) {
                            self->HandleRead(error, count);
                          });
}

void WebSocket::HandleRead(error_code error, std::size_t count) {
  is_reading_ = false;
  // Beast has already answered violations of the protocol and closing by the other end.
  if (error) return Linger();
  if (is_closing_) return;
  EndOnFailure([this, count] {
    // Messages arrive in pieces of 16 kB, so an announced length reserves no memory.
    payload_bytes_ += count;
    message_.append(piece_.data(), count);
    if (socket_.is_message_done()) TakeMessage();
    Resume();
  });
}

void WebSocket::TakeMessage() {
  const std::string message = std::exchange(message_, {});
  if (is_limit_exceeded_) return;
  if (!messages_.Allow(1, Now())) return ExceedLimit();
  services_->handler->Receive(id_, socket_.got_text(), message);
  services_->resume_all();
}

void WebSocket::CountOverhead() {
  const std::uint64_t bytes_read = socket_.next_layer().bytes_read();
  if (is_limit_exceeded_) {
    if (bytes_read > bytes_at_limit_ + kMaxDroppedBytes) Abort();
    return;
  }
  // Everything that is not payload: a flood of tiny fragments or pings costs work without being a
  // message.
  const std::uint64_t overhead = bytes_read - first_byte_ - payload_bytes_ - overhead_bytes_;
  overhead_bytes_ += overhead;
  if (overhead_.Allow(static_cast<double>(overhead), Now())) return;
  // Called from within a read, which must complete before anything else happens.
  net::post(*services_->context, [self = shared_from_this()] {
    self->ExceedLimit();
    self->Resume();
  });
}

void WebSocket::ExceedLimit() {
  // Once only: the handler closes the WebSocket, and further messages are dropped.
  if (std::exchange(is_limit_exceeded_, true) || !is_open_ || is_lingering_) return;
  bytes_at_limit_ = socket_.next_layer().bytes_read();
  const double per_second = services_->options->limits.messages_per_second;
  services_->handler->LimitExceeded(
      id_, "more than " + std::to_string(std::lround(per_second)) + " requests a second");
}

void WebSocket::Write(OutgoingMessage message) {
  if (message.kind == OutgoingMessage::Kind::kClose) return Close(message);
  is_writing_ = true;
  outgoing_ = std::move(message);
  socket_.text(outgoing_.kind == OutgoingMessage::Kind::kText);
  const std::array<net::const_buffer, 2> buffers{net::buffer(outgoing_.head),
                                                 net::buffer(*outgoing_.body)};
  socket_.async_write(buffers, [self = shared_from_this()](error_code error, std::size_t) {
    self->is_writing_ = false;
    // If a write fails, the pending or next read fails as well and ends the connection.
    if (error) return self->Abort();
    self->EndOnFailure([&self] { self->Resume(); });
  });
}

void WebSocket::Close(const OutgoingMessage& message) {
  is_closing_ = true;
  BeginIdle();
  deadline_.Set(kLastWordTimeout, [self = shared_from_this()] { self->Abort(); });
  // A close frame has at most 125 bytes, two of which are the code (RFC 6455, section 5.5).
  const websocket::close_reason reason(static_cast<websocket::close_code>(message.code),
                                       message.body->substr(0, 123));
  socket_.async_close(reason, [self = shared_from_this()](error_code) {
    // Otherwise the pending read fails now, and HandleRead() lingers.
    if (!self->is_reading_) self->Linger();
  });
}

void WebSocket::Linger() {
  if (std::exchange(is_lingering_, true)) return;
  NotifyHandlerOfEnd();
  BeginIdle();
  deadline_.Set(kLastWordTimeout, [self = shared_from_this()] { self->Abort(); });
  socket_.next_layer().link().Finish([self = shared_from_this()] { self->End(); });
}

void WebSocket::NotifyHandlerOfEnd() {
  if (std::exchange(is_handler_notified_, true)) return;
  services_->handler->Close(id_);
  services_->resume_all();
}

void WebSocket::End() {
  NotifyHandlerOfEnd();
  deadline_.Clear();
  Abort();
  services_->connections->Remove(this);
}

}  // namespace smile::web_server
