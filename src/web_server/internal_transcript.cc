#include "web_server/internal_transcript.h"

#include <algorithm>
#include <boost/asio/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <chrono>
#include <memory>
#include <utility>

#include "web_server/internal_web_socket.h"

// A WebSocket without a network, for the fuzzer and for tests that cut the same bytes into pieces
// of any size: the result must not depend on the pieces.

namespace smile::web_server {
namespace {

/// Link in memory: reads a given text in pieces and records what is sent.
class MemoryLink : public Link {
 public:
  MemoryLink(net::io_context* context, std::string_view bytes, std::size_t piece_bytes,
             std::string* sent)
      : context_(context), bytes_(bytes), piece_bytes_(piece_bytes), sent_(sent) {}

  void Open(std::function<void(error_code)> completion) override {
    net::post(*context_, [completion = std::move(completion)] { completion(error_code()); });
  }
  void Read(net::mutable_buffer buffer, Completion completion) override {
    // The end of the bytes is the end of the connection.
    const std::size_t count = std::min({buffer.size(), piece_bytes_, bytes_.size()});
    net::buffer_copy(buffer, net::buffer(bytes_.data(), count));
    bytes_.remove_prefix(count);
    const error_code error = count == 0 ? net::error::eof : error_code();
    // Completed by the event loop, as by a real link, and not within this call.
    Complete(std::move(completion), error, count);
  }
  void Write(const Buffers& buffers, Completion completion) override {
    const std::size_t count = net::buffer_size(buffers);
    std::string bytes(count, 0);
    net::buffer_copy(net::buffer(bytes), buffers);
    sent_->append(bytes);
    Complete(std::move(completion), error_code(), count);
  }
  void Finish(std::function<void()> completion) override { net::post(*context_, completion); }
  void CancelRead() override {}
  void Close() override { bytes_ = {}; }

 private:
  void Complete(Completion completion, error_code error, std::size_t count) {
    net::post(*context_,
              [completion = std::move(completion), error, count] { completion(error, count); });
  }

  net::io_context* context_;
  std::string_view bytes_;
  std::size_t piece_bytes_;
  std::string* sent_;
};

/// Handler that records the messages of one WebSocket and sends nothing.
class Listener : public WebSocketHandler {
 public:
  bool Open(WebSocketId) override { return true; }
  void Receive(WebSocketId, bool, std::string_view message) override {
    messages_.emplace_back(message);
  }
  bool CanReceive(WebSocketId) override { return true; }
  void LimitExceeded(WebSocketId, const std::string&) override {}
  std::optional<OutgoingMessage> NextMessage(WebSocketId) override { return std::nullopt; }
  void Close(WebSocketId) override {}

  std::vector<std::string> TakeMessages() { return std::move(messages_); }

 private:
  std::vector<std::string> messages_;
};

/// Returns the request that turns an HTTP connection into a WebSocket. The key is the example of
/// RFC 6455.
BeastRequest UpgradeRequest() {
  BeastRequest request(boost::beast::http::verb::get, "/ws", 11);
  request.set("Host", "localhost");
  request.set("Upgrade", "websocket");
  request.set("Connection", "Upgrade");
  request.set("Sec-WebSocket-Version", "13");
  request.set("Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ==");
  return request;
}

/// Returns the code of the close frame at the end of the sent bytes; 0 without one.
int CloseCodeIn(std::string_view sent) {
  const auto byte = [sent](std::size_t at) { return static_cast<unsigned char>(sent[at]); };
  int code = 0;
  // The frames begin after the head of the reply to the upgrade.
  std::size_t at = sent.find("\r\n\r\n") + 4;
  // Frames to clients are short here (pongs and the close frame), so their length is one byte.
  for (; at + 2 <= sent.size(); at += 2 + byte(at + 1)) {
    // 0x88 is a final frame with opcode 8, close (RFC 6455, section 5.2).
    const bool has_code = byte(at) == 0x88 && byte(at + 1) >= 2;
    if (has_code) code = byte(at + 2) << 8 | byte(at + 3);
  }
  return code;
}

}  // namespace

Transcript ReadWebSocket(std::string_view bytes, std::size_t piece_bytes,
                         std::size_t max_message_bytes) {
  constexpr double kUnlimited = 1e12;
  // Everything runs in this thread, until no operation is pending.
  net::io_context context(1);
  Listener listener;
  Connections connections(1);
  WebServerOptions options;
  options.limits.message_bytes = max_message_bytes;
  options.limits.messages_per_second = kUnlimited;
  Services services{.context = &context,
                    .options = &options,
                    .handler = &listener,
                    .connections = &connections,
                    .resume_all = [] {}};
  std::string sent;
  Stream stream(&context, std::make_unique<MemoryLink>(&context, bytes, piece_bytes, &sent),
                std::chrono::seconds(1));
  const auto web_socket = std::make_shared<WebSocket>(std::move(stream), 1, &services);
  connections.Add(web_socket);
  web_socket->Start(UpgradeRequest());
  context.run();
  return {.messages = listener.TakeMessages(), .close_code = CloseCodeIn(sent)};
}

}  // namespace smile::web_server
