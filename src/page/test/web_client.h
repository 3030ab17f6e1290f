#pragma once

#include <string>

#include "base/json.h"
#include "web_server/test/web_client.h"

namespace smile::page {

/// The page's end of the studio's protocol.
class WebClient : public web_server::WebClient {
 public:
  using web_server::WebClient::WebClient;

  bool SendJson(const Json& json) const { return SendText(ToText(json)); }
  /// The next message of this kind; what comes before it is lost. Null at the end.
  Json Await(const std::string& kind) {
    while (const std::optional<Message> message = Next()) {
      if (message->opcode != 1) continue;
      Json json = Json::parse(message->payload);
      if (json["t"] == kind) return json;
    }
    return nullptr;
  }
  /// Asks and waits for the answer.
  Json Ask(Json request) {
    request["seq"] = ++seq_;
    SendJson(request);
    while (true) {
      Json reply = Await("reply");
      if (reply.is_null() || reply["seq"] == seq_) return reply;
    }
  }
  Json Hello() { return Ask({{"do", "hello"}, {"version", 1}}); }

 private:
  int seq_ = 0;
};

}  // namespace smile::page
