#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"
#include "web_server/web_socket_handler.h"

namespace smile::study {

/// A message from a page; null when the page is gone.
struct PageMessage {
  web_server::WebSocketId page = 0;
  Json content;
};

/// Mailbox between the threads of the web server and that of the study: queues in both directions.
class Mailbox : public web_server::WebSocketHandler {
 public:
  bool Open(web_server::WebSocketId id) override;
  void Receive(web_server::WebSocketId id, bool is_text, std::string_view message) override;
  bool CanReceive(web_server::WebSocketId id) override;
  void LimitExceeded(web_server::WebSocketId id, const std::string& reason) override;
  std::optional<web_server::OutgoingMessage> NextMessage(web_server::WebSocketId id) override;
  void Close(web_server::WebSocketId id) override;

  /// Returns the messages since the last call.
  std::vector<PageMessage> Take();
  /// Sends to a page, if it is still there. The web server has to be resumed afterwards.
  void Send(web_server::WebSocketId id, const Json& message);
  /// Closes a page's WebSocket after all that was sent.
  void CloseAfterAll(web_server::WebSocketId id, const std::string& reason);

 private:
  void Post(web_server::WebSocketId id, web_server::OutgoingMessage message);

  std::mutex mutex_;
  std::map<web_server::WebSocketId, std::deque<web_server::OutgoingMessage>> outgoing_;
  std::vector<PageMessage> incoming_;
};

}  // namespace smile::study
